"""The grammar of English time: one file of rules a concern, beside word tables in ``rules/``."""

from functools import cache

from fuzzytime.language.english import (
    all_through,
    apart,
    bounded_repetitions,
    bounds,
    bounds_off_times,
    bounds_on_days,
    clocks,
    counted,
    dates,
    days,
    days_from_days,
    days_of_each_month,
    days_of_one_month,
    durations,
    edges_of_parts,
    elliptic,
    feasts,
    first_and_last,
    goals,
    hedged_asides,
    if_it_is,
    marks,
    meals,
    minutes_past,
    nights_and_weekends,
    numbers,
    numbers_on_dates,
    offered_days,
    parts,
    periods,
    prepositions,
    ranges,
    repeated_days,
    repeated_moments,
    repetitions,
    stacks,
    stretches_of_weekdays,
    typed_intervals,
    workdays,
    zones,
)
from fuzzytime.language.grammar.chart import Grammar

_ROOMS = (
    numbers,
    durations,
    clocks,
    minutes_past,
    zones,
    days,
    days_from_days,
    parts,
    first_and_last,
    dates,
    periods,
    feasts,
    stacks,
    goals,
    prepositions,
    meals,
    bounds,
    numbers_on_dates,
    counted,
    marks,
    elliptic,
    ranges,
    days_of_one_month,
    offered_days,
    bounds_off_times,
    edges_of_parts,
    bounds_on_days,
    hedged_asides,
    if_it_is,
    repetitions,
    apart,
    repeated_days,
    days_of_each_month,
    nights_and_weekends,
    repeated_moments,
    bounded_repetitions,
    stretches_of_weekdays,
    all_through,
    typed_intervals,
    workdays,
)


@cache
def grammar() -> Grammar:
    """Give all rules of English."""
    whole = Grammar()
    for room in _ROOMS:
        whole.include(room.grammar)
    return whole
