"""Busy times from an iCalendar file."""

from collections.abc import Iterator, Mapping, Sequence
from datetime import UTC, date, datetime, time, timedelta
from pathlib import Path
from typing import Any

from fuzzytime.errors import FuzzytimeError
from fuzzytime.skills import Busy
from fuzzytime.times import DAY, HOUR, MINUTE, seconds_between
from fuzzytime_cli.inputs.surroundings import Taken

MAX_BYTES = 4 << 20
MAX_OCCURRENCES = 500
MOST_UNREAD = 5
"""Events that are named at most where they cannot be read; the rest is counted."""

TIMES = ("DTSTART", "DTEND", "DURATION", "RRULE", "RDATE", "EXDATE", "RECURRENCE-ID", "FREEBUSY")
"""What an event says of when it is."""

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


def read_calendar(path: Path, now: datetime, ahead: float = AHEAD) -> Taken:
    """Give the times that a calendar file takes within the next two weeks, or longer, in seconds from now.

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
        calendars = icalendar.Calendar.from_ical(raw, multiple=True)
    except _BROKEN as error:
        reason = f": {str(error)[:80]}" if isinstance(error, ValueError) else ""  # others are of its inside
        raise FuzzytimeError(f"{path.name} must be an iCalendar file of at most 4 MB{reason}") from error
    if not calendars:
        raise FuzzytimeError(f"{path.name} must be an iCalendar file of at most 4 MB, and holds no calendar")
    ahead = max(ahead, AHEAD)
    try:
        parts = [*_taken_by_events(_all(calendars, "VEVENT"), now, ahead)]
    except FuzzytimeError as error:
        raise FuzzytimeError(f"{path.name}: {error}") from error
    parts += [_taken_in_free_busy(one, now, ahead) for one in _all(calendars, "VFREEBUSY")]
    busy = sorted((one for part in parts for one in part.busy), key=lambda taken: (taken.start, taken.end))
    unread = [f"{path.name}: {sentence}" for part in parts for sentence in part.unread]
    if len(unread) > MOST_UNREAD + 1:
        left = len(unread) - MOST_UNREAD
        unread = [*unread[:MOST_UNREAD], f"{path.name}: {left} more events cannot be read as they are"]
    return Taken(tuple(busy), tuple(unread))


def _all(calendars: "Sequence[Any]", name: str) -> list[object]:
    """Give the components of a name in all calendars of a file: it may hold several in a row."""
    return [component for calendar in calendars for component in calendar.walk(name)]


def _taken_by_events(events: "Sequence[object]", now: datetime, ahead: float) -> Iterator[Taken]:
    """Give what each event takes, unless it is cancelled or does not block time."""
    moved = {(_of(event, "UID"), one) for event in events for one in _moments(event, "RECURRENCE-ID", now)}
    for event in events:
        if (
            str(_of(event, "STATUS") or "").upper() != "CANCELLED"
            and str(_of(event, "TRANSP") or "").upper() != "TRANSPARENT"
        ):
            own = _of(event, "UID")
            series = _of(event, "RECURRENCE-ID") is None
            yield _taken_by(event, now, ahead, {one for uid, one in moved if series and own and uid == own})


def _taken_by(event: "object", now: datetime, ahead: float, moved: set[float]) -> Taken:
    """Give when an event is, and what it says of that which cannot be read."""
    what = str(_of(event, "SUMMARY") or "")
    name = f"event {what[:40]!r}" if what else "an event without a name"
    broken = _broken(event)
    try:
        start = _instant(event.decoded("DTSTART"), now)  # type: ignore[attr-defined]
        length = _length(event, start, now)
        starts = _occurrences(event, start, length, now, ahead)
    except _BROKEN:
        why = (
            "it has no DTSTART"
            if _of(event, "DTSTART") is None
            else f"its {' and '.join(broken) or 'RRULE'} cannot be read"
        )
        return Taken((), (f"{name} takes no time: {why}",))
    gone = moved | _moments(event, "EXDATE", now)
    unread = [f"the {part} of {name} cannot be read, and does not count" for part in broken]
    unread += [f"{name} {doubt}" for doubt in _doubts(event, start, now)]
    if len(starts) == MAX_OCCURRENCES:
        unread.append(f"{name} repeats very often: its first {MAX_OCCURRENCES} times count")
    found = []
    for first in sorted({*(seconds_between(now, begin) for begin in starts), *_moments(event, "RDATE", now)}):
        if first + length > 0 and first < ahead and first not in gone:
            found.append(Busy(first, first + length, what))
    return Taken(tuple(found), tuple(unread))


def _doubts(event: "object", start: datetime, now: datetime) -> Iterator[str]:
    """Give what is odd about an event's times, though they can be read."""
    zone = _of(event, "DTSTART").params.get("TZID")
    if zone is not None and getattr(_of(event, "DTSTART").dt, "tzinfo", None) is None:
        yield f"is taken as a time here: its zone {str(zone)[:40]!r} is not known"
    end = _of(event, "DTEND")
    if end is not None and seconds_between(start, _instant(end.dt, now)) < 0:
        yield "takes no time: it ends before it starts"


def _taken_in_free_busy(component: "object", now: datetime, ahead: float) -> Taken:
    """Give the periods of a component that tells when somebody is busy, and not with what."""
    given = _of(component, "FREEBUSY")
    found, unread = [], []
    for period in given if isinstance(given, list) else [given] if given is not None else []:
        try:
            if str(period.params.get("FBTYPE", "BUSY")).upper() != "FREE":
                start, end = (seconds_between(now, _instant(one, now)) for one in (period.start, period.end))
                if end > 0 and start < ahead:
                    found.append(Busy(start, max(start, end)))
        except _BROKEN:
            unread.append("a FREEBUSY cannot be read, and takes no time")
    return Taken(tuple(found), tuple(unread))


def _broken(event: "object") -> list[str]:
    """Give what an event says of its times that cannot be read."""
    return [name for name, _ in event.errors if name in TIMES]  # type: ignore[attr-defined]


def _of(component: "object", name: str) -> Any:  # noqa: ANN401 - whatever the calendar's library makes of it
    """Give a property of a component; None where it has none."""
    return component.get(name)  # type: ignore[attr-defined]


def _moments(event: "object", name: str, now: datetime) -> set[float]:
    """Give the moments that a property lists, in seconds from now; what is no date is passed over."""
    found = None if name in _broken(event) else _of(event, name)
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
    rule = _of(event, "RRULE")
    if rule is None:
        return [start]
    from dateutil.rrule import rrulestr

    after = max(start, _floor(now, start) - timedelta(seconds=length))
    first = start + timedelta(seconds=_skipped(rule, (after - start).total_seconds()))
    if "UNTIL" in rule:
        rule = type(rule)({**rule, "UNTIL": [_last(one, start) for one in rule["UNTIL"]]})
    series = rrulestr(rule.to_ical().decode(), dtstart=first)
    until = _floor(now, start) + timedelta(seconds=ahead)
    found = []
    for occurrence in series.xafter(after, count=MAX_OCCURRENCES, inc=True):
        if occurrence > until:
            break
        found.append(occurrence)
    return found


def _last(until: date | datetime, start: datetime) -> datetime:
    """Give the end of a series in UTC: many programs write its last day, or a time of the event's zone."""
    if not isinstance(until, datetime):
        until = datetime.combine(until, time.max)
    return (until if until.tzinfo is not None else until.replace(tzinfo=start.tzinfo)).astimezone(UTC)


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
