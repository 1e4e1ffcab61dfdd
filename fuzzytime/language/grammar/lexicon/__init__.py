"""What words mean: the tables of a language as values.

The ``lexicon`` has ``word_groups``, and ``verb_groups`` among them. Words have a ``spelling``, too, and names
a ``transliteration``.
"""

from fuzzytime.language.grammar.lexicon.lexicon import Entry, Lexicon, Preposition, form_of, longest_match

__all__ = ["Entry", "Lexicon", "Preposition", "form_of", "longest_match"]
