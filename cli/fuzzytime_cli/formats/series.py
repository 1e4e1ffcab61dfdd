"""A plan as a person sees it: of many repetitions the first few, and times as fine as they need be."""

from collections import defaultdict
from collections.abc import Mapping

from fuzzytime.interpreter import Interpreted, Plan
from fuzzytime.requirement import asked_words
from fuzzytime.times import DAY, HOUR
from fuzzytime_cli.clock import Clock

SHOWN = 3
"""Occurrences of a repetition that are shown one by one."""
LEAST = 5
"""Further ones at least that stand in one row."""
AS_ASKED = 0.995
"""Satisfaction from which an occurrence is shown as 1.00."""

NEARLY_A_DAY = DAY - 2 * HOUR
"""What lies less apart comes several times a day, and what is planned for as long goes on at night.

Clocks may go forward in between.
"""

MINUTE = 60.0
COARSE = 15 * MINUTE
"""From which end of a plan on seconds are left out, but for what was said to take seconds."""


def folded(plan: Plan) -> Mapping[int, tuple[int, ...]]:
    """Give by the last occurrence that is shown those that stand in one row behind it, in their order.

    What satisfies less, or is rejected, is always shown.
    """
    series: defaultdict[tuple[str, str], list[int]] = defaultdict(list)
    schedule = plan.schedule
    for position in schedule.order:
        one = plan.skills[position]
        if one.repeats and not schedule.rejected[position] and schedule.satisfactions[position] >= AS_ASKED:
            series[one.wish.identifier, one.skill.name].append(position)
    return {
        positions[SHOWN - 1]: tuple(positions[SHOWN:])
        for positions in series.values()
        if len(positions) >= SHOWN + LEAST
    }


def shown(plan: Plan, rows: Mapping[int, tuple[int, ...]]) -> list[int]:
    """Give what is shown by itself, by starts: all but what is `folded` into rows."""
    hidden = {position for more in rows.values() for position in more}
    return [position for position in plan.schedule.order if position not in hidden]


def going_on(plan: Plan) -> Mapping[int, str]:
    """Give by the last occurrence that is planned how often it is done, of what goes on without an end.

    What ends when people go to bed does not go on.
    """
    planned: defaultdict[tuple[str, str], list[int]] = defaultdict(list)
    for position in plan.schedule.order:
        one = plan.skills[position]
        if _is_endless(one) and not plan.schedule.rejected[position]:
            planned[one.wish.identifier, one.skill.name].append(position)
    starts = plan.schedule.start_times
    found = {}
    for positions in planned.values():
        one = plan.skills[positions[-1]]
        repeated = [
            (part, part.recurrence.interval) for part in one.requirements if part.recurrence is not None
        ]
        often = any(interval is not None and interval < DAY for _, interval in repeated)
        # "Every day feed the cat, then walk the dog" says of the cat how often.
        itself = all(part.anchor is None for part, _ in repeated)
        if itself and (not often or starts[positions[-1]] - starts[positions[0]] >= NEARLY_A_DAY):
            found[positions[-1]] = asked_words(one.requirements)
    return found


def _is_endless(one: Interpreted) -> bool:
    """Whether it is done again and again, and no end of that is said."""
    endless = (part.recurrence is not None and part.recurrence.endless for part in one.requirements)
    return one.instruction is not None and any(endless)


def waiting(plan: Plan) -> range:
    """Give the positions, among everything, of what has no time yet."""
    return range(len(plan.skills), len(plan.everything))


def clock_of(plan: Plan) -> Clock:
    """Choose how finely times are shown: seconds are noise in a plan of more than some minutes."""
    rejected = plan.schedule.rejected
    planned = [skill for position, skill in enumerate(plan.schedule.skills) if not rejected[position]]
    times = [time for skill in planned for time in (skill.start, skill.done)]
    if max(times, default=0.0) < COARSE:
        return Clock.for_times(plan.request.now, times)
    return Clock.to_minutes(plan.request.now)


def clock_at(plan: Plan, position: int, clock: Clock) -> Clock:
    """Choose how finely the times of one skill are shown: to the second where words told seconds."""
    planned = plan.schedule.skills[position]
    lasts = planned.done - planned.start
    if plan.skills[position].duration.assumed or not 0 < lasts < MINUTE:
        return clock
    return Clock.for_times(plan.request.now, (planned.start, planned.done))
