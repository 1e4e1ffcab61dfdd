"""Times in a task file: moments, and the times that are taken."""

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime, timedelta

from fuzzytime.documents.nodes import Node, Reader, Scalar
from fuzzytime.errors import FuzzytimeError
from fuzzytime.skills import Busy
from fuzzytime.times import parse_clock, parse_duration, parse_instant, seconds_between


@dataclass(frozen=True, slots=True)
class Taken:
    """Times that are taken, in seconds from now, and sentences about what of them could not be read."""

    busy: tuple[Busy, ...] = ()
    unread: tuple[str, ...] = ()


CalendarReader = Callable[[str, datetime, float], Taken]
"""From a calendar file's name, now, and how many seconds ahead is planned, to the times that it takes."""

_CLOCK = re.compile(r"\s*\d{1,2}:\d{2}(:\d{2})?\s*")


def moment_of(text: str, now: datetime, since: float = -math.inf) -> float:
    """Read ``09:30``, an ISO instant, or a duration from now, as seconds from now.

    A time of day is today's, or tomorrow's where that of today lies before ``since``, in seconds from now.

    Raises
    ------
    FuzzytimeError
        If it is none of these.
    """
    if _CLOCK.fullmatch(text):
        # By the calendar, not by 24 hours: clocks may change that night.
        days = (
            datetime.combine(now.date(), parse_clock(text), now.tzinfo) + timedelta(days=n) for n in (0, 1)
        )
        first = seconds_between(now, next(days))
        return first if first >= since else seconds_between(now, next(days))
    try:
        return seconds_between(now, parse_instant(text, now.tzinfo))
    except FuzzytimeError:
        pass
    try:
        return parse_duration(text)
    except FuzzytimeError as error:
        raise FuzzytimeError(
            f"a time must look like 09:30, 2026-03-04T09:30 or '30 min' (from now), got {text!r}"
        ) from error


def read_busy(
    reader: Reader, node: Node, now: datetime, agents: int, ahead: float, calendar: CalendarReader
) -> Taken:
    """Read a list of ``{from, to, what, agent}``, or the name of a calendar file."""
    if isinstance(node, Scalar):
        return reader.read(node, "busy", lambda name: calendar(name, now, ahead)) or Taken()
    found = []
    for index, item in enumerate(reader.sequence(node, "busy")):
        key = f"busy[{index}]"
        fields = reader.mapping(item, key, ("from", "to", "what", "agent"), ("from", "to"))
        if not {"from", "to"} <= fields.keys():
            continue
        start = _moment(reader, fields["from"], f"{key}.from", now)
        end = _moment(reader, fields["to"], f"{key}.to", now, since=start)
        what = reader.string(fields["what"], f"{key}.what") if "what" in fields else ""
        agent = reader.whole(fields["agent"], f"{key}.agent", 1, agents) if "agent" in fields else 0
        if end < start:
            reader.mistake(item, key, "a busy time must not end before it starts")
        else:
            found.append(Busy(start, end, what, agent or None))
    return Taken(tuple(found))


def _moment(reader: Reader, node: Node, key: str, now: datetime, since: float = -math.inf) -> float:
    if not isinstance(node, Scalar):
        reader.mistake(node, key, "must be a time such as 09:30")
        return 0.0
    return reader.read(node, key, lambda text: moment_of(text, now, since)) or 0.0
