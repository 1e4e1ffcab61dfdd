"""From one time to another.

``ranges`` as they are said, those ``lasting`` so long, ``ranges_of_minutes`` and ``hours_open`` of one hour,
``typed_intervals``; those that end in the part of the day that they begin in, ``until_in_parts``.
"""

from fuzzytime.language.english.intervals import (
    hours_open,
    lasting,
    ranges,
    ranges_of_minutes,
    typed_intervals,
    until_in_parts,
)
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(
    ranges.grammar,
    lasting.grammar,
    ranges_of_minutes.grammar,
    hours_open.grammar,
    typed_intervals.grammar,
    until_in_parts.grammar,
)
