"""What two days mean that are said side by side: "monday next week", "tomorrow, the 13th"."""

from fuzzytime.language.meaning.calendar import (
    Calendar,
    Cycle,
    Fields,
    Weekend,
    is_weekday,
)
from fuzzytime.language.meaning.days.nested import WeekOf, Within
from fuzzytime.language.meaning.days.relations import Away, Deictic, Following, Relative
from fuzzytime.requirement import Unit


def narrowed(first: Calendar, second: Calendar) -> Calendar | None:
    """Give what two expressions said side by side mean together, or None where they do not go together.

    "tuesday" and "the 19th" are one date; "wednesday" and "next week" are a finer one in a coarser one.
    """
    if isinstance(first, Fields) and isinstance(second, Fields):
        return first.joined(second)
    for weekend, day in ((first, second), (second, first)):
        # "Next weekend, saturday if possible"
        if isinstance(weekend, Deictic) and isinstance(weekend.of, Weekend) and is_weekday(day):
            return Within(day, weekend)
    sizes = list(Unit)
    finer, coarser = sorted((first, second), key=lambda calendar: sizes.index(calendar.grain))
    if sizes.index(finer.grain) >= sizes.index(coarser.grain):
        return None
    if isinstance(finer, Relative) or (finer.fixed and coarser.fixed):
        return None
    if isinstance(finer, Deictic) and isinstance(finer.of, Cycle):
        return None
    return Within(finer, coarser)


def same_day(first: Calendar, second: Calendar) -> bool:
    """Whether one may say again which day another means: "tomorrow, the 13th", "in three days on friday"."""
    if isinstance(first, Deictic):
        # "Next friday, 5/12", "next friday the 16th": the date is believed.
        return is_weekday(first.of) and isinstance(second, Fields) and second.day is not None
    return isinstance(first, (Relative, Away)) and isinstance(second, Fields) and second.grain is Unit.DAY


def weekday_at(away: Away, weekday: Fields) -> Calendar:
    """Give the weekday that is so far away: in that week, or the first from a day some months away on."""
    if away.unit is Unit.WEEK:
        return Within(weekday, WeekOf(away))
    return Following(1, weekday, Away(-1, Unit.DAY, away))
