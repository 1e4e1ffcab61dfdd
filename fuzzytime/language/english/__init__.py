"""The grammar of English time: one file of rules a concern, beside word tables in ``rules/``.

Parts of a time
    ``amounts``; ``clock_times``; days and periods of the ``calendar``; ``parts_of_days``.
A whole time
    ``at_times`` with hedges and prepositions; ``from_now`` on; ``intervals``; ``bounded``; ``repeated``.
"""

from functools import cache

from fuzzytime.language.english import (
    amounts,
    at_times,
    bounded,
    calendar,
    clock_times,
    from_now,
    intervals,
    parts_of_days,
    repeated,
)
from fuzzytime.language.grammar.chart import Grammar


@cache
def grammar() -> Grammar:
    """Give all rules of English."""
    return Grammar.of(
        amounts.grammar,
        clock_times.grammar,
        calendar.grammar,
        parts_of_days.grammar,
        at_times.grammar,
        from_now.grammar,
        intervals.grammar,
        bounded.grammar,
        repeated.grammar,
    )
