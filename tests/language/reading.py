"""English as it is shipped, and the moment at which the corpus of sentences is said."""

from functools import cache

from fuzzytime.language import Language
from language.corpus_rows import instant

NOW = instant("2026-03-04T09:00:00")
"""When all sentences of the corpus are said: on a Wednesday, at nine in the morning."""


@cache
def language() -> Language:
    return Language.shipped()
