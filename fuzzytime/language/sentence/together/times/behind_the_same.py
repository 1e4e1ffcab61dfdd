"""What is done next with the same thing is behind it: "mow the lawn on friday and rake it in the evening"."""

from dataclasses import replace
from datetime import datetime, timedelta

from fuzzytime.language.finding import Times, ground_all
from fuzzytime.language.instruction import Instruction, Operation
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.sentence.references.told import start_of
from fuzzytime.requirement import SAID_WHEN, Constraint, TimeRequirement
from fuzzytime.times import seconds_between

A_WEEK = timedelta(days=7).total_seconds()
"""Seconds within which what comes next is, at most."""


def behind_the_same(
    times: Times, phrases: tuple[Phrase, ...], text: str, here: Moment, before: Instruction, own: Operation
) -> Times:
    """Give times as they are meant behind what was done with the same thing on a day, or in a part of one.

    They are those that would be meant if they were said then.
    """
    first, begun = before.operation, start_of(before, here.now)
    same = own.again and first is not None and first.object == own.object and not (own.stated or first.stated)
    if here.now is None or begun is None or not same or not _is_of_day(before, begun, here.now):
        return times
    start = seconds_between(here.now, begun)
    if not times.found or not all(_is_before(one.requirement, start) for one in times.found):
        return times
    said_then = replace(
        here,
        now=begun,
        since=None,
        day=None,
        event=None,
        night=None,
        window=None,
        carried=False,
        listed=False,
    )
    later = ground_all(phrases, text, said_then)
    moved = tuple(replace(one, requirement=one.requirement.shifted(start)) for one in later.found)
    starts = [one.requirement.earliest for one in moved]
    near = all(time is not None and start <= time <= start + A_WEEK for time in starts)
    return replace(later, found=moved) if moved and near else times


def _is_of_day(before: Instruction, begun: datetime, now: datetime) -> bool:
    """Whether it is said on which day, or in which part of one, it has ``begun``; no clock time of today."""
    parted = any(part.constraint is Constraint.BETWEEN and not part.anchor for part in before.requirements)
    return parted or begun.date() > now.date()


def _is_before(required: TimeRequirement, start: float) -> bool:
    """Whether it is when something is done, and earlier than that."""
    sure = required.constraint in SAID_WHEN and required.anchor is None and required.recurrence is None
    return sure and required.earliest is not None and required.earliest < start
