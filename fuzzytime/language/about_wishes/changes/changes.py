"""Orders that are about wishes: "cancel the call", "push everything back by ten minutes", "swap the two"."""

import re
from dataclasses import replace

from fuzzytime.language.about_wishes.about import AT_FIRST, AT_ONCE, About, AboutKind
from fuzzytime.language.about_wishes.changes.every import every, every_shifted
from fuzzytime.language.about_wishes.changes.exceptions import cleared, exception, kept_free
from fuzzytime.language.about_wishes.changes.moves import delayed, moved
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.lengths import DIRECTIONS, days_on, later_by
from fuzzytime.language.about_wishes.meant import about_thing, is_last, named_in
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.turns import several_in, turned
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.requirement import Unit

SEVERAL = ("both", "everything")

TWO = 2
"""How many are swapped."""

OWNER = re.compile(r"(?<=\w)['\u2019]s\b")
"""What tells whose something is."""


def change(said: Said) -> About | None:
    """Read an order about wishes; None where it may be a wish itself."""
    return (
        _undone(said)
        or kept_free(said)
        or turned(said)
        or _swapped(said)
        or every_shifted(said)
        or cleared(said)
        or exception(said)
        or _dropped(said)
        or _ordered(said)
        or _corrected(said)
        or delayed(said)
        or moved(said)
    )


def _undone(said: Said) -> About | None:
    for kind, name in ((AboutKind.UNDO, "undoing"), (AboutKind.REDO, "redoing")):
        rest = said.after(name)
        if rest is not None and (is_last(rest) or any(map(rest.is_in, SEVERAL)) or rest.places or rest.label):
            # "Undo s3", which is "the last one"
            return About(kind=kind, both=not (is_last(rest) or rest.label), certain=True)
    form = longest_match(said.words, 0, {(first[0],) for first in said.table("undoing") if len(first) == 2})
    particle = {first[1] for first in said.table("undoing") if len(first) == 2}
    if form is not None and said.forms[-1] in particle and is_last(said.until(len(said.words) - 1).behind(1)):
        # "Take that back"
        return About(kind=AboutKind.UNDO, certain=True)
    return None


def _swapped(said: Said) -> About | None:
    rest = said.after("swapping")
    if rest is None:
        return None
    rest = rest.until(len(rest.words) - 1) if rest.forms[-1:] in said.table("behind swapping") else rest
    if not rest.words:
        return About(kind=AboutKind.SWAP, both=True, certain=True)
    both = about_thing(AboutKind.SWAP, rest)
    if both.both or len(both.places) == TWO:
        return both
    joint = next(
        (place for place, word in enumerate(rest.forms) if word in said.lexicon.closed.joints_of_swaps), 0
    )
    one, other = rest.until(joint), rest.behind(joint + 1)
    if not joint or not other.words:
        return None
    return About(kind=AboutKind.SWAP, names=named_in(one), others=named_in(other))


def _dropped(said: Said) -> About | None:
    rest = said.after("clearing")
    if rest is not None and (rest.is_in("everything") or (not rest.words and len(said.words) > 1)):
        return About(kind=AboutKind.DROP, everything=True, certain=True)
    if rest is not None and (rest.label or rest.places or rest.is_in("the next")):
        return about_thing(AboutKind.DROP, rest)
    if rest is not None and not rest.has_time and (owned := _appointment(rest)):
        return About(kind=AboutKind.DROP, names=owned)
    dropped = said.after("dropping") or rest
    if dropped is not None and (all_meant := every(AboutKind.DROP, dropped)) is not None:
        return all_meant
    if said.forms[:1] == ("leave",) and said.forms[-1:] == ("out",) and len(said.words) > 2:
        # "Leave the soup out"
        return about_thing(AboutKind.DROP, said.until(len(said.words) - 1).behind(1))
    rest = said.after("dropping")
    if rest is None:
        return None
    about = about_thing(AboutKind.DROP, rest)
    if about.certain:
        # "S1 and s2", "the second one", "both calls"
        return about
    if rest.has_time:
        # "Skip the gym at six", but "skip rope"
        let = Said(rest.parted()[0], said.now, said.lexicon) if said.opens_with("letting go") else None
        return about_thing(AboutKind.DROP, let) if let is not None and let.names else None
    if is_last(rest):
        return About(kind=AboutKind.DROP, certain=True)
    return replace(about, certain=said.opens_with("letting go") > 0) if rest.names else None


def _appointment(said: Said) -> frozenset[str]:
    """Give the words that name what is planned, and no thing: "Ann's call", "the meeting"; else none."""
    bare = Said(OWNER.sub("", said.text), said.now, said.lexicon)
    lexicon = said.lexicon
    timed = lexicon.happening | lexicon.events | lexicon.taken
    return bare.names if bare.forms[-1:] and bare.forms[-1] in timed else frozenset()


def _ordered(said: Said) -> About | None:
    """Read what is wished to come first, or beside another: "do the soup first", "do it after the call"."""
    if said.forms[:1] not in {("do",), ("make",)} or len(said.words) < 3:
        return None
    verb, who = said.forms[0], said.forms[1:2]
    if who in said.lexicon.questions["asked"] and who not in said.table("last"):
        # "Do I have the call today?"
        return None
    if verb == "make" and said.without("more")[1]:
        # "Make the lesson an hour longer"
        return None
    # "S3" is one word.
    for place in (n for n in range(2, len(said.words)) if not said.words[n].glued):
        thing, rest = said.until(place).behind(1), said.behind(place)
        if rest.is_in("first"):
            time = AT_FIRST if rest.forms == ("first",) else AT_ONCE
            return replace(about_thing(AboutKind.MOVE, thing), time=time)
        new = rest.without("instead")[0]
        undirected, directions = new.without(*DIRECTIONS)
        if new.words and not undirected.words and (is_last(thing) or (verb == "do" and thing.names)):
            # "Do it earlier": by how much is not said
            about = about_thing(AboutKind.DELAY, thing, certain=is_last(thing))
            return replace(about, earlier="earlier" in directions)
        if (later := later_by(new)) is not None and not later[1].words:
            about = about_thing(AboutKind.DELAY, thing)
            return replace(about, by=later[0].by, text=later[0].text, earlier=later[0].earlier)
        if verb == "make" and (is_last(thing) or new.as_time() == new.text):
            # "Make the bed at six", "make dinner for six"
            return None
        if days := days_on(new):
            return replace(about_thing(AboutKind.MOVE, thing), days=days)
        if (time := new.as_time()) and (thing.names or is_last(thing)):
            # Who has dishes to do, and says so again, may mean others.
            again = "" if new.words != rest.words else verb
            return replace(about_thing(AboutKind.MOVE, thing), time=time, text=again)
        beside = rest.beside()
        if beside is not None and beside[1].names:
            return replace(about_thing(AboutKind.MOVE, thing), time=beside[0], others=beside[1].names)
    return None


def _corrected(said: Said) -> About | None:
    place = opening_correction(said)
    rest = said.behind(place)
    if place and rest.forms[:1] and rest.forms[0] in said.lexicon.doing.keeping and is_last(rest.behind(1)):
        # "No wait, keep it"
        return About(kind=AboutKind.UNDO, text=rest.text, certain=True)
    if (shifted := _shifted(rest)) is not None:
        return replace(shifted, corrects=place > 0)
    proposed = rest.after("proposing")
    if proposed is not None and proposed.words and (about := _corrected(proposed)) is not None:
        return replace(about, corrects=True)
    proposed = (
        None if proposed is None else proposed.without_end(said.table("instead") | said.table("preferring"))
    )
    if proposed is not None and (time := proposed.as_time()):
        # "Let's say nine"
        bare = proposed.is_bare(time)
        return About(kind=AboutKind.MOVE, time=time, bare=bare, corrects=True, certain=True)
    if place == 0 or not rest.words:
        return None
    if rest.forms[:1] == ("every",) and (number := rest.behind(1).as_number()):
        # "No, every ten"
        time = f"every {number} {Unit.MINUTE}s"
        return About(kind=AboutKind.MOVE, time=time, number=number, corrects=True, certain=True)
    longer, more = rest.without("more")
    found = longer.length() or rest.length() if more else None
    if found is not None and not found.rest.without("more")[0].words:
        # "Make it ten minutes longer"
        return About(kind=AboutKind.MORE, by=found.seconds, certain=True)
    number = rest.as_number()
    time = rest.as_time() or (f"for {number} {Unit.MINUTE}s" if number else "")
    if not time:
        return _beside_another(rest) or change(rest)
    bare = rest.is_bare(time)
    # "Make it six" is of what was spoken of last, and "no, six" of what was said last.
    anew = said.opens_with("naming anew") == place
    return About(kind=AboutKind.MOVE, time=time, number=number, bare=bare, corrects=not anew, certain=True)


def _shifted(said: Said) -> About | None:
    """Read what is to be earlier or later, or on another day: "ten minutes later", "no, the day after"."""
    undirected, directions = said.without(*DIRECTIONS)
    if said.words and not undirected.words:
        # "Earlier, please": by how much is not said
        return About(kind=AboutKind.DELAY, earlier="earlier" in directions, certain=True)
    delayed = later_by(said)
    if delayed is not None and (about := _later(*delayed)) is not None:
        return about
    days = days_on(said)
    return About(kind=AboutKind.MOVE, days=days, certain=True) if days else None


def _beside_another(said: Said) -> About | None:
    """Read what is to be beside another thing instead: "no, before the balloons"."""
    beside = said.beside()
    if beside is None or not beside[1].names:
        return None
    return About(kind=AboutKind.MOVE, time=beside[0], others=beside[1].names, corrects=True, certain=True)


def _later(about: About, beside: Said) -> About | None:
    """Give what is later where nothing is named beside it but all, or both: "both an hour earlier"."""
    if not beside.words or is_last(beside):
        return replace(about, certain=True)
    if beside.is_in("both") or several_in(beside) is not None:
        return replace(about, names=several_in(beside) or frozenset(), both=True, certain=True)
    return None
