"""The grammar of English time: one file of rules a concern, beside word tables in ``rules/``."""

from functools import cache

from fuzzytime.language.english import bounds, clocks, dates, days, durations, numbers, repetitions
from fuzzytime.language.grammar.chart import Grammar


@cache
def grammar() -> Grammar:
    """Give all rules of English."""
    whole = Grammar()
    for room in (numbers, durations, clocks, days, dates, bounds, repetitions):
        whole.include(room.grammar)
    return whole
