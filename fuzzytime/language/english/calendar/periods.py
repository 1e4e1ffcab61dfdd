"""Periods counted in others: "first monday of march", "week 27", "Q3 2018", "the weekend after easter"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend, is_weekly
from fuzzytime.language.meaning.days.nested import Nth, WeekOf
from fuzzytime.language.meaning.days.relations import Away, Deictic, Following, Relative, Which
from fuzzytime.language.meaning.days.workdays import Workday
from fuzzytime.language.meaning.expressions import Duration, Said, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.requirement import Unit

grammar = Grammar()

WEEK_DAYS = 7
MOST_WEEKDAYS = 5
"""How often a weekday is in one month, at most."""


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
    if series.grain is outer.grain and (series.grain is not Unit.DAY or _is_date(outer)):
        return None
    return Nth(number, series, outer)


def _is_date(days: Calendar) -> bool:
    """Whether it is one day, in which no other is: "the last sunday in march six pm"."""
    return isinstance(days, Fields) and days.day is not None


@grammar.rule("weak date", "the? <ordinal> <weekday>", weight=0.1)
def nth_of_month(number: int, weekday: int) -> Calendar | None:
    """The third tuesday: of this month, or of the next."""
    return Nth(number, Fields(weekday=weekday), Cycle(Unit.MONTH)) if 1 <= number <= MOST_WEEKDAYS else None


@grammar.rule("weak date", "the <place inside> <series>", weight=0.2)
def workday_of_month(place: int, series: Calendar) -> Calendar | None:
    """The first working day, the last business day: of this month, or of the next."""
    return Nth(place, series, Cycle(Unit.MONTH)) if isinstance(series, Workday) else None


@grammar.rule("said", "on? the? <ordinal> and|or the? <ordinal> <series> of|in <whole>", weight=1.0)
def two_of_them(first: int, second: int, series: Calendar, outer: Calendar) -> Said | None:
    """On the first and third monday of may."""
    found = [nth(number, series, outer) for number in (first, second)]
    if None in found or first >= second:
        return None
    walls = [Wall(days) for days in found]
    return Said(walls[0], None, "on", listed=(Said(walls[1], None, "on"),))


@grammar.rule("said", "on? the <ordinal> and|or the? <ordinal> <weekday>", weight=0.8)
def two_of_month(first: int, second: int, weekday: int) -> Said | None:
    """On the second and fourth tuesday."""
    return two_of_them(first, second, Fields(weekday=weekday), Cycle(Unit.MONTH))


@grammar.rule("date", "the? last <series> of|in <whole>", "the? last <series> <weak date>", weight=0.45)
def last(series: Calendar, outer: Calendar) -> Calendar | None:
    """Last monday of march, last day of october 2015; "last friday the 8th" is one day."""
    return None if _is_date(outer) else Nth(-1, series, outer)


@grammar.rule("date", "the? <ordinal> to last <series> of|in <whole>", weight=2.0)
@grammar.rule("date", "the? <ordinal> last <series> of|in <whole>", weight=0.45)
def nth_last(number: int, series: Calendar, outer: Calendar) -> Calendar:
    """Third last week of 2018, second to last friday of may."""
    return Nth(-number, series, outer)


@grammar.rule(
    "date",
    "the? penultimate <series> of|in <whole>",
    "the? next to last <series> of|in <whole>",
    "the? last but one <series> of|in <whole>",
    weight=0.45,
)
def last_but_one(series: Calendar, outer: Calendar) -> Calendar:
    """The penultimate friday of may."""
    return Nth(-2, series, outer)


@grammar.rule("date", "the last of <whole>", weight=0.45)
def last_of(outer: Calendar) -> Calendar | None:
    """The last of the month: its last day."""
    return Nth(-1, Cycle(Unit.DAY), outer) if outer.grain is Unit.MONTH else None


@grammar.rule("date", "the? first <duration> of|in <whole>", weight=0.44)
def first_vague_few(duration: Duration, outer: Calendar) -> Calendar | None:
    """The first few days of next month."""
    return _vague_few(1, duration, outer)


@grammar.rule("date", "the? last <duration> of|in <whole>", weight=0.44)
def last_vague_few(duration: Duration, outer: Calendar) -> Calendar | None:
    """The last couple of weeks of the year."""
    return _vague_few(-1, duration, outer)


def _vague_few(number: int, duration: Duration, outer: Calendar) -> Calendar | None:
    (amount, unit), *more = duration.terms
    if more or duration.until is not None or unit in SUB_DAY or amount != int(amount):
        return None
    if unit is Unit.WEEK and outer.grain is Unit.MONTH and amount > 1:
        # "The first two weeks of april" are its first fourteen days.
        unit, amount = Unit.DAY, WEEK_DAYS * amount
    return Nth(number, Cycle(unit), outer, int(amount))


@grammar.rule("date", "<month day> of the month", weight=0.5)
def day_of_the_month(day: int) -> Calendar:
    """The first of the month: the next one."""
    return Fields(day=day)


@grammar.rule("date", "<month day> of <days>", weight=0.2)
def day_of_month(day: int, month: Calendar) -> Calendar | None:
    """20th of next month."""
    return Nth(day, Cycle(Unit.DAY), month) if month.grain is Unit.MONTH else None


@grammar.rule("date", "calendar? week|wk <integer> of? <whole>?", weight=-0.3)
def numbered_week(number: Integer, outer: Calendar | None) -> Calendar | None:
    """Week 27 of last year."""
    if not 1 <= number.value <= 53:
        return None
    return Nth(number.value, Cycle(Unit.WEEK), outer or Deictic(Which.THIS, Cycle(Unit.YEAR)))


@grammar.rule("date", "<year> -? w <integer>", weight=1.2)
def typed_week(outer: int, number: Integer) -> Calendar | None:
    """2027-W14."""
    return numbered_week(number, Fields(year=outer))


@grammar.rule(
    "date", "the? week|wk of|starting|beginning|commencing on? <whole>", "w / c <whole>", weight=0.3
)
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


@grammar.rule("days", "<deictic> q <integer>", weight=0.3)
def which_quarter(which: Which, number: Integer) -> Calendar | None:
    """Next Q1."""
    found = _quarter(number.value, None)
    return None if found is None else Deictic(which, found)


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


@grammar.rule("date", "<year> -? h <integer>", weight=1.2)
def half_of_year(outer: int, number: Integer) -> Calendar | None:
    """2019 H2."""
    return half_year(number, Fields(year=outer))


@grammar.rule(
    "date",
    "the? <weekday series> after|following <feast>|<date>|<day of month>|<days>|<weekday with date>",
    weight=0.4,
)
@grammar.rule("date", "the <series> after|following <feast>|<date>|<day of month>", weight=0.4)
def next_after(series: Calendar, anchor: Calendar) -> Calendar | None:
    """The tuesday after easter, the weekend after the 5th of april."""
    return (
        Following(1, series, anchor) if anchor.grain is Unit.DAY and series.grain is not Unit.YEAR else None
    )


@grammar.rule("date", "the <series> after|following", weight=-0.3)
def after_that_day(series: Calendar) -> Calendar | None:
    """(dig it this weekend and plant it) the weekend after: behind the day that was said."""
    day = series.grain in {Unit.DAY, Unit.YEAR} and not isinstance(series, (Weekend, Fields))
    return None if day else Following(1, series, Relative(0, onward=True))


@grammar.rule(
    "date", "the? <weekday series> before <feast>|<date>|<day of month>|<weekday with date>", weight=0.4
)
@grammar.rule("date", "the last? <series> before <feast>|<date>|<day of month>", weight=0.4)
def last_before(series: Calendar, anchor: Calendar) -> Calendar | None:
    """The saturday before christmas, the last sunday before easter."""
    return nth_before(1, series, anchor)


@grammar.rule("date", "the? <ordinal> <series> after <whole>", weight=0.4)
def nth_after(number: int, series: Calendar, anchor: Calendar) -> Calendar:
    """Third tuesday after christmas 2014."""
    return Following(number, series, anchor)


@grammar.rule("date", "the? <ordinal> <series> before <feast>|<date>|<day of month>", weight=0.5)
def nth_before(number: int, series: Calendar, anchor: Calendar) -> Calendar | None:
    """The second friday before christmas, the last working day before the 24th."""
    counted = (is_weekly(series) or isinstance(series, Workday)) and anchor.grain is Unit.DAY and number > 0
    return Following(-number, series, anchor) if counted else None


@grammar.rule(
    "days",
    "the day before <days>|<date>|<weak date>|<weekday with date>",
    "the eve of <date>|<feast>",
    weight=0.9,
)
@grammar.rule("days", "day before <days>|<date>|<weak date>", weight=0.3)
def day_before(days: Calendar) -> Calendar | None:
    """The day before friday, the day before the first of april."""
    return Away(-1, Unit.DAY, days) if days.grain is Unit.DAY else None


@grammar.rule("days", "the day after|following <days>|<date>|<weak date>|<weekday with date>", weight=0.9)
@grammar.rule("days", "day after|following <days>|<date>|<weak date>", weight=0.3)
def day_after(days: Calendar) -> Calendar | None:
    """The day after friday."""
    return Away(1, Unit.DAY, days) if days.grain is Unit.DAY else None
