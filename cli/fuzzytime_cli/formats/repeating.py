"""Which skills of a plan come after a rule, as a calendar keeps it: without an end, or so many times.

A rule must give all that words say, as far as anybody looks: each of its times lies where one of the
occurrences may be, and each occurrence has one. What the plan put elsewhere is moved. Where no rule does so,
each skill is an event of its own.
"""

from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from itertools import pairwise
from zoneinfo import ZoneInfo

from fuzzytime.interpreter import Plan
from fuzzytime.interpreter.turns.waking_hours import on_their_days
from fuzzytime.requirement import Recurrence, TimeRequirement, Window
from fuzzytime.times import seconds_between
from fuzzytime_cli.formats.rules_of_series import Rule, rule_of
from fuzzytime_cli.formats.series import NEARLY_A_DAY

LOOKED_AT = 400
"""Occurrences of a repetition without an end that must follow a rule: more than a year of days."""

MOST = 5000
"""Occurrences of one with an end that a rule may have."""

MOST_A_DAY = 12
"""Rules at most for what comes several times a day."""

NEAR = 0.5
"""Seconds that two moments may be apart, and still are the same."""


@dataclass(frozen=True, slots=True)
class Series:
    """Skills that come after one rule.

    Parameters
    ----------
    first
        The first of its times on the wall clock; the others come after ``rule``, ``count`` times in all, or
        without an end where that is None.
    length
        Seconds that each takes.
    places
        The time that the rule gives to each skill, by its position.
    moved
        Those of them that the plan has at another time, or that take longer or shorter.
    like
        The position of the skill that tells what is done.
    """

    first: datetime
    rule: Rule
    count: int | None
    length: float
    places: dict[int, datetime]
    moved: frozenset[int]
    like: int


@dataclass(frozen=True, slots=True)
class _Turn:
    """One occurrence as words say it, in seconds from now, and the skill that is in it, if one is planned."""

    window: Window
    position: int | None


def series_of(plan: Plan) -> list[Series]:
    """Give the series of a plan; a skill is in one of them at most."""
    found: defaultdict[tuple[str, int], list[int]] = defaultdict(list)
    for position, one in enumerate(plan.skills):
        # What "every monday except this monday" leaves out, no rule leaves out.
        if len(one.requirements) == 1 and one.repeats and one.requirements[0].anchor is None:
            found[one.wish.identifier, id(one.instruction)].append(position)
    return [series for positions in found.values() for series in _Repetition(plan, positions).series()]


def written(plan: Plan, time: float) -> datetime:
    """Give a time as a calendar repeats it: on the clock of the plan's zone, or of none, or in UTC."""
    whole = plan.instant(time).replace(microsecond=0)
    return whole if whole.tzinfo is None or isinstance(whole.tzinfo, ZoneInfo) else whole.astimezone(UTC)


class _Repetition:
    """What one instruction asks for again and again, as it is planned."""

    def __init__(self, plan: Plan, positions: Sequence[int]) -> None:
        self.plan, self.positions = plan, positions
        self.one = plan.skills[positions[0]]
        said = self.one.requirements[0].recurrence
        self.recurrence: Recurrence | None = said and said.spaced(self.one.duration.hands_on)

    def series(self) -> Iterator[Series]:
        """Give the series that it is: one, or one for each time of a day; none where no rule fits."""
        turns = [] if self.recurrence is None else self._turns(self.recurrence)
        often = any(_apart(one.window, after.window) < NEARLY_A_DAY for one, after in pairwise(turns))
        groups = self._of_each_time(turns) if often else [turns]
        if len(groups) > MOST_A_DAY or (often and self._endless and not self._round_the_clock(turns)):
            return
        yield from filter(None, map(self._after_a_rule, groups))

    @property
    def _endless(self) -> bool:
        return self.recurrence is not None and self.recurrence.endless

    def _turns(self, recurrence: Recurrence) -> list[_Turn]:
        """Give all occurrences from the first that is planned on; none where the plan leaves some out."""
        wish = self.one.wish
        since = seconds_between(self.plan.request.now, wish.given)
        since += 0.0 if wish.moved is None else wish.moved.by
        coming = on_their_days(recurrence.coming(LOOKED_AT if self._endless else MOST), wish.given)
        windows = [(begin + since, end + since) for begin, end in coming]
        planned: dict[int, int] = {}
        for position in self.positions:
            here = _window(self.plan.skills[position].requirements[0], since)
            inside = (number for number, window in enumerate(windows) if _is_inside(here, window))
            number = next((number for number in inside if number not in planned), None)
            if number is None:
                return []
            planned[number] = position
        first, last = min(planned), max(planned)
        if len(planned) < last - first + 1:
            return []
        return [_Turn(window, planned.get(n)) for n, window in enumerate(windows) if n >= first]

    def _of_each_time(self, turns: Sequence[_Turn]) -> list[list[_Turn]]:
        """Give those of each time of day apart; a stretch that has begun ends as the others do.

        Where clocks change, others follow that are not planned yet: a series keeps its hour.
        """
        groups: defaultdict[object, list[_Turn]] = defaultdict(list)
        for turn in turns:
            groups[self.plan.instant(turn.window[1]).time()].append(turn)
        return list(groups.values())

    def _round_the_clock(self, turns: Sequence[_Turn]) -> bool:
        """Whether it is planned for a day at least, and not only as long as people are up."""
        behind = [turn.window[0] for turn in turns if turn.position is None]
        return bool(behind) and behind[0] - turns[0].window[0] >= NEARLY_A_DAY

    def _after_a_rule(self, turns: Sequence[_Turn]) -> Series | None:
        """Give the series that occurrences are; None where no rule gives them."""
        placed = [turn for turn in turns if turn.position is not None and self.plan.has_time(turn.position)]
        lengths = Counter(self._planned(turn)[1] for turn in placed)
        for length, _ in lengths.most_common(1):
            for times in self._times(turns, placed):
                series = self._begun(turns, times, length)
                if series is not None:
                    return series
        return None

    def _begun(self, turns: Sequence[_Turn], times: Sequence[float | None], length: float) -> Series | None:
        """Give the series from the first occurrence on that is where it would have it.

        What is done sooner or later than the others, as what was asked for at once is, stands before it.
        """
        moved = [
            turn.position is not None
            and (not self.plan.has_time(turn.position) or not self._is_at(turn, time, length))
            for turn, time in zip(turns, times, strict=True)
        ]
        outside = [place for place, time in enumerate(times) if time is None]
        begin = max(outside, default=-1) + 1
        begin += next((n for n, other in enumerate(moved[begin:]) if not other), len(turns))
        wall = [written(self.plan, time) for time in times[begin:] if time is not None]
        rule = rule_of(wall) if len(wall) > 1 else None
        if rule is None:
            return None
        rest = zip(turns[begin:], wall, moved[begin:], strict=True)
        known = [(turn.position, time, other) for turn, time, other in rest if turn.position is not None]
        return Series(
            first=wall[0],
            rule=rule,
            count=None if self._endless else len(wall),
            length=length,
            places={position: time for position, time, _ in known},
            moved=frozenset(position for position, _, other in known if other),
            like=known[0][0] if known else self.positions[0],
        )

    def _times(self, turns: Sequence[_Turn], placed: Sequence[_Turn]) -> Iterator[list[float | None]]:
        """Give times that all occurrences may have as those have that are placed, the likeliest first.

        None where one would lie outside of what words say.
        """
        if all(begin == end for begin, end in (turn.window for turn in turns)):
            late = {self._planned(turn)[0] - turn.window[0] for turn in placed}
            # What one alone lost its time to may not come again.
            same = len(placed) > 1 and max(late) - min(late) < NEAR
            yield [turn.window[0] + (max(late) if same else 0.0) for turn in turns]
            return
        hours = [self._hour(turn.window, self._planned(turn)[0]) for turn in placed]
        for days, hour in sorted(dict.fromkeys(reversed(hours)), key=hours.count, reverse=True):
            yield [self._at_hour(turn.window, days, hour) for turn in turns]

    def _hour(self, window: Window, start: float) -> tuple[int, timedelta]:
        """Give how many days behind the begin of a stretch, and how long after midnight, a start is."""
        begin, there = self.plan.instant(window[0]), self.plan.instant(start).replace(microsecond=0)
        midnight = there.replace(hour=0, minute=0, second=0)
        return (there.date() - begin.date()).days, there.replace(tzinfo=None) - midnight.replace(tzinfo=None)

    def _at_hour(self, window: Window, days: int, hour: timedelta) -> float | None:
        """Give the start in a stretch that is so many days behind its begin, at a time of day."""
        day = self.plan.instant(window[0]).replace(hour=0, minute=0, second=0, microsecond=0)
        there = (day.replace(tzinfo=None) + timedelta(days=days) + hour).replace(tzinfo=day.tzinfo)
        start = seconds_between(self.plan.request.now, there)
        return start if _is_inside((start, start), window) else None

    def _planned(self, turn: _Turn) -> tuple[float, float]:
        """Give when what is placed begins, and how long it takes."""
        assert turn.position is not None  # noqa: S101 - what has no skill is not placed
        return planned_span(self.plan, turn.position)

    def _is_at(self, turn: _Turn, time: float | None, length: float) -> bool:
        start, lasts = self._planned(turn)
        return time is not None and abs(start - time) < 1.0 and abs(lasts - length) < 1.0


def planned_span(plan: Plan, position: int) -> tuple[float, float]:
    """Give when a skill begins that is planned, and for how long it stands in a calendar."""
    planned, happens = plan.schedule.skills[position], plan.skills[position].skill.happens
    return planned.start, (planned.done if happens else planned.worked_until) - planned.start


def _window(part: TimeRequirement, since: float) -> Window | None:
    """Give where an occurrence may be, in seconds from now."""
    return (
        None if part.earliest is None or part.latest is None else (part.earliest + since, part.latest + since)
    )


def _apart(one: Window, after: Window) -> float:
    """Give how far two occurrences are apart; the first may have begun before now, the last be cut short."""
    return max(after[0] - one[0], after[1] - one[1])


def _is_inside(inner: Window | None, outer: Window) -> bool:
    return inner is not None and outer[0] - NEAR <= inner[0] and inner[1] <= outer[1] + NEAR
