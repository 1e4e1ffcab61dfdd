"""Zones of clock times: "3 pm PST", "8 GMT", "noon UTC-5", "9:40 local time"."""

from dataclasses import replace

from fuzzytime.language.english.at_times.stacks import iso
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.times_of_day import UNNAMED, Clock

grammar = Grammar()

GREENWICH = "+00:00"
"""The zone that others are counted from."""


def _east(zone: str, hours: int) -> str | None:
    """Give the zone some hours east of Greenwich; None where another is named."""
    return f"{hours:+03d}:00" if zone == GREENWICH and abs(hours) < 15 else None


@grammar.rule("zone", "<zone> + <integer>", weight=0.3)
def zone_ahead(zone: str, hours: Integer) -> str | None:
    """GMT+1."""
    return _east(zone, hours.value)


@grammar.rule("zone", "<zone> - <integer>", weight=0.3)
def zone_behind(zone: str, hours: Integer) -> str | None:
    """UTC-5."""
    return _east(zone, -hours.value)


@grammar.rule("zone", "<zone> + <hh:mm>", weight=0.5)
def zone_ahead_typed(zone: str, ahead: Typed) -> str | None:
    """UTC+05:30."""
    return _typed("+", ahead) if zone == GREENWICH else None


@grammar.rule("zone", "<zone> - <hh:mm>", weight=0.5)
def zone_behind_typed(zone: str, behind: Typed) -> str | None:
    """UTC-03:30."""
    return _typed("-", behind) if zone == GREENWICH else None


@grammar.rule("wall", "<wall> <zone>", "<wall> ( <zone> )", weight=0.1)
def with_zone(time: Wall, zone: str) -> Wall | None:
    """3pm PST, 8 GMT, 9 am (BST)."""
    if time.clock is None or time.zone is not None:
        return None
    return replace(time, zone=zone, clock=replace(time.clock, bare=False, pair=False))


@grammar.rule("wall", "<wall> + <hh:mm>|<integer>", weight=0.3)
def typed_ahead(time: Wall, ahead: Typed | Integer) -> Wall | None:
    """18:00+02:00, 18:00 +0200."""
    return with_zone(time, zone) if (zone := _typed("+", ahead)) is not None else None


@grammar.rule("wall", "<date> t <clock> - <hh:mm>|<integer>", weight=3.0)
def typed_behind(days: Calendar, clock: Clock, behind: Typed | Integer) -> Wall | None:
    """2026-03-05T14:30-05:00; but 14:30-17:00 is from then to then."""
    return with_zone(iso(days, clock), zone) if (zone := _typed("-", behind)) is not None else None


def _typed(sign: str, offset: Typed | Integer) -> str | None:
    """Give a zone by how far it is from Greenwich."""
    parts = offset.parts if isinstance(offset, Typed) else (offset.digits[:2], offset.digits[2:])
    return f"{sign}{parts[0]}:{parts[1]}" if [len(part) for part in parts] == [2, 2] else None


@grammar.rule("wall", "<wall> local|my|our|your time", "<wall> ( local|my|our|your time )", weight=0.3)
def with_own_zone(time: Wall) -> Wall | None:
    """9:40 local time: by the clocks that the time now is told by."""
    if time.clock is None or time.zone is not None:
        return None
    return replace(time, clock=replace(time.clock, bare=False, pair=False))


@grammar.rule("wall", "<wall> their|his|her time", "<wall> ( their|his|her time )", weight=0.3)
def with_zone_of_others(time: Wall) -> Wall | None:
    """9 am their time: by clocks of which it is not said where they are."""
    return with_zone(time, UNNAMED)
