"""What words mean: the tables of a language as values.

The ``lexicon`` has ``word_groups``, with ``verb_groups`` and ``no_time_groups``. Words have a ``spelling``,
too, and names a ``transliteration``.
"""

from fuzzytime.language.grammar.lexicon.lexicon import Entry, Lexicon, Preposition, form_of, longest_match

__all__ = ["Entry", "Lexicon", "Preposition", "form_of", "longest_match"]
