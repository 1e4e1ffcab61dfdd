"""Stretches of days of one month: "between the 4th and the 22nd of this month", "thu 5 - sat 7 march"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields
from fuzzytime.language.meaning.days.nested import Nth
from fuzzytime.language.meaning.expressions import Range, Said, Wall
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule(
    "said",
    "between <month day> and|- <month day> of|in? <days>|<weak date>|<date>",
    "from? <month day> to|-|until|till|through|thru <month day> of|in? <days>|<weak date>|<date>",
    "from? <weak date>|<date> <month day> to|-|until|till|through|thru <month day>",
    "from? <month day> .? -|to|until <month day> . <weak date>",
    "between <weak date>|<date> <month day> and <month day>",
    "in? <days>|<weak date> ,? between <month day> and|- <month day>",
    "in? <days>|<weak date> ,? from <month day> to|-|until|till|through <month day>",
    weight=1.3,
)
def days_of_month(*said: int | Calendar) -> Said | None:
    """Between the 4th and the 22nd of this month, next month from the 4th to the 10th."""
    first, last = (part for part in said if isinstance(part, int))
    month = next(part for part in said if isinstance(part, Calendar))
    if month.grain is not Unit.MONTH or first >= last:
        return None
    ends = (Wall(Nth(number, Cycle(Unit.DAY), month)) for number in (first, last))
    return Said(Range(*ends), Constraint.BETWEEN, "between")


@grammar.rule(
    "said",
    "from? <month> <month day> to|-|until|till|through|thru <month day> ,? of? <year>",
    "between <month> <month day> and <month day> ,? of? <year>",
    "in? <month> ,? between <month day> and|- <month day> ,? of? <year>",
    weight=1.9,
)
def days_of_month_of_year(month: int, first: int, last: int, number: int) -> Said | None:
    """Feb 2-7 2018, february between the 2nd and the 7th of 2018."""
    return days_of_month(first, last, Fields(number, month))


@grammar.rule(
    "said",
    "from? <weekday> <month day> -|to|until|till|through <weekday> <month day> of? <month>",
    weight=2.0,
)
def weekdays_of_month(weekday: int, first: int, again: int, last: int, month: int) -> Said | None:
    """Thu 5 - sat 7 march."""
    if first >= last:
        return None
    ends = (Wall(Fields(month=month, day=day, weekday=on)) for day, on in ((first, weekday), (last, again)))
    return Said(Range(*ends), Constraint.BETWEEN, "between")


@grammar.rule(
    "said", "from? <weekday> <month> <month day> -|to|until|till|through <weekday> <month day>", weight=2.0
)
def weekdays_of_month_before(weekday: int, month: int, first: int, again: int, last: int) -> Said | None:
    """Thu march 5 - sat 7."""
    return weekdays_of_month(weekday, first, again, last, month)


@grammar.rule(
    "said",
    "on? the? <ordinal> or|/ the? <ordinal> of? <month>",
    "on <month day> or|/ <month day> of? <month>",
    weight=1.4,
)
def either_day(first: int, last: int, month: int) -> Said:
    """The 3rd or 4th of may, on the 3rd/4th of may: one of the two."""
    days = [Wall(Fields(month=month, day=day)) for day in (first, last)]
    return Said(days[0], listed=(Said(days[1], alternative=True),))
