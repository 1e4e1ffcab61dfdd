"""What one plan has otherwise than another: what moved, and what is news."""

from dataclasses import dataclass
from datetime import datetime

from fuzzytime.interpreter import Plan
from fuzzytime.times import seconds_between

NOTICEABLE = 20.0
"""Seconds by which a start must move for it to be said."""


@dataclass(frozen=True, slots=True)
class Move:
    """A skill whose planned start has moved, by instants; None where it was not, or is no longer, planned."""

    identifier: str
    name: str
    before: datetime | None
    after: datetime | None


def starts_of(made: Plan) -> dict[str, tuple[str, datetime]]:
    """Give each planned skill's name and start by its identifier; rejected ones have none."""
    return {
        interpreted.identifier: (interpreted.skill.name, made.instant(made.schedule.start_times[position]))
        for position, interpreted in enumerate(made.skills)
        if not made.schedule.rejected[position]
    }


def moves(before: Plan | None, after: Plan, started: set[str]) -> list[Move]:
    """Say which skills of both plans moved noticeably, and which lost or won their place."""
    if before is None:
        return []
    earlier, later = starts_of(before), starts_of(after)
    known = {interpreted.identifier for interpreted in before.everything}
    still = {interpreted.identifier for interpreted in after.everything}
    found = []
    for identifier in sorted(known & still - started, key=_by_number):
        old, new = earlier.get(identifier), later.get(identifier)
        if old is None and new is None:
            continue
        name = (new or old or ("", None))[0]
        first, second = old[1] if old else None, new[1] if new else None
        if first is None or second is None or abs(seconds_between(first, second)) >= NOTICEABLE:
            found.append(Move(identifier, name, first, second))
    return found


def news_of(before: Plan | None, after: Plan) -> frozenset[int]:
    """Give the places of what a plan has anew, elsewhere, satisfied more or less, or waiting."""
    if before is None:
        return frozenset(range(len(after.everything)))
    old, new = _satisfied(before), _satisfied(after)
    moved = {move.identifier for move in moves(before, after, set())}
    told = moved | {name for name in new if old.get(name) != new[name]} | (_waiting(after) - _waiting(before))
    return frozenset(place for place, one in enumerate(after.everything) if one.identifier in told)


def lengths_of(before: Plan | None, after: Plan) -> frozenset[int]:
    """Give the places of skills of a plan that another has not, or for which it takes another time."""
    known = (
        set() if before is None else {(one.identifier, one.skill.time_until_done) for one in before.skills}
    )
    return frozenset(
        place
        for place, one in enumerate(after.skills)
        if (one.identifier, one.skill.time_until_done) not in known
    )


def _waiting(plan: Plan) -> set[str]:
    """Give the identifiers of what waits for something that nobody has told."""
    return {one.identifier for one in plan.interpretation.waiting}


def _satisfied(plan: Plan) -> dict[str, float]:
    """Give how well each skill is satisfied, by its identifier, as it is shown."""
    satisfactions = zip(plan.skills, plan.schedule.satisfactions, strict=True)
    return {one.identifier: round(satisfaction, 2) for one, satisfaction in satisfactions}


def _by_number(identifier: str) -> tuple[int, str]:
    digits = identifier.lstrip("s").partition(".")[0]
    return (int(digits) if digits.isdecimal() else 0, identifier)
