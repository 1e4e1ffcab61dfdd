"""Until when something goes on, or can be done: "practice ends at six", "the pool shuts at five"."""

from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.about_wishes.told.awaited import written_out
from fuzzytime.language.finding import one_time
from fuzzytime.requirement import Constraint

LONGEST_NAME = 6
"""Words that a place is called by at most."""

FROM, AT = "from ", "at "

DONE = "ed"
"""How what is done to something ends."""


def open_hours(clause: Said) -> tuple[Said, str] | None:
    """Give what can be used only at some hours, and the time that what is done there then has.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> told = Said("the pool is closed until three", datetime(2026, 3, 4, 9), shipped_lexicon())
    >>> place, bound = open_hours(told)
    >>> place.text, bound
    ('the pool', 'not before three')
    """
    said = Said.of(written_out(clause.text), clause.now, clause.lexicon).without_exclamations()
    if said.asks:
        return None
    for place in range(1, min(len(said.words) - 1, LONGEST_NAME + 1)):
        opens = _opens(said.behind(place))
        bound = "" if opens is None else _bound(*opens)
        if bound:
            return said.until(place).without_end(said.table("beside verbs")), bound
    return None


def _opens(said: Said) -> tuple[bool, Said] | None:
    """Give whether words say that it is open, or is opened, and their time; None where they say neither."""
    doing, being = said.lexicon.doing, said.forms[0] in said.lexicon.closed.third_person_be
    denied = said.opens_with("denied")
    state = said.behind(denied or being)
    while (small := state.opens_with("beside verbs")) and small < len(state.words):
        state = state.behind(small)
    denied = denied or state.opens_with("denied")
    state = state.behind(state.opens_with("denied"))
    if not state.words:
        return None
    stated = (being or denied) and max(state.opens_with(name) for name in ("at hand", "out of use"))
    if stated:
        there = state.opens_with("at hand") == stated
        return there is not (denied > 0), state.behind(stated)
    small = state.opens_with("helping")
    if being and small and state.behind(small).words and state.behind(small).forms[0].endswith(DONE):
        # "The oven is being serviced until two"
        return bool(denied), state.behind(small + 1)
    # "The library doesn't open until three"
    verb = state.forms[0] if denied or not being else ""
    if verb in doing.opening_up | doing.opening_there:
        return not denied, state.behind(1)
    return (False, state.behind(1)) if verb in doing.closing_up | doing.closing_there else None


def _bound(opens: bool, time: Said) -> str:  # noqa: FBT001 - both are what is told
    """Give the bound that follows from when something opens, or is open until."""
    joint = next((to for to in (*time.towards, FROM, AT) if time.text.lower().startswith(to)), "")
    clock = time.text[len(joint) :]
    # What is open until a time is so before it, and what shuts then is, too.
    before = opens is (joint in time.towards)
    bound = f"{'' if before else 'not '}before {clock}"
    read = one_time(bound, time.now, time.lexicon) if clock and time.has_time else None
    return bound if read is not None and (read.t_spec or read.latest) is not None else ""


def goes_on_until(clause: Said) -> tuple[Said, str] | None:
    """Give what is over at a time, and that: "ballet finishes at eleven", "the talk goes on till noon"."""
    said = Said.of(written_out(clause.text), clause.now, clause.lexicon).without_exclamations()
    ending = said.lexicon.doing.ending
    ends = ending | {f"{verb}s" for verb in ending} | {f"{verb}es" for verb in ending}
    if said.asks:
        return None
    for place in range(1, min(len(said.words) - 1, LONGEST_NAME + 1)):
        rest = _telling(said.behind(place))
        over = rest.forms[0] in ends
        time = rest.behind(1 if over else rest.opens_with("going on for"))
        until = any(time.text.lower().startswith(to) for to in time.towards)
        clock = time.as_time() if (over or until) and time.has_time else ""
        read = one_time(clock, time.now, time.lexicon) if clock else None
        if time != rest and read is not None and read.t_spec is not None:
            at = until or read.constraint is Constraint.AT
            return (said.until(place).without_end(said.table("beside verbs")), clock) if at else None
    return None


def _telling(said: Said) -> Said:
    """Leave out the verbs in front of how long something goes on: "only has to go on until two"."""
    while said.behind(said.opens_with("going on for")).one_time() is None:
        small = max(said.opens_with(name) for name in ("helping", "beside verbs", "wanting"))
        if not 0 < small < len(said.words):
            break
        said = said.behind(small)
    return said
