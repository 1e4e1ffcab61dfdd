"""Bounds of a time, and times that hold only if another does.

``bounds`` ("by six"), ``denied_bounds`` ("not after six"), ``bounds_off_times``, ``bounds_on_days``, and
``numbers_on_dates`` behind them; ``hedged_asides`` between commas; ``if_it_is`` a day that the calendar
knows.
"""

from fuzzytime.language.english.bounded import (
    bounds,
    bounds_off_times,
    bounds_on_days,
    denied_bounds,
    hedged_asides,
    if_it_is,
    numbers_on_dates,
)
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(
    bounds.grammar,
    denied_bounds.grammar,
    bounds_off_times.grammar,
    bounds_on_days.grammar,
    numbers_on_dates.grammar,
    hedged_asides.grammar,
    if_it_is.grammar,
)
