"""From which day on a day is looked for: from today on, or from one that was said before."""

from dataclasses import replace

from fuzzytime.language.meaning.calendar import Calendar, Today
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
    return here.today
