"""Dates typed in numbers: "2015-03-03", "31.10.1974", "2/15", "friday 7.6"."""

from dataclasses import replace

from fuzzytime.language.english.calendar.dates import century, valid_date
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.calendar import Fields

grammar = Grammar()

MONTHS = 12
"""Of a year: two numbers up to here may be month and day in either order."""


def _either(first: int, second: int, year: int | None) -> Fields | None:
    """Month and day in the order that is possible; month first where both are."""
    found = valid_date(year, first, second) or valid_date(year, second, first)
    both = found is not None and max(first, second) <= MONTHS and first != second
    return replace(found, turnable=True) if found is not None and both else found


@grammar.rule("date", "<y-m-d>", weight=1.3)
def iso(numbers: Typed) -> Fields | None:
    """2015-03-03."""
    return valid_date(numbers[0], numbers[1], numbers[2]) or valid_date(numbers[0], numbers[2], numbers[1])


@grammar.rule("date", "<n-n-n>", weight=1.3)
def typed(numbers: Typed) -> Fields | None:
    """3/3/2015, 31.10.1974."""
    found = _either(numbers[0], numbers[1], century(numbers[2], numbers.parts[2]))
    return found if found is None or not numbers.ordered else replace(found, turnable=False)


@grammar.rule("date", "<yyyymmdd>", weight=0.1)
def compact(numbers: Typed) -> Fields | None:
    """20161016."""
    return valid_date(numbers[0], numbers[1], numbers[2]) if 1900 <= numbers[0] < 2200 else None


@grammar.rule("date", "<integer> <integer> <integer>", weight=-0.1)
def spaced(year: Integer, month: Integer, day: Integer) -> Fields | None:
    """2016 10 16."""
    return valid_date(year.value, month.value, day.value) if len(year.digits) == 4 else None


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
    """7.6, beside a weekday; "friday 8.30" is a clock time."""
    return _either(numbers[0], numbers[1], None) if numbers[1] <= MONTHS else None


@grammar.rule("date", "<d.m.>", weight=0.3)
@grammar.rule("weak date", "<last d.m.>", weight=0.2)
def stopped(numbers: Typed) -> Fields | None:
    """20.3. at ten: day and month, as the full stop says; on 3.4.: it may end a sentence, too."""
    return valid_date(None, numbers[1], numbers[0])


@grammar.rule("date", "<weekday> <dotted date>", "<weekday> , <dotted date>")
def dotted_date(weekday: int, date: Fields) -> Fields:
    """Friday 7.6."""
    return replace(date, weekday=weekday)
