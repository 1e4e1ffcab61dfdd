"""Durations and instants, read and printed at the edges; inside, times are seconds as floats.

Wall clocks are crossed in UTC, so that twelve hours are twelve hours on the night when clocks change.
"""

import math
import re
from datetime import UTC, datetime, time, timedelta, tzinfo
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from fuzzytime.errors import FuzzytimeError

SECOND = 1.0
MINUTE = 60.0
HOUR = 3600.0
DAY = 86400.0
WEEK = 7 * DAY

_UNIT_NAMES: dict[float, tuple[str, ...]] = {
    0.001: ("ms",),
    SECOND: ("s", "sec", "secs", "second", "seconds"),
    MINUTE: ("m", "min", "mins", "minute", "minutes"),
    HOUR: ("h", "hr", "hrs", "hour", "hours"),
    DAY: ("d", "day", "days"),
    WEEK: ("w", "week", "weeks"),
}
UNITS: dict[str, float] = {name: size for size, names in _UNIT_NAMES.items() for name in names}
"""Seconds in a unit, by every name that files and flags may use."""

_PART = re.compile(r"\s*(\d+(?:\.\d+)?|\.\d+)\s*([A-Za-z]+)?")
_CLOCK = re.compile(r"(\d{1,2}):(\d{2})(?::(\d{2}))?")


def seconds(number: float) -> float:
    """Give ``number`` seconds in seconds."""
    return number * SECOND


def minutes(number: float) -> float:
    """Give ``number`` minutes in seconds.

    >>> minutes(1.5)
    90.0
    """
    return number * MINUTE


def hours(number: float) -> float:
    """Give ``number`` hours in seconds."""
    return number * HOUR


def parse_duration(text: str) -> float:
    """Read a duration with its unit, such as ``90 s``, ``4min``, ``1h30`` or ``-2 min``, in seconds.

    Only zero may stand without a unit.

    Raises
    ------
    FuzzytimeError
        If the text is no duration.

    >>> parse_duration("1h30"), parse_duration("1 min 30 s"), parse_duration("-2 min")
    (5400.0, 90.0, -120.0)
    """
    bare = text.strip()
    sign, rest = (-1.0, bare[1:]) if bare.startswith("-") else (1.0, bare)
    total, smallest, at = 0.0, math.inf, 0
    while at < len(rest):
        part = _PART.match(rest, at)
        if part is None:
            raise FuzzytimeError(_not_a_duration(text))
        number, unit = float(part[1]), part[2]
        if unit is None:
            if number == 0 and rest.strip(" 0.") == "":
                return 0.0
            if smallest != HOUR or part.end() != len(rest):
                raise FuzzytimeError(_not_a_duration(text))
            size = MINUTE  # 1h30
        elif unit.lower() in UNITS:
            size = UNITS[unit.lower()]
        else:
            raise FuzzytimeError(
                f"a duration's unit must be one of ms, s, min, h, d, w, got {unit!r} in {text!r}"
            )
        if size >= smallest:
            raise FuzzytimeError(f"units of a duration must get smaller, got {text!r}")
        total, smallest, at = total + number * size, size, part.end()
    if smallest == math.inf or not math.isfinite(total):
        raise FuzzytimeError(_not_a_duration(text))
    return sign * total


def _not_a_duration(text: str) -> str:
    return f"a duration must be a number and a unit, such as '90 s' or '1h30', got {text!r}"


def format_duration(duration: float) -> str:
    """Print a duration in seconds as people write it.

    >>> format_duration(5400), format_duration(90), format_duration(0.25), format_duration(-120)
    ('1 h 30 min', '1 min 30 s', '0.25 s', '−2 min')
    """
    if not math.isfinite(duration):
        return "for ever" if duration > 0 else "since ever"
    sign, rest = ("−", -duration) if duration < 0 else ("", duration)
    if rest >= 10:
        rest = round(rest)
    if rest < MINUTE:
        return f"{sign}{rest:.4g} s"
    parts = []
    for name, size in (("d", DAY), ("h", HOUR), ("min", MINUTE), ("s", SECOND)):
        count, rest = divmod(rest, size)
        if count:
            parts.append(f"{count:.0f} {name}")
    return sign + " ".join(parts[:2])


def parse_zone(name: str) -> ZoneInfo:
    """Find a time zone by its IANA name.

    Raises
    ------
    FuzzytimeError
        If there is no such zone.
    """
    try:
        return ZoneInfo(name)
    except (ZoneInfoNotFoundError, ValueError, OSError) as error:
        raise FuzzytimeError(f"a zone must be an IANA name such as 'Europe/Berlin', got {name!r}") from error


def parse_instant(text: str, zone: tzinfo | None = None) -> datetime:
    """Read an ISO 8601 date and time, and give it in ``zone``, in which it is where it names no offset.

    Without a zone it is as it was said: with its offset, or with none.

    Raises
    ------
    FuzzytimeError
        If the text is no date and time, or none of the years 1 to 9999 in that zone.

    >>> print(parse_instant("2026-03-04T09:00Z", ZoneInfo("Asia/Tokyo")))
    2026-03-04 18:00:00+09:00
    """
    try:
        instant = datetime.fromisoformat(text.strip())
    except ValueError as error:
        raise FuzzytimeError(f"a date and time must look like 2026-03-04T09:00, got {text!r}") from error
    return in_zone(instant, zone)


def in_zone(instant: datetime, zone: tzinfo | None) -> datetime:
    """Give an instant in a zone, in which it is where it has none; without a zone, as it is.

    Raises
    ------
    FuzzytimeError
        If it lies outside the years 1 to 9999 there.
    """
    if zone is None:
        return instant
    if instant.tzinfo is None:
        return instant.replace(tzinfo=zone)
    try:
        return instant.astimezone(zone)
    except OverflowError as error:
        raise FuzzytimeError(f"an instant must lie in the years 1 to 9999, got {instant}") from error


def parse_clock(text: str) -> time:
    """Read a time of day such as ``09:30``.

    Raises
    ------
    FuzzytimeError
        If the text is no time of day.
    """
    match = _CLOCK.fullmatch(text.strip())
    try:
        hour, minute, second = (int(part or 0) for part in match.groups()) if match else (24, 0, 0)
        return time(hour, minute, second)
    except ValueError as error:
        raise FuzzytimeError(f"a time of day must look like 09:30, got {text!r}") from error


def hours_of_its_day(given: datetime, moment: float, first: float, last: float) -> tuple[float, float]:
    """Give some hours of the day on which a moment lies, in seconds from ``given``, as the moment is.

    ``first`` and ``last`` are on the clock of that day, in seconds. What is at midnight, or a second before
    it, is of the day behind it: figures round to it.

    >>> hours_of_its_day(datetime(2026, 3, 4, 9), DAY, 18 * HOUR, 20 * HOUR)
    (118800.0, 126000.0)
    """
    midnight = datetime.combine(instant_after(given, moment + SECOND).date(), time(), given.tzinfo)
    begin, end = (seconds_between(given, midnight + timedelta(seconds=clock)) for clock in (first, last))
    return begin, end


def instant_after(now: datetime, elapsed: float) -> datetime:
    """Give the wall-clock instant ``elapsed`` seconds after ``now``, in the zone of ``now``.

    Raises
    ------
    FuzzytimeError
        If the instant lies outside the years 1 to 9999.
    """
    try:
        if now.tzinfo is None:
            return now + timedelta(seconds=elapsed)
        return (now.astimezone(UTC) + timedelta(seconds=elapsed)).astimezone(now.tzinfo)
    except (OverflowError, ValueError) as error:
        raise FuzzytimeError(
            f"an instant must lie in the years 1 to 9999, got {elapsed!r} s from now"
        ) from error


def seconds_between(now: datetime, then: datetime) -> float:
    """Give the elapsed seconds from ``now`` to ``then``; a zone that one of them lacks is the other's."""
    if now.tzinfo is None and then.tzinfo is None:
        return (then - now).total_seconds()
    here = now if now.tzinfo is not None else now.replace(tzinfo=then.tzinfo)
    there = then if then.tzinfo is not None else then.replace(tzinfo=now.tzinfo)
    return (there.astimezone(UTC) - here.astimezone(UTC)).total_seconds()
