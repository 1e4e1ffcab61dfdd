"""What is done again and again.

By lengths of time: ``repetitions``, or so far ``apart``. By the calendar: ``repeated_days``,
``days_of_each_month``, ``nights_and_weekends``, ``repeated_moments``, but for ``days_left_out``. With more
beside: ``repeated_hours``, ``bounded_repetitions``, ``stretches_of_weekdays``, ``all_through`` a period.
"""

from fuzzytime.language.english.repeated import (
    all_through,
    apart,
    bounded_repetitions,
    days_left_out,
    days_of_each_month,
    nights_and_weekends,
    repeated_days,
    repeated_hours,
    repeated_moments,
    repetitions,
    stretches_of_weekdays,
)
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(
    repetitions.grammar,
    apart.grammar,
    repeated_days.grammar,
    days_left_out.grammar,
    days_of_each_month.grammar,
    nights_and_weekends.grammar,
    repeated_moments.grammar,
    repeated_hours.grammar,
    bounded_repetitions.grammar,
    stretches_of_weekdays.grammar,
    all_through.grammar,
)
