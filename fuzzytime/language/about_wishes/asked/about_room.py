"""Questions about room: "is there time for a nap?", "when is a free hour?", "how late can I start?"."""

from dataclasses import replace

from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.asked.about_the_plan import helping, named_by
from fuzzytime.language.about_wishes.lengths import one_alone
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.meaning.expressions import Edge
from fuzzytime.requirement import Constraint

BEFORE, AFTER, BETWEEN = "before", "after", "between"
"""How what there is room for is beside something else: ``joint`` of what is asked."""

NONE = frozenset[str]()
ROOM = About(kind=AboutKind.ROOM, certain=True)

OWNED = "'s "
"""What stands between a length and its thing, beside words: "an hour's swim", "an hour of yoga"."""


def asked_room(said: Said) -> About | None:
    """Read a question about where there is room, or how much; None where it is none."""
    return _leeway(said) or _apart(said) or _room(said)


def _leeway(said: Said) -> About | None:
    """Read how late something may start, or how early: "how late can I start the roast?"."""
    ending = said.without_end(said.table("at the latest"))
    asks = said.after("when") if ending != said else None
    rest = said.after("asking how late") or (None if asks is None or asks == said else ending.after("when"))
    early = said.after("asking how early") if rest is None else None
    rest = rest or early
    if rest is None:
        return None
    names = named_by(rest.without_end(said.table("at the latest"))) if rest.words else NONE
    return About(kind=AboutKind.LEEWAY, names=names, earlier=early is not None, certain=True)


def _apart(said: Said) -> About | None:
    """Read how long it is between two, or behind one: "how long between lunch and the call?"."""
    what = said.after("what")
    gap = what is not None and any((form,) in said.table("gaps") for form in what.forms)
    rest = said.after("lasting") or (what if gap else None)
    ways = enumerate(() if rest is None else [way_beside(rest, n) for n in range(len(rest.words))])
    place, way = next(((n, way) for n, way in ways if way in {BETWEEN, AFTER}), (0, None))
    if rest is None or way is None:
        return None
    beside = rest.behind(place + 1)
    names, others = ends_between(beside) if way == BETWEEN else (beside.names, NONE)
    told = rest.until(place).is_in("having left") or gap
    joint = next((n for n, form in enumerate(beside.forms) if (form,) in said.table("being")), 0)
    if way != BETWEEN and joint and place == 0:
        # "How long after lunch is the call?"
        names, others, way = beside.until(joint).names, beside.behind(joint + 1).names, BETWEEN
    if not names or (way == BETWEEN and not others) or (way != BETWEEN and not told):
        return None
    return About(
        kind=AboutKind.APART,
        names=names,
        others=others,
        joint=way,
        thing=rest.behind(place).text,
        certain=True,
    )


def _room(said: Said) -> About | None:
    """Read whether there is time for something, before a time or something else."""
    places = said.lexicon.questions["placing"]
    rest = (said.after("when") or (said.behind(1) if said.forms[:1] in places else said)).after("having time")
    may = (said.after("when") or Said("", said.now, said.lexicon)).after("may do") if rest is None else None
    if may is not None and any((form,) in said.table("one") for form in may.forms[1:]):
        # "When could I go for a forty minute run?"
        rest = may
    if rest is None or not rest.words:
        return None
    rest = rest.without_end(said.table("closing"))
    room = _beside_what(rest)
    if room is None:
        thing, time = ("", "") if rest.length() else rest.parted()
        room = replace(ROOM, thing=thing or rest.text, time=time, text=time)
    room = replace(room, upcoming=said.opens_with("when") > 0)
    return _with_length(room, said) if room.thing else None


def _with_length(room: About, said: Said) -> About:
    """Give how long the thing takes that there is to be room for, where that is said beside it."""
    owner, mark, owned = room.thing.replace("\u2019", "'").partition(OWNED)
    length = Said(owner, said.now, said.lexicon).length()
    if length is None or (mark and length.rest.words):
        return room
    thing = owned if mark else length.rest.without_end(said.table("length of")).text
    return replace(room, thing=thing, by=length.seconds)


def asked_gap(said: Said) -> About | None:
    """Read whether there is a gap, or when, perhaps of some length: "have I an hour free before lunch?"."""
    when = said.after("when") or said.after("what") or said.after("showing")
    place = next((n for n, word in enumerate(said.forms) if (word,) in said.table("gaps")), 0)
    if not place:
        return _length_left(said)
    if when is None and (said.forms[0] not in helping(said) or said.forms[place - 1] == "the"):
        return None
    asks = when or said
    room = _beside_what(asks)
    thing, time = asks.parted() if room is None and asks.length() is None else ("", "")
    room = replace(ROOM, thing=thing, time=time, text=time) if thing and time else room
    front = Said(asks.text if room is None else room.thing, said.now, said.lexicon).without("gaps")[0]
    length = front.length() or one_alone(front)
    small = ("speaker", "filling", "having left", "next of all", "length of")
    others = (front if length is None else length.rest).without(*small)[0]
    # "When's my break before lunch?" is of what is planned, and "give me a break for an hour" a wish.
    named = said.forms[place] in said.lexicon.taken and when is not None
    known = length is None or not said.opens_with("when")
    if others.names or (room is None and length is None) or (named and known):
        return None
    by = None if length is None else length.seconds
    return replace(room or ROOM, thing="", by=by, upcoming=when is not None)


def _length_left(said: Said) -> About | None:
    """Read whether there is so much time: "have I got half an hour before lunch?"."""
    having = said.after("having left") if said.forms[:1] and said.forms[0] in helping(said) else None
    if having is None or not having.words:
        return None
    room = _beside_what(having)
    front = having if room is None else Said(room.thing, said.now, said.lexicon)
    length = front.length()
    whole = length is not None and not length.rest.words
    return replace(room or ROOM, thing="", by=length.seconds) if length is not None and whole else None


def _beside_what(said: Said) -> About | None:
    """Read beside what there is to be room for a thing: "a walk before the call", "lunch at two"."""
    for place in range(len(said.words) - 1, 0, -1):
        way = way_beside(said, place)
        if way is None:
            continue
        behind, rest = said.behind(place), said.behind(place + 1)
        # "Before lunch" is before that which is planned, or else before noon.
        found = behind.one_time()
        time = "" if found is None or found.constraint is Constraint.FOR else behind.text
        names, others = ends_between(rest) if way == BETWEEN else (rest.names if way else NONE, NONE)
        if time or names:
            thing = said.until(place).text
            return replace(
                ROOM, thing=thing, text=behind.text, time=time, names=names, others=others, joint=way
            )
    return None


def way_beside(said: Said, place: int) -> str | None:
    """Give how a word puts something beside what stands behind it, empty for at the same time; or None."""
    closed, word = said.lexicon.closed, said.forms[place]
    if word in closed.prepositions_of_two_ends:
        return BETWEEN
    told = said.lexicon.preposition(word)
    if told is None or word not in closed.prepositions_of_time | closed.prepositions_of_points:
        return None
    if told.name in said.lexicon.deadlines:
        return BEFORE
    # What is "from" or "since" something may go on beside it.
    return AFTER if told.edge is Edge.END else "" if told.constraint is Constraint.AT else None


def ends_between(said: Said) -> tuple[frozenset[str], frozenset[str]]:
    """Give what names the one and the other that something is between: "lunch and the call"; or nothing."""
    joint = said.forms.index("and") if "and" in said.forms else 0
    ends = said.until(joint).names, said.behind(joint + 1).names
    return ends if joint and all(ends) else (NONE, NONE)
