"""From which day on a day is looked for: from today on, or from one that was said before."""

from dataclasses import replace
from datetime import date, timedelta

from fuzzytime.language.meaning.calendar import Calendar, Today, moved
from fuzzytime.language.meaning.days.relations import Following, Relative, days_onward
from fuzzytime.language.meaning.grounded.standpoint import Standpoint
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.requirement import Unit


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
    if onward is not None and onward < 0:
        said = here.ahead or said
    if isinstance(base, Relative) and base.event:
        said = here.event or said
    if said is None and onward == 0:
        raise UngroundedError("which day is meant is not said")
    if onward is not None and said is not None and said.date() > here.now.date():
        return replace(here.today, day=said.date())
    return here.today


def day_alike(here: Standpoint, grain: Unit, first: date) -> date:
    """Give the day of a period that is in it what today is in its own: "this time next year"."""
    if grain is Unit.WEEK:
        return first + timedelta(days=(here.now.weekday() - first.weekday()) % 7)
    if grain not in {Unit.MONTH, Unit.YEAR}:
        return first
    months = 12 * (first.year - here.now.year)
    months += first.month - here.now.month if grain is Unit.MONTH else 0
    return moved(here.now.date(), Unit.MONTH, months)
