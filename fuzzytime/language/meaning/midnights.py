"""Which midnight of a day is meant: where it begins, or where it is over."""

from datetime import timedelta

from fuzzytime.language.meaning.days.relations import Away
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.feasts import Feast
from fuzzytime.language.policy import Midnight, Policy

EVES = ("eve", "night")
"""How the names of feasts end whose midnight is where they are over."""


def over_at_midnight(wall: Wall, policy: Policy) -> timedelta:
    """Give how long after where its day begins the midnight of a day is: that day, or nothing."""
    if wall.clock is not None and wall.clock.ends_day:
        return timedelta(days=1)
    ends = wall.clock is not None and wall.clock.may_end_day
    return timedelta(days=ends and (is_eve(wall) or policy.midnight is Midnight.END))


def is_eve(wall: Wall) -> bool:
    """Whether it names an eve or a night, whose midnight is where it is over: "midnight on Christmas Eve"."""
    days = wall.days
    named = isinstance(days, Feast) and days.name.endswith(EVES)
    before = isinstance(days, Away) and days.count == -1 and isinstance(days.anchor, Feast)
    return named or before or (wall.part is not None and wall.part.half.is_late)
