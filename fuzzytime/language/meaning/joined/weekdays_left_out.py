"""Weekdays that a repetition leaves out: "every day at nine, except sundays"."""

from collections.abc import Collection
from dataclasses import replace

from fuzzytime.language.meaning.calendar import Cycle, Fields, Weekend
from fuzzytime.language.meaning.expressions import Duration, Repeat, Time, Wall
from fuzzytime.requirement import Unit

WEEKEND = frozenset({5, 6})
"""Saturday and Sunday."""


def without_weekdays(repeat: Repeat, left_out: Collection[int]) -> Repeat | None:
    """Give a repetition on its other weekdays (0 for Monday); None where it leaves none out, or has none."""
    if [wall.days for wall in repeat.walls] == [Cycle(Unit.DAY)] and repeat.skip == 1:
        walls = tuple(replace(repeat.walls[0], days=Fields(weekday=day)) for day in range(7))
    else:
        walls = repeat.walls
    kept = tuple(
        wall for wall in walls if isinstance(wall.days, Fields) and wall.days.weekday not in {None, *left_out}
    )
    return replace(repeat, every=None, walls=kept) if kept and len(kept) < len(walls) else None


def weekdays_in(time: Time | Duration | Repeat) -> frozenset[int]:
    """Give the weekdays that a time names, each of them whole; none of any other time."""
    walls = time.walls if isinstance(time, Repeat) else (time,)
    found = [_weekdays_of(wall) for wall in walls]
    return frozenset().union(*found) if all(found) else frozenset()


def _weekdays_of(time: Time | Duration) -> frozenset[int]:
    if not isinstance(time, Wall) or time.clock is not None or time.part is not None:
        return frozenset()
    days = time.days
    if isinstance(days, Weekend) and not days.working:
        return WEEKEND
    if not isinstance(days, Fields) or not days.weekly or days.weekday is None:
        return frozenset()
    return frozenset({days.weekday})
