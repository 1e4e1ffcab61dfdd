"""Stretches of time that words name, and what is planned within them."""

from datetime import datetime, timedelta
from datetime import time as clock_time

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import find_times
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.times import instant_after
from fuzzytime_cli.repl.naming import starts_of_entry
from fuzzytime_cli.repl.scene import Scene, waiting
from fuzzytime_cli.session import Entry

CLOCKED = frozenset({Unit.HOUR, Unit.MINUTE, Unit.SECOND})
"""The grains of clock times."""

MORNING = clock_time(4)
"""When a day is over for those who are still up."""


def time_of(scene: Scene, words: str) -> TimeRequirement:
    """Read a time.

    Raises
    ------
    FuzzytimeError
        If it is none.
    """
    found = find_times(words, scene.now, scene.lexicon).requirements
    if not found:
        raise FuzzytimeError(f"{words!r} is no time")
    return found[0]


def bounds_of(scene: Scene, time: TimeRequirement) -> tuple[datetime | None, datetime | None]:
    """Give from when to when a time is, as instants; None where a side is open."""
    begin = None if time.constraint is Constraint.BEFORE else time.t_spec
    sides = (begin if time.earliest is None else time.earliest, time.latest)
    first, end = (None if side is None else instant_after(scene.now, side) for side in sides)
    return first, end


def on_its_day(scene: Scene, words: str) -> tuple[datetime | None, datetime | None]:
    """Give from when to when a stretch is: what comes after an hour or a meal ends with its day."""
    time = time_of(scene, words)
    first, end = bounds_of(scene, time)
    if first is None or end is not None or time.grain not in CLOCKED | {None}:
        return first, end
    return first, datetime.combine(first.date() + timedelta(days=1), MORNING, first.tzinfo)


def is_within(scene: Scene, entry: Entry, time: str) -> bool:
    """Whether all that is left to do of an entry is planned within a stretch of time."""
    first, end = on_its_day(scene, time)
    starts = starts_of_entry(scene, entry)
    within = [(first is None or first <= at) and (end is None or at < end) for at in starts]
    repeated = any(one.repeats for _, one in waiting(scene, entry.number))
    if any(within) and not all(within) and not repeated:
        raise FuzzytimeError(f"only some of {entry.text!r} is {time}: say which, such as: the call")
    return all(within) and bool(starts)
