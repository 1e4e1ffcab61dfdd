"""From which day on a day is looked for: from today on, or from one that was said before."""

from dataclasses import replace

from fuzzytime.language.meaning.calendar import Calendar, Today, is_weekday
from fuzzytime.language.meaning.days.relations import Following, Relative, days_onward
from fuzzytime.language.meaning.grounded.standpoint import Standpoint
from fuzzytime.language.meaning.ungrounded import UngroundedError


def day_counted_from(here: Standpoint, calendar: Calendar) -> Today:
    """Give today, or for "the day after" the day that was said before, if that is to come.

    Raises
    ------
    UngroundedError
        If it counts from a day, and none was said.
    """
    # "The weekend after" is behind that day.
    base = calendar.anchor if isinstance(calendar, Following) else calendar
    onward = days_onward(base)
    said = here.day or here.since
    if isinstance(base, Relative) and base.event:
        said = here.event or said
    if said is None and onward == 0:
        raise UngroundedError("which day is meant is not said")
    if onward is not None and said is not None and said.date() > here.now.date():
        return replace(here.today, day=said.date())
    if (
        here.listed
        and here.day is not None
        and here.day.date() > here.now.date()
        and _is_today(here, calendar)
    ):
        # "On tuesday and wednesday", said on a wednesday, is the wednesday that follows.
        return replace(here.today, day=here.day.date())
    return here.today


def _is_today(here: Standpoint, calendar: Calendar) -> bool:
    """Whether it is a weekday, and today is one."""
    first = next(calendar.upcoming(here.today, here.today.day), None) if is_weekday(calendar) else None
    return first is not None and first.first == here.now.date()
