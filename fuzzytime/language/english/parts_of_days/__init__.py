"""Parts of the day and of longer periods.

``parts`` ("tomorrow morning"), their ends (``edges_of_parts``, ``first_and_last``, ``first_hours``),
and ``meals``.
"""

from fuzzytime.language.english.parts_of_days import edges_of_parts, first_and_last, first_hours, meals, parts
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(
    parts.grammar, first_and_last.grammar, first_hours.grammar, edges_of_parts.grammar, meals.grammar
)
