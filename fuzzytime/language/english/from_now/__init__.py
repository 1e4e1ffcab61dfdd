"""Lengths of time from now on, or from what was said before.

``counted`` from now ("in ten minutes"), ``how_long`` ("for ten minutes"), ``elapsed`` ("once an hour is up"),
``marks`` from what was begun ("at 20 minutes"); ``elliptic`` times take what they lack from others.
"""

from fuzzytime.language.english.from_now import counted, elapsed, elliptic, how_long, marks
from fuzzytime.language.grammar.chart import Grammar

grammar = Grammar.of(counted.grammar, how_long.grammar, marks.grammar, elapsed.grammar, elliptic.grammar)
