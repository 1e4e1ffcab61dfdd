"""What is let be after all: "call Ann at five; forget that"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word

BEGINS = frozenset({".", ";", "!", ",", "-", "…", "\n"})
ENDS = frozenset({*BEGINS, "?"})


def retractions(words: Sequence[Word], lexicon: Lexicon) -> Iterator[range]:
    """Give the words that let be what was said before: between two pauses, and behind something."""
    forms = lexicon.conversation["retracting"]
    for place in range(1, len(words)):
        found = longest_match(words, place, forms) if words[place - 1].text in BEGINS else None
        end = place + len(found or ())
        if found is not None and (end == len(words) or words[end].text in ENDS):
            yield range(place, end)
