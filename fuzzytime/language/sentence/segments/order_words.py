"""Where something comes among all that is asked for: "do the windows first", "make the coffee last"."""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings import OWNING
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Order, Span
from fuzzytime.language.sentence.segments.segment import BOUND, ENDS

NAMING = (
    OWNING
    | BOUND
    | ENDS
    | {"it", "them", "second", "next", "long", "far", "at", "to", "and", ","}
    | {"comes", "come", "came", "goes", "is", "are", "was", "were", "that"}
    | {"will", "would", "should", "may", "might", "must", "can", "could", "'ll"}
)
"""Words behind which "first" and "last" are no place in an order: "make it last", "whoever comes first"."""

LASTING = frozenset({"for", "until", "till"})
"""Words before which "last" is a verb: "make the milk last until friday"."""


def order_words(
    words: Sequence[Word], covered: AbstractSet[int], lexicon: Lexicon
) -> Iterator[tuple[Span, Order]]:
    """Give the words behind what is to be done that say where it comes; ``covered`` are those about time."""
    orders = set(Order)
    for place in range(1, len(words)):
        word = words[place]
        if word.text not in orders or place in covered or words[place - 1].text in NAMING:
            continue
        behind = words[place + 1].text if place + 1 < len(words) else ""
        ends = not behind[:1].isalnum() or place + 1 in covered or behind in lexicon.function_words
        if ends and behind not in LASTING:
            yield (word.start, word.end), Order(word.text)
