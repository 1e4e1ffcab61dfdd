"""A whole time, with its hedges and its preposition.

``goals`` have their hedges ("about noon"), and so have ``hour_marks`` ("on the hour"); ``prepositions`` bind
them ("shortly after lunch"). ``stacks`` are times said side by side, and ``zones`` belong to a clock time.
"""

from fuzzytime.language.english.at_times import goals, hour_marks, prepositions, stacks, zones
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(goals.grammar, hour_marks.grammar, prepositions.grammar, stacks.grammar, zones.grammar)
