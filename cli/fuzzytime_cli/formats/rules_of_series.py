"""Rules of repetition (RFC 5545) that give the times of a series, if any does: "every second monday"."""

from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime, timedelta
from itertools import pairwise

WEEK = 7
"""Days."""

YEAR = 12
"""Months."""

DAYS = ("MO", "TU", "WE", "TH", "FR", "SA", "SU")

Rule = Mapping[str, str | int | Sequence[str]]
"""The parts of a rule: FREQ, INTERVAL, BYDAY and so on."""


def rule_of(times: Sequence[datetime]) -> Rule | None:
    """Give the simplest rule after which times come, of which the first is the first; None without one.

    >>> monday = datetime(2026, 3, 9, 9)
    >>> rule_of([monday, monday + timedelta(days=14), monday + timedelta(days=28)])
    {'FREQ': 'WEEKLY', 'INTERVAL': 2, 'BYDAY': ['MO']}
    """
    if len({time.time() for time in times}) != 1:
        return None
    return next((rule for rule in _rules(times) if _gives(rule, times)), None)


def _rules(times: Sequence[datetime]) -> Iterator[Rule]:
    """Give the rules that may fit the first times, simple ones first."""
    first = times[0]
    gaps = {(after.date() - before.date()).days for before, after in pairwise(times)}
    if len(gaps) == 1:
        (gap,) = gaps
        yield _every("DAILY", gap) if gap % WEEK else _every("WEEKLY", gap // WEEK, BYDAY=[_day(first)])
    weekdays = [DAYS[day] for day in sorted({time.weekday() for time in times})]
    mondays = sorted({time.date() - timedelta(days=time.weekday()) for time in times})
    weeks = {(after - before).days // WEEK for before, after in pairwise(mondays)}
    if len(weeks) == 1:
        yield _every("WEEKLY", *weeks, BYDAY=weekdays)
    months = {
        (after.year - before.year) * YEAR + after.month - before.month for before, after in pairwise(times)
    }
    if len(months) == 1 and 0 not in months:
        yield from _by_months(first, *months)


def _by_months(first: datetime, gap: int) -> Iterator[Rule]:
    """Give the rules of what comes every so many months, or years."""
    numbered = f"{(first.day - 1) // WEEK + 1}{_day(first)}"
    days = (
        {"BYMONTHDAY": first.day},
        {"BYMONTHDAY": -1},
        {"BYDAY": [numbered]},
        {"BYDAY": [f"-1{_day(first)}"]},
    )
    for day in days:
        if gap % YEAR:
            yield _every("MONTHLY", gap, **day)
        else:
            yield _every("YEARLY", gap // YEAR, BYMONTH=first.month, **day)


def _every(frequency: str, interval: int, **parts: int | Sequence[str]) -> Rule:
    return {"FREQ": frequency, **({"INTERVAL": interval} if interval != 1 else {}), **parts}


def _day(time: datetime) -> str:
    return DAYS[time.weekday()]


def _gives(rule: Rule, times: Sequence[datetime]) -> bool:
    """Whether a rule gives these times, and no others before the last; dateutil comes with icalendar."""
    from dateutil.rrule import rrulestr

    parts = {name: ",".join(value) if isinstance(value, list) else value for name, value in rule.items()}
    text = ";".join(f"{name}={value}" for name, value in {**parts, "COUNT": len(times)}.items())
    wall = [time.replace(tzinfo=None) for time in times]
    return list(rrulestr(text, dtstart=wall[0])) == wall
