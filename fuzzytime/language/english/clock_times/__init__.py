"""Times of day as a clock shows them.

``clocks`` as they are said and typed, ``hours_with_h`` ("15h30"), ``minutes_past`` ("a quarter past
three").
"""

from fuzzytime.language.english.clock_times import clocks, hours_with_h, minutes_past
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(clocks.grammar, hours_with_h.grammar, minutes_past.grammar)
