"""Notes in brackets behind what is named: "swimming at 8.15 (bring towels)".

They are no instructions, and what stands around them is read as if they were not there: in one tree with it,
they are taken for what is to be done.
"""

from collections.abc import Iterator

from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.instruction import Span, overlap
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.orders_beside_times import asks_for_deed


def notes_of(scanned: Scanned) -> Iterator[Span]:
    """Give the stretches of brackets that begin with an order, without a time, behind what is named."""
    words = scanned.words
    if "(" not in scanned.text:
        return
    phrases = phrases_of(scanned)
    timed = places_in(phrases)
    for place, word in enumerate(words):
        named = (one for p, one in enumerate(words[:place]) if one.is_letters and p not in timed)
        if word.text != "(" or not any(named):
            continue
        end = next((p for p in range(place, len(words)) if words[p].text in {")", ";"}), len(words))
        inside = words[place + 1 : end]
        span = (word.start, words[min(end, len(words) - 1)].end)
        if asks_for_deed(inside, scanned.lexicon) and not any(overlap(one.span, span) for one in phrases):
            yield span
