"""Weekdays beside a date: "thursday 6 march", on which day both fit, or which of the two is believed."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.meaning.calendar import Days, Fields, Today
from fuzzytime.language.meaning.ungrounded import UngroundedError

FAR = 3
"""Years within which a weekday with a date that does not match is looked for."""

PASSED = timedelta(days=183)
"""How long ago a date may be that a weekday beside it says has passed."""


def nearest(calendar: Fields, today: Today) -> Iterator[Days]:
    """Give the day on which a weekday fits its date, whichever number of it is the month: "thu 05/03".

    Raises
    ------
    UngroundedError
        If there is no such date.
    """
    found = next(_in_order(calendar, today), None)
    fits = found is not None and found.first.weekday() == calendar.weekday
    if calendar.turnable and not fits:
        turned = next(_in_order(replace(calendar, month=calendar.day, day=calendar.month), today), None)
        if turned is not None and turned.first.weekday() == calendar.weekday:
            found = turned
    if found is not None:
        yield found


def _in_order(calendar: Fields, today: Today) -> Iterator[Days]:
    """Give the day on which a weekday fits its date: the next, or that of the date that passed last.

    Where a month is said and neither fits, the date is believed; a day of the month alone is looked for.

    Raises
    ------
    UngroundedError
        If there is no such date.
    """
    if calendar.month is None or calendar.year is not None:
        ahead = next(calendar.upcoming(today, today.day), None)
        if ahead is not None and (ahead.first - today.day).days <= 366 * FAR:
            yield ahead
            return
    dated = replace(calendar, weekday=None)
    upcoming, past = dated.upcoming(today, today.day), dated.past(today, today.day)
    ahead, behind = next(upcoming, None), next(past, None)
    if ahead is None:
        raise UngroundedError("there is no such date")
    if behind is not None and today.day - behind.first > PASSED:
        behind = None
    fitting = (days for days in (ahead, behind) if days and days.first.weekday() == calendar.weekday)
    yield next(fitting, ahead)
