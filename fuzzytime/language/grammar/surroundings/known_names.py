"""Idioms and names that hold a word about time, known by the tables: of bands, films, brands."""

from collections.abc import Sequence
from functools import lru_cache

from fuzzytime.language.grammar.lexicon import Lexicon, form_of, longest_match
from fuzzytime.language.grammar.words import Word


@lru_cache(maxsize=4)
def _forms(texts: frozenset[str]) -> dict[str, list[tuple[str, ...]]]:
    """Give forms of some words by their first."""
    found: dict[str, list[tuple[str, ...]]] = {}
    for form in map(form_of, sorted(texts)):
        found.setdefault(form[0], []).append(form)
    return found


def named_in(words: Sequence[Word], lexicon: Lexicon) -> frozenset[int]:
    """Give the places of words of such names: of idioms, and of titles, those with capitals if so typed.

    A name with capitals is one where other words have none: not in "Call Ann After Eight".
    """
    kinds, found = lexicon.no_times, set[int]()
    for start, word in enumerate(words):
        for texts in (kinds.idioms, kinds.capital_names):
            forms = _forms(texts).get(word.text)
            form = longest_match(words, start, forms) if forms else None
            if form is not None and (texts is kinds.idioms or _is_typed(words, start, len(form), lexicon)):
                found.update(range(start, start + len(form)))
    return frozenset(found)


def _is_typed(words: Sequence[Word], start: int, length: int, lexicon: Lexicon) -> bool:
    """Whether a name is typed with its capitals, where other words are small."""
    inside, others = words[start : start + length], (*words[:start], *words[start + length :])
    small = lexicon.closed.of_titles
    capitals = all(word.capital or not word.is_letters or word.text in small for word in inside)
    return capitals and any(word.is_letters and not word.capital for word in others)
