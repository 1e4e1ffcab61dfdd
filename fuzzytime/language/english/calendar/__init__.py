"""Days, and periods of them.

Days by name and from today: ``days``; from another: ``days_from_days``; that do not count weekends:
``workdays``; of which each will do: ``offered_days``. ``dates``, and ``typed_dates``; stretches of
``days_of_one_month``. ``periods`` counted in others ("week 27"), and ``feasts``.
"""

from fuzzytime.language.english.calendar import (
    dates,
    days,
    days_from_days,
    days_of_one_month,
    feasts,
    offered_days,
    periods,
    typed_dates,
    workdays,
)
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(
    days.grammar,
    days_from_days.grammar,
    dates.grammar,
    typed_dates.grammar,
    periods.grammar,
    feasts.grammar,
    workdays.grammar,
    offered_days.grammar,
    days_of_one_month.grammar,
)
