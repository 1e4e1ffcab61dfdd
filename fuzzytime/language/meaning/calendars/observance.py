"""Feasts as their calendars keep them: which days of a Gregorian year they begin on."""

import calendar
from abc import ABC, abstractmethod
from dataclasses import dataclass
from datetime import MAXYEAR, date

KNOWN_YEARS = range(2, MAXYEAR)
"""All years but the first and the last: what is moved, or lasts, may lie in the year before, or behind."""

COMPUTED_YEARS = range(1900, 2200)
"""The years for which the sun and the moon are computed: there the formulas hold."""


class Observance(ABC):
    """How a feast finds its days."""

    __slots__ = ()

    @property
    def years(self) -> range:
        """The Gregorian years in which its days are known."""
        return KNOWN_YEARS

    @abstractmethod
    def in_year(self, year: int) -> tuple[date, ...]:
        """Give the days of a Gregorian year on which it begins, ascending: one, or none, or two."""


class BySky(Observance):
    """How a feast finds its days by the sun or the moon."""

    __slots__ = ()

    @property
    def years(self) -> range:
        """Those for which the sun and the moon are computed."""
        return COMPUTED_YEARS


@dataclass(frozen=True, slots=True)
class OnDate(Observance):
    """On a day of the Gregorian calendar."""

    month: int
    day: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its day."""
        return (date(year, self.month, self.day),)


@dataclass(frozen=True, slots=True)
class OnWeekday(Observance):
    """On the nth weekday of a month, from its end where negative."""

    nth: int
    weekday: int
    month: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its day."""
        weeks = calendar.Calendar().monthdatescalendar(year, self.month)
        days = [week[self.weekday] for week in weeks if week[self.weekday].month == self.month]
        return (days[self.nth - 1 if self.nth > 0 else self.nth],)
