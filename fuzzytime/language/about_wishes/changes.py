"""Orders that are about wishes: "cancel the call", "push everything back by ten minutes", "swap the two"."""

import re
from dataclasses import replace

from fuzzytime.language.about_wishes.about import AT_FIRST, AT_ONCE, About, AboutKind
from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.exceptions import cleared, exception
from fuzzytime.language.about_wishes.lengths import DIRECTIONS, REFERRED, days_on, later_by, minutes_alone
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.turns import all_but, several_in, turned
from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.sentence.trees.named import is_several
from fuzzytime.requirement import Unit

FIRST = "first"
FOR = "for"
EVERY = "every"

OWNER = re.compile(r"(?<=\w)['\u2019]s\b")
"""What tells whose something is."""

DOING = "do"
MAKING = "make"
LEAVE, OUT = "leave", "out"


def change(said: Said) -> About | None:
    """Read an order about wishes; None where it may be a wish itself."""
    return (
        _undone(said)
        or turned(said)
        or _swapped(said)
        or cleared(said)
        or exception(said)
        or _dropped(said)
        or _ordered(said)
        or _corrected(said)
        or _delayed(said)
        or _moved(said)
    )


def _undone(said: Said) -> About | None:
    for kind, name in ((AboutKind.UNDO, "undoing"), (AboutKind.REDO, "redoing")):
        rest = said.after(name)
        if rest is not None and _is_last(rest):
            return About(kind=kind, certain=True)
    form = longest_match(said.words, 0, {(first[0],) for first in said.table("undoing") if len(first) == 2})
    particle = {first[1] for first in said.table("undoing") if len(first) == 2}
    if (
        form is not None
        and said.forms[-1] in particle
        and _is_last(said.until(len(said.words) - 1).behind(1))
    ):
        # "Take that back"
        return About(kind=AboutKind.UNDO, certain=True)
    return None


def _is_last(said: Said) -> bool:
    """Whether nothing is named but what was said last."""
    return not said.words or said.is_in("last")


def _swapped(said: Said) -> About | None:
    rest = said.after("swapping")
    if rest is None:
        return None
    rest = rest.until(len(rest.words) - 1) if rest.forms[-1:] in said.table("behind swapping") else rest
    if not rest.words or rest.is_in("both"):
        return About(kind=AboutKind.SWAP, both=True, certain=True)
    if (both := several_in(rest)) is not None:
        return About(kind=AboutKind.SWAP, names=both, both=True, certain=True)
    joint = next(
        (place for place, word in enumerate(rest.forms) if word in said.lexicon.closed.joints_of_swaps), 0
    )
    one, other = rest.until(joint), rest.behind(joint + 1)
    if not joint or not other.words:
        return None
    return About(kind=AboutKind.SWAP, names=_named(one), others=_named(other))


def _named(said: Said) -> frozenset[str]:
    if said.is_in("last") or said.places:
        return frozenset()
    return frozenset({said.label}) if said.label else said.names


def _about(kind: AboutKind, thing: Said, *, certain: bool = False) -> About:
    """Give what is said of a thing that was asked for, or of several."""
    if thing.is_in("both"):
        return About(kind=kind, both=True, certain=True)
    if (both := several_in(thing)) is not None:
        return About(kind=kind, names=both, both=True, certain=True)
    if thing.is_in("other"):
        return About(kind=kind, other=True, certain=True)
    if thing.is_in("the next"):
        return About(kind=kind, upcoming=True, certain=True)
    counted = () if thing.is_in("last") else thing.places
    names = _named(thing)
    several = bool(names) and not thing.label and is_several(thing.text, thing.lexicon)
    certain = certain or bool(counted or thing.label)
    return About(kind=kind, names=names, places=counted, several=several, certain=certain)


def _dropped(said: Said) -> About | None:
    rest = said.after("clearing")
    if rest is not None and (rest.is_in("everything") or (not rest.words and len(said.words) > 1)):
        return About(kind=AboutKind.DROP, everything=True, certain=True)
    if rest is not None and (rest.label or rest.places or rest.is_in("the next")):
        return _about(AboutKind.DROP, rest)
    if rest is not None and not rest.has_time and (owned := _appointment(rest)):
        return About(kind=AboutKind.DROP, names=owned)
    dropped = said.after("dropping") or rest
    if dropped is not None and (kept := all_but(dropped)) is not None:
        return About(kind=AboutKind.DROP, names=_named(kept), everything=True, certain=True)
    if said.forms[:1] == (LEAVE,) and said.forms[-1:] == (OUT,) and len(said.words) > 2:
        # "Leave the soup out"
        return _about(AboutKind.DROP, said.until(len(said.words) - 1).behind(1))
    rest = said.after("dropping")
    if rest is not None and (
        rest.label
        or rest.places
        or several_in(rest) is not None
        or rest.is_in("other")
        or rest.is_in("the next")
    ):
        return _about(AboutKind.DROP, rest)
    if rest is None or rest.has_time:
        return None
    if rest.is_in("everything"):
        return About(kind=AboutKind.DROP, everything=True, certain=True)
    if rest.is_in("both"):
        return About(kind=AboutKind.DROP, both=True, certain=True)
    if _is_last(rest):
        return About(kind=AboutKind.DROP, certain=True)
    certain = said.opens_with("letting go") > 0
    return _about(AboutKind.DROP, rest, certain=certain) if rest.names else None


def _appointment(said: Said) -> frozenset[str]:
    """Give the words that name what is planned, and no thing: "Ann's call", "the meeting"; else none."""
    bare = Said(OWNER.sub("", said.text), said.now, said.lexicon)
    lexicon = said.lexicon
    timed = lexicon.happening | lexicon.events | lexicon.taken
    return bare.names if bare.forms[-1:] and bare.forms[-1] in timed else frozenset()


def _ordered(said: Said) -> About | None:
    """Read what is wished to come first, or beside another: "do the soup first", "do it after the call"."""
    if said.forms[:1] not in {(DOING,), (MAKING,)} or len(said.words) < 3:
        return None
    verb = said.forms[0]
    if verb == MAKING and said.without("more")[1]:
        # "Make the lesson an hour longer"
        return None
    for place in range(2, len(said.words)):
        thing, rest = said.until(place).behind(1), said.behind(place)
        if rest.is_in("first"):
            time = AT_FIRST if rest.forms == (FIRST,) else AT_ONCE
            return replace(_about(AboutKind.MOVE, thing), time=time)
        new = rest.without("instead")[0]
        if new.words and not new.without(*DIRECTIONS)[0].words and _is_last(thing):
            # "Do it earlier": by how much is not said
            return About(kind=AboutKind.DELAY, certain=True)
        if (later := later_by(new)) is not None and not later[1].words:
            about = _about(AboutKind.DELAY, thing)
            return replace(about, by=later[0].by, text=later[0].text, earlier=later[0].earlier)
        if verb == MAKING and (_is_last(thing) or new.as_time() == new.text):
            # "Make the bed at six", "make dinner for six"
            return None
        if days := days_on(new):
            return replace(_about(AboutKind.MOVE, thing), days=days)
        if (time := new.as_time()) and (thing.names or _is_last(thing)):
            # Who has dishes to do, and says so again, may mean others.
            again = "" if new.words != rest.words else verb
            return replace(_about(AboutKind.MOVE, thing), time=time, text=again)
        beside = rest.beside()
        if beside is not None and beside[1].names:
            return replace(_about(AboutKind.MOVE, thing), time=beside[0], others=beside[1].names)
    return None


def _corrected(said: Said) -> About | None:
    place = opening_correction(said)
    rest = said.behind(place)
    if place and rest.forms[:1] and rest.forms[0] in said.lexicon.doing.keeping and _is_last(rest.behind(1)):
        # "No wait, keep it"
        return About(kind=AboutKind.UNDO, text=rest.text, certain=True)
    if rest.words and not rest.without(*DIRECTIONS)[0].words:
        # "Earlier, please": by how much is not said
        earlier = "earlier" in rest.without(*DIRECTIONS)[1]
        return About(kind=AboutKind.DELAY, earlier=earlier, corrects=place > 0, certain=True)
    delayed = later_by(rest)
    if delayed is not None and (about := _later(*delayed)) is not None:
        # "Ten minutes later", "no, make it ten minutes earlier"
        return replace(about, corrects=place > 0)
    if days := days_on(rest):
        # "No, the day after"
        return About(kind=AboutKind.MOVE, days=days, corrects=place > 0, certain=True)
    proposed = rest.after("proposing")
    if proposed is not None and proposed.words and (about := _corrected(proposed)) is not None:
        return replace(about, corrects=True)
    if proposed is not None and (time := proposed.as_time()):
        # "Let's say nine"
        bare = proposed.is_bare(time)
        return About(kind=AboutKind.MOVE, time=time, bare=bare, corrects=True, certain=True)
    if place == 0 or not rest.words:
        return None
    thing, is_said, new = rest.text.rpartition(" is ")
    if is_said:
        # "Actually, the dentist is at half past four"
        time = Said(new, said.now, said.lexicon).as_time()
        names = Said(thing, said.now, said.lexicon).names
        return About(kind=AboutKind.MOVE, names=names, time=time) if time and names else None
    if rest.forms[:1] == (EVERY,) and (number := rest.behind(1).as_number()):
        # "No, every ten"
        time = f"{EVERY} {number} {Unit.MINUTE}s"
        return About(kind=AboutKind.MOVE, time=time, number=number, corrects=True, certain=True)
    longer, more = rest.without("more")
    if more and (found := longer.length()) is not None and not found.rest.words:
        # "Make it ten minutes longer"
        return About(kind=AboutKind.MORE, by=found.seconds, certain=True)
    number = rest.as_number()
    time = rest.as_time() or (f"for {number} {Unit.MINUTE}s" if number else "")
    if not time:
        return _beside_another(rest) or change(rest)
    bare = rest.is_bare(time)
    return About(kind=AboutKind.MOVE, time=time, number=number, bare=bare, corrects=True, certain=True)


def _beside_another(said: Said) -> About | None:
    """Read what is to be beside another thing instead: "no, before the balloons"."""
    beside = said.beside()
    if beside is None or not beside[1].names:
        return None
    return About(kind=AboutKind.MOVE, time=beside[0], others=beside[1].names, corrects=True, certain=True)


def _later(about: About, beside: Said) -> About | None:
    """Give what is later where nothing is named beside it but all, or both: "both an hour earlier"."""
    if not beside.words or _is_last(beside):
        return replace(about, certain=True)
    if beside.is_in("everything"):
        return replace(about, everything=True, certain=True)
    if beside.is_in("both") or several_in(beside) is not None:
        return replace(about, names=several_in(beside) or frozenset(), both=True, certain=True)
    return None


def _delayed(said: Said) -> About | None:
    """Read what is moved by a length, or only back or forward: "push the call back by ten minutes"."""
    delaying = said.after("delaying")
    rest = delaying if delaying is not None else said.behind(1)
    if delaying is None and said.forms[:1] and said.forms[0] not in said.lexicon.rescheduling:
        return None
    if delaying is not None and not rest.words:
        return About(kind=AboutKind.DELAY, certain=True)
    if (
        not rest.words
        or not rest.is_one
        or any(f" {joint}" in f" {rest.text.lower()}" for joint in said.towards)
    ):
        return None
    thing, directions = rest.without(*DIRECTIONS)
    found = thing.length() or minutes_alone(thing, directed=bool(directions))
    if found is None:
        if thing.has_time or (delaying is None and not directions):
            return None
    elif delaying is None and (
        found.joint == FOR or not (directions or said.forms[0] in said.lexicon.moving)
    ):
        # "Put the meat back for ten minutes"
        return None
    by = None if found is None else -found.seconds if "earlier" in directions else found.seconds
    moved = thing if found is None else found.rest
    named, referred = moved.without(*REFERRED)
    if moved.is_in("both"):
        return About(kind=AboutKind.DELAY, both=True, by=by, certain=True)
    if not named.names and not referred and (delaying is None or named.words):
        return None
    if "everything" in referred and not named.names:
        return About(kind=AboutKind.DELAY, everything=True, by=by, certain=True)
    # Who pushes a table back says no length of time.
    certain = delaying is not None or (found is not None and found.joint == "by")
    return replace(_about(AboutKind.DELAY, named, certain=certain), by=by)


def _moved(said: Said) -> About | None:
    wanted = said.after("wanted by")
    if wanted is not None and (time := wanted.as_time() if wanted.has_time else ""):
        # "I need it by three"
        return About(kind=AboutKind.MOVE, time=time, certain=True)
    delaying = said.after("delaying")
    if delaying is None and said.forms[:1] and said.forms[0] not in said.lexicon.rescheduling:
        return None
    behind = (delaying or said.behind(1)).text
    joint = next((to for to in said.towards if f" {to}" in f" {behind.lower()}"), "")
    if not joint:
        return _moved_at(said, behind) if delaying is not None else _moved_beside(said)
    place = f" {behind.lower()}".rfind(f" {joint}")
    thing = Said(behind[:place].rstrip(), said.now, said.lexicon)
    new = Said(behind[place:].strip(), said.now, said.lexicon)
    if not thing.words:
        return None
    if thing.is_in("everything") or thing.is_in("both"):
        return About(kind=AboutKind.MOVE, everything=True, certain=True)
    about = _about(AboutKind.MOVE, thing)
    if not (about.names or about.places or about.upcoming) and not _is_last(thing):
        return None
    if time := new.as_time():
        return replace(about, time=time, bare=new.is_bare(time))
    beside = Said(new.text[len(joint) :], said.now, said.lexicon).beside()
    return None if beside is None else replace(about, time=beside[0], others=beside[1].names)


def _moved_beside(said: Said) -> About | None:
    """Read what something is moved behind, or in front of: "move the call after the soup"."""
    if said.forms[0] not in said.lexicon.moving:
        return None
    for place in range(2, len(said.words)):
        thing, beside = said.until(place).behind(1), said.behind(place).beside()
        if beside is not None and thing.names and beside[1].names:
            return About(kind=AboutKind.MOVE, names=thing.names, time=beside[0], others=beside[1].names)
    return None


def _moved_at(said: Said, behind: str) -> About | None:
    """Read a new time that stands without a word between: "postpone the call tomorrow"."""
    found = find_times(behind, said.now, said.lexicon).requirements[-1:]
    if not found:
        return None
    first = found[0].span[0]
    thing = Said(behind[:first].rstrip(), said.now, said.lexicon)
    time = Said(behind[first:], said.now, said.lexicon).as_time()
    if not thing.words:
        # "Reschedule for friday"
        return About(kind=AboutKind.MOVE, time=time, certain=True) if time else None
    return replace(_about(AboutKind.MOVE, thing), time=time) if time else None
