"""Dates: "february the 15th", "31st Oct 1974", "2/15", "first monday of march", "week 27", "Q3 2018"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend, Yearly
from fuzzytime.language.meaning.expressions import UnitWord, Wall
from fuzzytime.language.meaning.relations import Away, Deictic, Following, Nth, Share, WeekOf, Which
from fuzzytime.requirement import Unit

grammar = Grammar()

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


@grammar.rule("weak date", "the? <ordinal>", "the <integer>", weight=-0.3)
def day_alone(day: int | Integer) -> Fields | None:
    """The 15th, the 24: sure only with a preposition, as "the second drawer" is none."""
    number = day.value if isinstance(day, Integer) else day
    return Fields(day=number) if 1 <= number <= LONGEST_MONTH else None


# -- typed dates ----------------------------------------------------------------------------------------


def _valid(year: int | None, month: int, day: int | None) -> Fields | None:
    if not 1 <= month <= 12 or (day is not None and not 1 <= day <= LONGEST_MONTH):
        return None
    return Fields(year, month, day)


def _either(first: int, second: int, year: int | None) -> Fields | None:
    """Month and day in the order that is possible; month first where both are."""
    return _valid(year, first, second) or _valid(year, second, first)


def century(year: int, digits: str) -> int:
    """Give the year that two digits mean: up to 49 in this century."""
    return year if len(digits) > 2 else year + (2000 if year < 50 else 1900)


@grammar.rule("date", "<y-m-d>", weight=1.3)
def iso(numbers: Typed) -> Fields | None:
    """2015-03-03."""
    return _valid(numbers[0], numbers[1], numbers[2]) or _valid(numbers[0], numbers[2], numbers[1])


@grammar.rule("date", "<n-n-n>", weight=1.3)
def typed(numbers: Typed) -> Fields | None:
    """3/3/2015, 31.10.1974."""
    return _either(numbers[0], numbers[1], century(numbers[2], numbers.parts[2]))


@grammar.rule("date", "<yyyymmdd>", weight=0.1)
def compact(numbers: Typed) -> Fields | None:
    """20161016."""
    return _valid(numbers[0], numbers[1], numbers[2]) if 1900 <= numbers[0] < 2200 else None


@grammar.rule("date", "<integer> <integer> <integer>", weight=-0.1)
def spaced(year: Integer, month: Integer, day: Integer) -> Fields | None:
    """2016 10 16."""
    return _valid(year.value, month.value, day.value) if len(year.digits) == 4 else None


@grammar.rule("weak date", "<n/n>", "<integer> - <integer>", weight=-0.1)
def typed_without_year(first: Typed | Integer, second: Integer | None = None) -> Fields | None:
    """2/15; 3/4 of something is a fraction."""
    if isinstance(first, Typed):
        return _either(first[0], first[1], None)
    if second is None or not (first.digits and second.digits) or len(first.digits + second.digits) > 4:
        return None
    return _either(first.value, second.value, None)


@grammar.rule("dotted date", "<n.n>")
def dotted(numbers: Typed) -> Fields | None:
    """7.6, beside a weekday."""
    return _either(numbers[0], numbers[1], None)


@grammar.rule("date", "<weekday> <dotted date>", "<weekday> , <dotted date>")
def dotted_date(weekday: int, date: Fields) -> Fields:
    """Friday 7.6."""
    return replace(date, weekday=weekday)


# -- months and years -----------------------------------------------------------------------------------


@grammar.rule("year", "<integer>")
def year(number: Integer) -> int | None:
    """2014."""
    # 1030 is half past ten.
    return number.value if len(number.digits) == 4 and 1600 <= number.value < 3000 else None


@grammar.rule("year", "<spoken year>")
def spoken_year(number: int) -> int:
    """Two thousand and seventeen."""
    return number


@grammar.rule("year", "' <integer>")
def short_year(number: Integer) -> int | None:
    """'87."""
    return century(number.value, number.digits) if len(number.digits) == 2 else None


@grammar.rule("date", "<date> ,? of|in? <year>", "<date> - <year>", weight=0.2)
def with_year(date: Calendar, number: int) -> Fields | None:
    """March 3 2015, April 14, 2015, fourth of july 1995."""
    return date.joined(Fields(year=number)) if isinstance(date, Fields) else None


@grammar.rule("date", "<month day> - <month> - <integer>", "<month day> <month> of <integer>", weight=1.3)
def with_short_year(day: int, month: int, number: Integer) -> Fields | None:
    """31-Oct-74."""
    return Fields(century(number.value, number.digits), month, day) if len(number.digits) == 2 else None


@grammar.rule("date", "<month> ,? of|in? <year>", "<month> / <year>", weight=0.2)
def month_and_year(month: int, number: int) -> Fields:
    """March 2015, june of 1992."""
    return Fields(number, month)


@grammar.rule("date", "<year> -|/? <month>", weight=0.1)
def year_and_month(number: int, month: int) -> Fields:
    """2017 april."""
    return Fields(number, month)


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


@grammar.rule("weak date", "<y/n>", "<n/y>", weight=1.1)
def numbered_month(numbers: Typed) -> Fields | None:
    """2014-10, 12/2015."""
    first, second = numbers[0], numbers[1]
    return _valid(first, second, None) if first > 12 else _valid(second, first, None)


@grammar.rule("weak date", "<month>", weight=-0.1)
def month(number: int) -> Fields:
    """May: sure with a preposition."""
    return Fields(month=number)


@grammar.rule("weak date", "<year>", weight=-0.3)
def year_alone(number: int) -> Fields:
    """2014: sure with a preposition."""
    return Fields(year=number)


@grammar.rule("date", "<share> of? <year>", weight=0.3)
def share_of_year(share: tuple[float, float], number: int) -> Calendar:
    """Mid 1989."""
    return Share(*share, Fields(year=number))


@grammar.rule("date", "<year> -? h <integer>", weight=1.2)
def half_of_year(outer: int, number: Integer) -> Calendar | None:
    """2019 H2."""
    return half_year(number, Fields(year=outer))


@grammar.rule("date", "the? year <year>", "cy <year>")
def the_year(number: int) -> Fields:
    """The year 2014."""
    return Fields(year=number)


# -- the nth of a period --------------------------------------------------------------------------------


@grammar.rule("whole", "<date>|<weak date>|<days>")
def whole(days: Calendar) -> Calendar:
    """What can hold weeks and days."""
    return days


@grammar.rule("whole", "the? <series>")
def present_whole(series: Calendar) -> Calendar | None:
    """The month, in "first monday of the month"."""
    return series if isinstance(series, Cycle) else None


@grammar.rule("date", "the? <ordinal> <series> of|in <whole>", "the? <ordinal> <series> <days>", weight=0.4)
def nth(number: int, series: Calendar, outer: Calendar) -> Calendar | None:
    """First monday of march, third day of october."""
    return (
        None if series.grain is outer.grain and series.grain is not Unit.DAY else Nth(number, series, outer)
    )


@grammar.rule("date", "the? last <series> of|in <whole>", "the? last <series> <weak date>", weight=0.45)
def last(series: Calendar, outer: Calendar) -> Calendar:
    """Last monday of march, last day of october 2015."""
    return Nth(-1, series, outer)


@grammar.rule("date", "the? <ordinal> last <series> of|in <whole>", weight=0.45)
def nth_last(number: int, series: Calendar, outer: Calendar) -> Calendar:
    """Third last week of 2018."""
    return Nth(-number, series, outer)


@grammar.rule("date", "the? first <integer> <unit> of|in <whole>", weight=0.45)
def first_few(count: Integer, unit: UnitWord, outer: Calendar) -> Calendar | None:
    """The first two weeks of 2021."""
    return (
        Nth(1, Cycle(unit.unit, unit.count), outer, count.value)
        if 0 < count.value < 1000 and _is_days(unit)
        else None
    )


@grammar.rule("date", "the? last <integer> <unit> of|in <whole>", weight=0.45)
def last_few(count: Integer, unit: UnitWord, outer: Calendar) -> Calendar | None:
    """The last three weeks of this year."""
    return (
        Nth(-1, Cycle(unit.unit, unit.count), outer, count.value)
        if 0 < count.value < 1000 and _is_days(unit)
        else None
    )


def _is_days(unit: UnitWord) -> bool:
    return unit.unit not in {Unit.SECOND, Unit.MINUTE, Unit.HOUR}


@grammar.rule("date", "<month day> of the month", weight=0.5)
def day_of_the_month(day: int) -> Calendar:
    """The first of the month: the next one."""
    return Fields(day=day)


@grammar.rule("date", "<month day> of <days>", weight=0.2)
def day_of_month(day: int, month: Calendar) -> Calendar | None:
    """20th of next month."""
    return Nth(day, Cycle(Unit.DAY), month) if month.grain is Unit.MONTH else None


@grammar.rule("date", "week <integer> of? <whole>?", weight=0.1)
def numbered_week(number: Integer, outer: Calendar | None) -> Calendar | None:
    """Week 27 of last year."""
    if not 1 <= number.value <= 53:
        return None
    return Nth(number.value, Cycle(Unit.WEEK), outer or Deictic(Which.THIS, Cycle(Unit.YEAR)))


@grammar.rule("date", "the? week of|starting|beginning|commencing on? <whole>", "w / c <whole>", weight=0.3)
def week_of(days: Calendar) -> Calendar | None:
    """The week of october 7th."""
    return WeekOf(days) if days.grain is Unit.DAY else None


@grammar.rule("date", "the? <ordinal> quarter|qtr of? <whole>?", weight=0.3)
def quarter(number: int, outer: Calendar | None) -> Calendar | None:
    """Third quarter of 2016."""
    return _quarter(number, outer)


@grammar.rule("date", "q <integer> of|-? <whole>?", weight=0.3)
def short_quarter(number: Integer, outer: Calendar | None) -> Calendar | None:
    """Q3 2018."""
    return _quarter(number.value, outer)


@grammar.rule("date", "<year> -? q <integer>", weight=0.3)
def short_quarter_after(outer: int, number: Integer) -> Calendar | None:
    """2018Q4."""
    return _quarter(number.value, Fields(year=outer))


def _quarter(number: int, outer: Calendar | None) -> Calendar | None:
    if not 1 <= number <= 4 or (outer is not None and outer.grain is not Unit.YEAR):
        return None
    return Nth(number, Cycle(Unit.QUARTER), outer or Cycle(Unit.YEAR))


@grammar.rule("date", "h <integer> of|-? <whole>?", weight=0.2)
def half_year(number: Integer, outer: Calendar | None) -> Calendar | None:
    """H1 2016."""
    if number.value not in {1, 2} or outer is None or outer.grain is not Unit.YEAR:
        return None
    return Nth(6 * number.value - 5, Cycle(Unit.MONTH), outer, 6)


@grammar.rule("date", "the? <ordinal> <series> after <whole>", weight=0.4)
def nth_after(number: int, series: Calendar, anchor: Calendar) -> Calendar:
    """Third tuesday after christmas 2014."""
    return Following(number, series, anchor)


@grammar.rule("date", "<feast> of|in|,? <year>", weight=0.3)
def feast_of_year(feast: Yearly, number: int) -> Calendar:
    """Easter 2018."""
    return Nth(1, feast, Fields(year=number))


@grammar.rule("date", "<feast> weekend", "<feast> <year> weekend", "the? weekend of <feast>", weight=0.3)
def feast_weekend(feast: Yearly, number: int | None = None) -> Calendar:
    """Labor day weekend."""
    anchor: Calendar = feast if number is None else Nth(1, feast, Fields(year=number))
    return Following(1, Weekend(), _six_days_before(anchor))


def _six_days_before(anchor: Calendar) -> Calendar:
    return Away(-5, Unit.DAY, anchor)


@grammar.rule("wall", "<date>")
def wall(days: Calendar) -> Wall:
    """A date alone."""
    return Wall(days)


@grammar.rule("wall", "<weak date>")
def weak_wall(days: Calendar) -> Wall:
    """A date that is none without a preposition."""
    return Wall(days, weak=True)


@grammar.rule("days", "the? day|evening|morning|night before <feast>", weight=0.7)
def eve(feast: Yearly) -> Calendar:
    """The day before christmas."""
    return Away(-1, Unit.DAY, feast)
