"""What is told of a thing that was asked for: "the gym is off", "lunch is at one", "it takes longer"."""

import re
from dataclasses import replace

from fuzzytime.english import EMPTY
from fuzzytime.language.about_wishes.about import About, AboutKind
from fuzzytime.language.about_wishes.lengths import DIRECTIONS
from fuzzytime.language.about_wishes.said import CLOCKED, FOR, Said
from fuzzytime.language.about_wishes.told.awaited import written_out
from fuzzytime.language.finding import one_time
from fuzzytime.requirement import Constraint

SMALL = ("being", "anew")
"""Tables of what may stand beside how a thing is, and says nothing."""

SOONER = frozenset({"early", "earlier"})
HAS_BEEN = re.compile(r"\b(has|have)( \w+)? been\b")
TO, BE = ("to",), ("be",)
DONE = "ed"
"""How what was done ends: "gym cancelled"."""


def told_of(said: Said) -> About | None:
    """Read how a thing is, or when it is; None where nothing is told of one.

    Of what names no wish itself it may be what happens besides: "lunch is at one".
    """
    who, how = _thing_and_state(Said(HAS_BEEN.sub(r"is\2", written_out(said.text)), said.now, said.lexicon))
    # "The truck's late, about 20 minutes"
    how = replace(how, text=how.text.replace(",", ""))
    last = who.is_in("last")
    # "Serve the rice after the soup is done", "the six o'clock is off"
    bounded = any((form,) in said.lexicon.clauses for form in who.forms) or (who.has_time and not who.label)
    unnamed = not (last or who.meant) or who.is_in("both")
    if not who.is_one or not who.words or not how.words or bounded or unnamed:
        return None
    if is_over(how) and who.is_in("everything"):
        return About(kind=AboutKind.DROP, everything=True, certain=True)
    if is_over(how):
        # "Check that the soup is ready" is no report.
        named = len(who.words) == 1 or who.forms[0] in EMPTY or bool(who.label)
        names = frozenset[str]() if who.is_in("they") else who.meant
        return About(kind=AboutKind.DONE, names=names, certain=named)
    about = _off(how) or _longer(how) or _later(how) or _so_long(how) or _then(how, last=last)
    if about is None:
        return None
    certain = last or about.kind is AboutKind.MORE
    return replace(about, names=who.meant, thing=who.text, told=about.told and not last, certain=certain)


def is_over(state: Said) -> bool:
    """Whether words say that something is over: "done", "all finished now"."""
    left, tables = state.without("finished", "speaker")
    return "finished" in tables and not left.words


def _thing_and_state(said: Said) -> tuple[Said, Said]:
    """Give what something is told of, and how that is; nothing where none is."""
    stating = (
        said.lexicon.closed.third_person_be | {"will"} | {f"{verb}s" for verb in said.lexicon.doing.happening}
    )
    places = (n for n, word in enumerate(said.forms) if word in stating or _obliges(said.behind(n)))
    place = next(places, 0)
    off = said.ends_with("cancelled")
    if not place and off and (off > 1 or said.forms[-1].endswith(DONE)):
        return said.until(len(said.words) - off), said.behind(len(said.words) - off)
    return (said.until(place), said.behind(place + 1)) if place else (said.until(0), said.until(0))


def _obliges(said: Said) -> bool:
    """Whether words say how something has to be: "should be at six", "needs to be before lunch"."""
    obliges = said.forms[0] in said.lexicon.closed.obligation
    return obliges and BE in {said.forms[1:2], said.forms[2:3] if said.forms[1:2] == TO else ()}


def _off(how: Said) -> About | None:
    """Read that it is not to be: "is off", "has been cancelled today"."""
    left, tables = how.without("cancelled", *SMALL)
    if "cancelled" not in tables:
        return None
    if not left.words:
        return About(kind=AboutKind.DROP, told=True)
    time = left.text if left.one_time() is not None else ""
    return About(kind=AboutKind.EXCEPT, time=time, told=True) if time else None


def _longer(how: Said) -> About | None:
    """Read that it goes on for longer: "is taking an hour longer", "is going to need more time"."""
    left, tables = how.without("more", "needing", "lengths", "adding", *SMALL)
    if "lengths" not in tables and not {"more", "needing"} <= tables:
        return None
    # "Another hour"
    found = left.length() or how.length()
    rest = left if found is None else found.rest.without("more", "needing", "lengths", "adding", *SMALL)[0]
    known = not rest.words
    return About(kind=AboutKind.MORE, by=found.seconds if found else None, told=True) if known else None


def _later(how: Said) -> About | None:
    """Read that it is late, or early: "is running 20 minutes behind", "is delayed by an hour"."""
    left, tables = how.without("late", "early", *DIRECTIONS, *SMALL)
    found = left.length()
    # "The stall is up"
    known = tables - {*SMALL} if found else tables & {"late", "early"}
    time = left.as_time() if known and left.words and found is None else ""
    if time:
        # "They are late, more like noon"
        return About(kind=AboutKind.MOVE, time=time, told=True)
    if not known or (found.rest.words if found else left.words):
        return None
    earlier = not tables.isdisjoint(SOONER)
    by = None if found is None else -found.seconds if earlier else found.seconds
    return About(kind=AboutKind.DELAY, by=by, earlier=earlier, told=True)


def _so_long(how: Said) -> About | None:
    """Read how long it goes on: "is ninety minutes today", "is only half an hour"."""
    left, _ = how.without("being", "anew")
    day = left.behind(len(left.words) - 1).one_time()
    dated = day is not None and day.constraint is Constraint.BETWEEN
    time = (left.until(len(left.words) - 1) if dated else left).as_time()
    return About(kind=AboutKind.TAKES, time=time, told=True) if time.lower().startswith(FOR) else None


def _then(how: Said, *, last: bool) -> About | None:
    """Read when it is: "is at seven", "is on friday now"; but "it's friday" tells the day."""
    how, _ = how.without("being")
    how = how.behind(1) if how.forms[:1] == TO else how
    beside = None if last else how.beside()
    if beside is not None and beside[1].names and not how.has_time:
        return About(kind=AboutKind.MOVE, time=beside[0], others=beside[1].names, told=True)
    left, _ = how.without("anew", "rescheduled")
    left = left.behind(1) if left != how and left.forms[:1] == TO else left
    time = left.as_time() if left.words else ""
    told = one_time(time, how.now, how.lexicon) if time else None
    joint = told is not None and (told.preposition is not None or left.forms[0] == FOR.strip())
    # "The handover's ten past nine"
    bare = told is not None and not last and told.grain in CLOCKED and len(left.words) > 1
    if told is None or told.constraint is Constraint.FOR or not (joint or bare or left != how):
        return None
    if last and ("already" in how.forms or told.constraint is Constraint.AFTER):
        # "It's six already", "it's gone six" tell what time it is.
        return None
    if not bare and not left.text.lower().endswith(time.lower()) and left == how:
        return None
    # "Bob's at three now" may be of anything that is done with Bob.
    return About(kind=AboutKind.MOVE, time=time, bare=left.is_bare(time), corrects=last, told=left == how)
