"""Where something comes among all that is asked for: "do the windows first", "make the coffee last"."""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Order, Span
from fuzzytime.language.sentence.segments.segment import ENDS


def order_words(
    words: Sequence[Word], covered: AbstractSet[int], lexicon: Lexicon
) -> Iterator[tuple[Span, Order]]:
    """Give the words behind what is to be done that say where it comes; ``covered`` are those about time."""
    closed = lexicon.closed
    orders = set(Order)
    for place in range(1, len(words)):
        word = words[place]
        before = words[place - 1].text
        named = before in ENDS or before in closed.no_order_before
        if word.text not in orders or place in covered or named:
            continue
        behind = words[place + 1].text if place + 1 < len(words) else ""
        ends = not behind[:1].isalnum() or place + 1 in covered or behind in lexicon.function_words
        if ends and behind not in closed.prepositions_of_length:
            yield (word.start, word.end), Order(word.text)
