"""Busy times from an iCalendar file."""

from collections.abc import Mapping, Sequence
from datetime import date, datetime, time, timedelta
from pathlib import Path

from fuzzytime.errors import FuzzytimeError
from fuzzytime.skills import Busy
from fuzzytime.times import DAY, HOUR, MINUTE, seconds_between

MAX_BYTES = 4 << 20
MAX_OCCURRENCES = 500
AHEAD = 14 * DAY
"""How far ahead busy times are read at least, in seconds."""

STEPS = {"HOURLY": HOUR, "MINUTELY": MINUTE, "SECONDLY": 1.0}
"""Seconds between the occurrences of events that repeat more often than daily."""

_BROKEN = (
    ValueError,
    LookupError,
    TypeError,
    AttributeError,
    ArithmeticError,
    RecursionError,
    OSError,  # a zone's name is looked up as a file's
)
"""What the calendar's library raises where a file or an event is not as it should be."""


def busy_of_calendar(path: Path, now: datetime, ahead: float = AHEAD) -> tuple[Busy, ...]:
    """Give the busy times of a calendar file within the next two weeks, or longer, in seconds from now.

    Events that are cancelled or transparent (they do not block time) are left out; repeating ones come with
    each occurrence that was not deleted or moved; an all-day event blocks its days. A now without a zone is
    this machine's.

    Raises
    ------
    FuzzytimeError
        If the file is not there, too large, or no calendar.
    """
    import icalendar

    now = now if now.tzinfo is not None else now.astimezone()
    try:
        raw = path.read_bytes() if path.stat().st_size <= MAX_BYTES else b""
    except (OSError, ValueError) as error:
        raise FuzzytimeError(f"a calendar file must be readable, got {str(path)!r}") from error
    try:
        calendar = icalendar.Calendar.from_ical(raw)
    except _BROKEN as error:
        reason = f": {error}" if isinstance(error, ValueError) else ""  # others are of the library's inside
        raise FuzzytimeError(f"{path.name} must be an iCalendar file of at most 4 MB{reason}") from error
    busy: list[Busy] = []
    events = calendar.walk("VEVENT")
    moved = {(event.get("UID"), one) for event in events for one in _moments(event, "RECURRENCE-ID", now)}
    for event in events:
        if (
            str(event.get("STATUS", "")).upper() != "CANCELLED"
            and str(event.get("TRANSP", "")).upper() != "TRANSPARENT"
        ):
            try:
                series = "RECURRENCE-ID" not in event
                gone = {one for uid, one in moved if series and uid is not None and uid == event.get("UID")}
                busy += _busy_of(event, now, max(ahead, AHEAD), gone)
            except FuzzytimeError as error:
                raise FuzzytimeError(f"{path.name}: {error}") from error
    return tuple(sorted(busy, key=lambda taken: (taken.start, taken.end)))


def _busy_of(event: "object", now: datetime, ahead: float, moved: set[float]) -> list[Busy]:
    try:
        start = _instant(event.decoded("DTSTART"), now)  # type: ignore[attr-defined]
        length = _length(event, start, now)
        starts = _occurrences(event, start, length, now, ahead)
    except _BROKEN:
        return []  # an event without a usable time blocks none
    gone = moved | _moments(event, "EXDATE", now)
    what = str(event.get("SUMMARY", ""))  # type: ignore[attr-defined]
    found = []
    for first in sorted({*(seconds_between(now, begin) for begin in starts), *_moments(event, "RDATE", now)}):
        if first + length > 0 and first < ahead and first not in gone:
            found.append(Busy(first, first + length, what))
    return found


def _moments(event: "object", name: str, now: datetime) -> set[float]:
    """Give the moments that a property lists, in seconds from now; what is no date is passed over."""
    found = event.get(name)  # type: ignore[attr-defined]
    entries = [entry for part in (found if isinstance(found, list) else [found]) for entry in _dates(part)]
    return {seconds_between(now, _instant(entry, now)) for entry in entries}


def _dates(part: object) -> list[date | datetime]:
    """Give the dates of a property's value: one, or a list of several; of periods their starts."""
    values = [getattr(one, "dt", None) for one in getattr(part, "dts", [part])]
    starts = [value[0] if isinstance(value, tuple) else value for value in values]
    return [value for value in starts if isinstance(value, date)]


def _instant(value: date | datetime, now: datetime) -> datetime:
    if not isinstance(value, datetime):
        value = datetime.combine(value, time())
    return value if value.tzinfo is not None else value.replace(tzinfo=now.tzinfo)


def _length(event: "object", start: datetime, now: datetime) -> float:
    if "DTEND" in event:  # type: ignore[operator]
        return max(0.0, seconds_between(start, _instant(event.decoded("DTEND"), now)))  # type: ignore[attr-defined]
    if "DURATION" in event:  # type: ignore[operator]
        return max(0.0, float(event.decoded("DURATION").total_seconds()))  # type: ignore[attr-defined]
    return DAY if not isinstance(event.decoded("DTSTART"), datetime) else 0.0  # type: ignore[attr-defined]


def _occurrences(
    event: "object", start: datetime, length: float, now: datetime, ahead: float
) -> list[datetime]:
    """Give the starts of an event that may still matter; dateutil comes with icalendar."""
    rule = event.get("RRULE")  # type: ignore[attr-defined]
    if rule is None:
        return [start]
    from dateutil.rrule import rrulestr

    after = max(start, _floor(now, start) - timedelta(seconds=length))
    first = start + timedelta(seconds=_skipped(rule, (after - start).total_seconds()))
    series = rrulestr(rule.to_ical().decode(), dtstart=first, ignoretz=start.tzinfo is None)
    until = _floor(now, start) + timedelta(seconds=ahead)
    found = []
    for occurrence in series.xafter(after, count=MAX_OCCURRENCES, inc=True):
        if occurrence > until:
            break
        found.append(occurrence)
    return found


def _skipped(rule: "Mapping[str, Sequence[str | int]]", passed: float) -> float:
    """Give the seconds of occurrences that are over: one by one, those of years would take minutes.

    Raises
    ------
    FuzzytimeError
        If they never end, or are many and cannot be skipped.
    """
    interval = int(rule.get("INTERVAL", [1])[0])
    if interval < 1:
        raise FuzzytimeError(f"an event must repeat at an interval of at least 1, got {interval}")
    step = STEPS.get(str(rule["FREQ"][0]).upper())
    if step is None:
        return 0.0
    if set(rule) - {"FREQ", "INTERVAL", "UNTIL", "WKST"}:
        raise FuzzytimeError(f"an event with conditions must repeat daily or less often, got {dict(rule)}")
    return passed // (step * interval) * step * interval


def _floor(now: datetime, like: datetime) -> datetime:
    if like.tzinfo is None:
        return now.replace(tzinfo=None)
    return now if now.tzinfo is not None else now.replace(tzinfo=like.tzinfo)
