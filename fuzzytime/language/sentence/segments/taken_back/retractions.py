"""What is let be after all: "call Ann at five; forget that"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span

BEGINS = frozenset({".", ";", "!", ",", "-", "…", "\n"})
ENDS = frozenset({*BEGINS, "?"})


def retractions(words: Sequence[Word], lexicon: Lexicon, corrected: Sequence[Span]) -> Iterator[range]:
    """Give the words that let be what was said before: between two pauses, and behind something.

    Not those in what is ``corrected`` by a time behind them: "tonight. Scratch that, tomorrow morning".
    """
    forms = lexicon.conversation["retracting"]
    for place in range(1, len(words)):
        found = longest_match(words, place, forms) if words[place - 1].text in BEGINS else None
        end = place + len(found or ())
        mends = any(first <= words[place].start < last for first, last in corrected)
        if found is not None and not mends and (end == len(words) or words[end].text in ENDS):
            yield range(place, end)
