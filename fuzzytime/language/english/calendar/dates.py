"""Dates: "february the 15th", "31st Oct 1974", "march 2027"."""

from datetime import MAXYEAR

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Fields
from fuzzytime.language.meaning.days.nested import Share
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.feasts import Season

grammar = Grammar()

SPOKEN_CENTURIES = range(16, 21)
"""What a year of "nineteen oh one" begins with."""

SPOKEN_ALONE = 10
"""Below it, what a year ends in is said behind a zero."""

LAST_CLOCK_YEAR = 1959
"""The last past year that is written as a clock time is."""

LAST_SPOKEN_HOUR = 12
"""Up to here, a number and another behind it are hardly a year of our time."""

LATE_HOURS = range(2100, 2400)
"""Numbers beyond it that are rather hours and minutes than years, too: "friday, 2115"."""

LONGEST_MONTH = 31


# -- a month and its days -------------------------------------------------------------------------------


@grammar.rule("month day", "the? <ordinal>")
def ordinal_day(day: int) -> int | None:
    """The 15th."""
    return day if day <= LONGEST_MONTH else None


@grammar.rule("month day", "the? <integer>", weight=-0.1)
def numbered_day(day: Integer) -> int | None:
    """15, the 15."""
    return day.value if 1 <= day.value <= LONGEST_MONTH and len(day.digits) <= 2 else None


@grammar.rule("date", "<month> <month day>", "<month> , <month day>", "<month> / <month day>", weight=0.2)
def month_first(month: int, day: int) -> Fields:
    """February 15, february the 15th, oct/2."""
    return Fields(month=month, day=day)


@grammar.rule("date", "<month day> of? <month>", "<month day> / <month>", "<month day> . <month>", weight=0.2)
def day_first(day: int, month: int) -> Fields:
    """15 february, the third of march, 14april."""
    return Fields(month=month, day=day)


@grammar.rule("date", "the ides of <month>")
def ides(month: int) -> Fields:
    """The ides of march."""
    return Fields(month=month, day=15 if month in {3, 5, 7, 10} else 13)


@grammar.rule("weak date", "the <ordinal>", "<ordinal in digits>", "the <integer>", weight=-0.3)
def day_alone(day: int | Integer) -> Fields | None:
    """The third, 15th: sure only with a preposition, as "the second drawer" is none; nor is "the two".

    A word alone only counts: "first dose at ten, second at two, third at bedtime".
    """
    if isinstance(day, Integer) and not day.digits:
        return None
    number = day.value if isinstance(day, Integer) else day
    return Fields(day=number) if 1 <= number <= LONGEST_MONTH else None


def valid_date(year: int | None, month: int, day: int | None) -> Fields | None:
    """Give a date, or a month, in numbers; None where there is none."""
    if not 1 <= month <= 12 or (day is not None and not 1 <= day <= LONGEST_MONTH):
        return None
    return Fields(year, month, day)


def century(year: int, digits: str) -> int:
    """Give the year that two digits mean: up to 49 in this century."""
    return year if len(digits) > 2 else year + (2000 if year < 50 else 1900)


# -- months and years -----------------------------------------------------------------------------------


@grammar.rule("year", "<integer>")
def year(number: Integer) -> int | None:
    """2014."""
    # 1030 is half past ten.
    return number.value if len(number.digits) == 4 and 1600 <= number.value < 3000 else None


@grammar.rule("year", "<spoken year>")
def spoken_year(number: int) -> int | None:
    """Two thousand and seventeen; but "eleven thirty" is an hour."""
    return None if number // 100 <= LAST_SPOKEN_HOUR and number % 100 < 60 else number


@grammar.rule("year", "' <integer>")
def short_year(number: Integer) -> int | None:
    """'87."""
    return century(number.value, number.digits) if len(number.digits) == 2 else None


@grammar.rule("date", "<date> ,? of|in? <year>", "<date> - <year>", weight=0.2)
def with_year(date: Calendar, number: int) -> Fields | None:
    """March 3 2015, April 14, 2015, fourth of july 1995."""
    if not isinstance(date, Fields) or _is_late_hour(number):
        return None
    return date.joined(Fields(year=number))


@grammar.rule("date", "<date> ,? <integer> zero|oh|o <integer>", weight=2.2)
def with_spoken_year(date: Calendar, centuries: Integer, number: Integer) -> Fields | None:
    """September 10, nineteen zero one; june 5, twenty oh nine."""
    spoken = not (centuries.digits or number.digits) and 0 < number.value < SPOKEN_ALONE
    if not spoken or centuries.value not in SPOKEN_CENTURIES or not isinstance(date, Fields):
        return None
    dated = date.month is not None and date.year is None
    return date.joined(Fields(year=centuries.value * 100 + number.value)) if dated else None


def _is_late_hour(number: int) -> bool:
    return number in LATE_HOURS and number % 100 < 60


@grammar.rule("date", "<month day> - <month> - <integer>", "<month day> <month> of <integer>", weight=1.3)
def with_short_year(day: int, month: int, number: Integer) -> Fields | None:
    """31-Oct-74."""
    return Fields(century(number.value, number.digits), month, day) if len(number.digits) == 2 else None


@grammar.rule("date", "<month> ,? of|in? <year>", "<month> / <year>", weight=0.2)
def month_and_year(month: int, number: int) -> Fields | None:
    """March 2015, june of 1992."""
    return None if _is_late_hour(number) else Fields(number, month)


@grammar.rule("date", "<year> -|/? <month>", weight=0.1)
def year_and_month(number: int, month: int) -> Fields | None:
    """2017 april."""
    return None if _is_late_hour(number) else Fields(number, month)


@grammar.rule("date", "<year> - <month> - <month day>", "<year> / <month> / <month day>", weight=2.5)
def year_month_day(number: int, month: int, day: int) -> Fields:
    """2019-aug-01."""
    return Fields(number, month, day)


@grammar.rule("date", "<month> - <month day> - <year>", "<month> / <month day> / <year>", weight=2.5)
def month_day_year(month: int, day: int, number: int) -> Fields:
    """Sep-23-2020."""
    return Fields(number, month, day)


@grammar.rule("date", "<month day> - <month> - <year>", "<month day> / <month> / <year>", weight=2.5)
def day_month_year(day: int, month: int, number: int) -> Fields:
    """23/sep/2020."""
    return Fields(number, month, day)


@grammar.rule("weak date", "<season>", weight=-0.1)
def season(found: Season) -> Calendar:
    """Autumn: sure with a preposition."""
    return found


@grammar.rule("weak date", "<month>", weight=-0.1)
def month(number: int) -> Fields:
    """May: sure with a preposition."""
    return Fields(month=number)


@grammar.rule("weak date", "<year>", weight=-0.3)
def year_alone(number: int) -> Fields | None:
    """2014: sure with a preposition; but 1730 is half past five."""
    return Fields(year=number) if number > LAST_CLOCK_YEAR and not _is_late_hour(number) else None


@grammar.rule("weak date", "<year> /|- <integer>", weight=-0.2)
def spaced_year_and_month(number: int, month: Integer) -> Fields | None:
    """2026 / 11."""
    digits = 0 < len(month.digits) <= 2
    return valid_date(number, month.value, None) if digits and not _is_late_hour(number) else None


@grammar.rule("weak date", "<integer> /|- <year>", weight=-0.2)
def spaced_month_and_year(month: Integer, number: int) -> Fields | None:
    """11 - 2026."""
    return spaced_year_and_month(number, month)


@grammar.rule("era", "ad|ce", "a . d .?", "c . e .?")
def common_era() -> int:
    """AD, C.E.: years from the first on."""
    return 1


@grammar.rule("era", "bc|bce", "b . c .?", "b . c . e .?")
def before_common_era() -> int:
    """BC: years before the first, which no calendar here has."""
    return -1


@grammar.rule("date", "<integer> <era>", "the? year <integer> <era>", weight=0.4)
@grammar.rule("weak date", "ad <integer>", weight=0.4)
def year_of_era(number: Integer, sign: int = 1) -> Fields | None:
    """(in) 14 AD, (in) AD 14; of a year BC it is said that it is too long ago."""
    return Fields(year=sign * number.value) if 0 < number.value < MAXYEAR else None


@grammar.rule("date", "<share> of? <year>", weight=0.3)
def share_of_year(share: tuple[float, float], number: int) -> Calendar:
    """Mid 1989."""
    return Share(*share, Fields(year=number))


@grammar.rule("date", "the? year <year>", "cy <year>")
def the_year(number: int) -> Fields:
    """The year 2014."""
    return Fields(year=number)


# -- as times ------------------------------------------------------------------------------------------


@grammar.rule("wall", "<weak date>")
def weak_wall(days: Calendar) -> Wall:
    """A date that is none without a preposition."""
    return Wall(days, weak=True)
