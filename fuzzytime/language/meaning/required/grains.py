"""What a time names beside when it is: its finest unit, and the zone of its clock."""

from fuzzytime.language.meaning.expressions import Offset, Range, Time, Wall
from fuzzytime.requirement import Unit


def grain_of(wall: Wall) -> Unit:
    """Give the finest unit that it names: the hour, for a part of the day."""
    if wall.clock is not None:
        return wall.clock.grain
    return Unit.HOUR if wall.part is not None or wall.days is None else wall.days.grain


def zone_in(time: Time) -> str | None:
    """Give the zone of its clock, or that of the one that it counts from."""
    if isinstance(time, Wall):
        return time.zone
    if isinstance(time, Range):
        return zone_in(time.first) or zone_in(time.last)
    if isinstance(time, Offset) and time.anchor is not None:
        return zone_in(time.anchor)
    return None
