"""The satisfaction of a whole plan in words: a product that may be too small for a number."""

import math

from fuzzytime.scheduling import Alternative, Schedule
from fuzzytime.scheduling.schedule import TINY

SHOWN = 0.005
"""Satisfactions are shown with two digits: a smaller difference is none."""


def whole(satisfaction: float, *, fails: bool = False) -> str:
    """Write the satisfaction of a whole plan, a product that may be too small for a number; 0 where it fails.

    >>> whole(0.8333), whole(1.0), whole(1e-6), whole(0.0), whole(0.0, fails=True)
    ('0.833', '1', 'below 0.0001', 'below 0.0001', '0')
    """
    if fails:
        return "0"
    return f"{satisfaction:.3g}" if satisfaction >= 1e-4 else "below 0.0001"


def how_near(schedule: Schedule) -> str:
    """Say how near the average satisfaction is proved to be to the best possible one."""
    certificate = schedule.certificate
    if certificate.gap <= 1:
        return f"the average is within {certificate.gap:.2%} of the best possible"
    weight = math.fsum(skill.priority for skill in schedule.task.skills)
    return f"no schedule has an average above {math.exp(-max(certificate.lower_cost, 0.0) / weight):.2f}"


def is_same(schedule: Schedule, other: Alternative) -> bool:
    """Tell whether two schedules are as good as a whole, as far as is shown."""
    return abs(_cost(other, schedule) - schedule.cost) < SHOWN


def _cost(other: Schedule | Alternative, schedule: Schedule) -> float:
    """Give −log of a product of satisfactions, which does not underflow."""
    floor = schedule.threshold or TINY
    return -math.fsum(math.log(max(satisfaction, floor)) for satisfaction in other.satisfactions)


def product_of(other: Schedule | Alternative, schedule: Schedule) -> str:
    """Write a product of satisfactions, also one that is too small for a number."""
    if schedule.threshold == 0 and min(other.satisfactions) <= 0:
        return "0"
    exponent = -_cost(other, schedule) / math.log(10)
    if exponent > -300:
        return f"{10**exponent:.3g}"
    power = math.floor(exponent)
    return f"{10 ** (exponent - power):.3g}e{power}"
