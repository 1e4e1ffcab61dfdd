"""How much of a unit, and lengths of time.

``numbers``; ``durations`` ("an hour and a half"), and ``durations_between`` two ("an hour or two").
"""

from fuzzytime.language.english.amounts import durations, durations_between, numbers
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(numbers.grammar, durations.grammar, durations_between.grammar)
