"""Notes behind what is named, in brackets or not: "swimming at 8.15 (bring towels)", "at seven, no nuts".

They are no instructions, and what stands around them is read as if they were not there: in one tree with it,
they are taken for what is to be done.
"""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span, overlap
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.orders_beside_times import asks_for_deed
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.told.asides_of_needs import said_of

NO = "no"
"""What begins a note of what there is not to be."""

LONGEST = 4
"""Words of ", no loud music please", at most, without its comma."""


def notes_of(scanned: Scanned) -> Iterator[Span]:
    """Give the stretches that are noted behind what is named: brackets, and what there is not to be.

    The brackets begin with an order, or tell how something is, or end an entry behind its time; they have no
    time of their own.
    """
    yield from _bracketed(scanned)
    words, ends = scanned.words, ENDS | {","}
    places = [p for p in range(1, len(words) - 1) if [words[p].text, words[p + 1].text] == [",", NO]]
    phrases = phrases_of(scanned) if places else []
    for place in places:
        corrected = longest_match(words, place + 1, scanned.lexicon.corrections)
        if corrected and len(corrected) > 1:
            # "At six, no wait, at seven"
            continue
        end = next((p for p in range(place + 1, len(words)) if words[p].text in ends), len(words))
        inside, span = words[place + 1 : end], (words[place + 1].start, words[end - 1].end)
        behind = any(phrase.end == place for phrase in phrases)
        alone = 1 < len(inside) <= LONGEST and all(word.is_letters for word in inside)
        # "Call Ann at six, no Bob"
        alone = alone and not any(word.capital for word in inside)
        if behind and alone and not any(overlap(phrase.span, span) for phrase in phrases):
            yield span


def _bracketed(scanned: Scanned) -> Iterator[Span]:
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
        noted = asks_for_deed(inside, scanned.lexicon) or _tells(inside, scanned.lexicon)
        ends = all(one.text in ENDS for one in words[end + 1 : end + 2])
        # "8:10 ovens on (deck 1)" is all a name.
        behind = any(p.end <= place and p.first and words[p.first - 1].is_letters for p in phrases)
        noted = noted or (behind and ends and _adds(inside, scanned.lexicon))
        if noted and not any(overlap(one.span, span) for one in phrases):
            yield span


def _adds(inside: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words in brackets only add something: "booked", "half a tin"; but "if it's dry", "Ann"."""
    if not inside or inside[0].capital or not inside[0].text.isalnum():
        return False
    known = lexicon.closed.joints_of_orders | lexicon.closed.negators | lexicon.closed.alternatives
    return inside[0].text not in known and longest_match(inside, 0, lexicon.clauses) is None


def _tells(inside: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words tell how something is: "that's a lot of towels", "they are filthy"."""
    closed = lexicon.closed
    said = said_of([word.text for word in inside[:2]], closed.anaphors | closed.third_person)
    return not lexicon.asides["being needed"].isdisjoint(said[:1])
