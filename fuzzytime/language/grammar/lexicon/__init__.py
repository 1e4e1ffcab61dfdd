"""What words mean: the tables of a language as values.

The ``lexicon`` has ``word_groups``, with ``groups_beside_times``, ``verb_groups`` and ``no_time_groups``.
What is said in several words has ``forms``; words have a ``spelling``, too, and names a ``transliteration``.
"""

from fuzzytime.language.grammar.lexicon.forms import Form, Forms, form_of, longest_match
from fuzzytime.language.grammar.lexicon.lexicon import Entry, Lexicon, Preposition

__all__ = ["Entry", "Form", "Forms", "Lexicon", "Preposition", "form_of", "longest_match"]
