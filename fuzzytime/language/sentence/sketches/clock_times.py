"""What was said last: a clock time, which one without am or pm hardly precedes, and a day, to count from."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from fuzzytime.language.meaning.chosen_clocks import FOLLOWING
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.sentence.sketches.alternatives import SAID_WHEN
from fuzzytime.requirement import Constraint, TimeRequirement, Unit

A_DAY = 86400.0
A_WEEK = 7 * A_DAY
"""Seconds of a day and of a week; what is longer names no day."""


@dataclass(frozen=True, slots=True)
class LastSaid:
    """The clock time, and the day, that were said last, in seconds from now; None where none was."""

    clock: float | None = None
    day: float | None = None


NOTHING = LastSaid()


def last_said(requirements: Iterable[TimeRequirement], before: LastSaid) -> LastSaid:
    """Give the last clock time and day that are said; those of before where there are none."""
    for requirement in requirements:
        begin, latest = requirement.earliest, requirement.latest
        length = 0.0 if begin is None or latest is None else latest - begin
        if begin is not None and length <= A_WEEK and requirement.constraint in SAID_WHEN:
            # Of a weekend, its last day.
            named = requirement.grain in {*SUB_DAY, Unit.DAY} or length > A_DAY
            before = replace(before, day=begin + max(0.0, length - A_DAY)) if named else before
        if requirement.constraint in SAID_WHEN | {Constraint.BEFORE} and requirement.grain in SUB_DAY:
            if latest is not None and (begin is None or latest - begin > FOLLOWING.total_seconds()):
                # "Charge overnight and be ready at seven"
                begin = latest
            before = replace(before, clock=before.clock if begin is None else begin)
    return before
