"""What is done with another thing after all, or let be: "feed the cat - no, the dog", "forget that"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.phrases import places_in

AFTER_ALL = "after all"
"""The connective that leads to what is meant instead of a thing before it."""

PAUSES = frozenset({",", "-", ".", "…", ";", "(", "–", "—"})

LONGEST = 4
"""Words of a thing at most: "the old red van"."""

BEGINS = frozenset({".", ";", "!", ",", "-", "…", "\n"})


@dataclass(frozen=True, slots=True)
class CorrectedThing:
    """A thing that is not meant, and the one that is, from ``start`` to ``end``.

    ``pause`` is where what is said of the first ends; ``further`` says that more is asked for behind both.
    """

    pause: int
    start: int
    end: int
    further: bool
    old: Span
    new: Span


def corrected_things(
    words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon
) -> Iterator[CorrectedThing]:
    """Give the things that words behind them take back."""
    covered = places_in(phrases)
    for place in range(1, len(words)):
        marker = longest_match(words, place, lexicon.corrections)
        if marker is None or place in covered or words[place - 1].text not in PAUSES:
            continue
        behind = place + len(marker)
        start = next((p for p in range(behind, len(words)) if words[p].text not in PAUSES), len(words))
        if start == behind and len(marker) == 1:
            # "Buy milk, no sugar"
            continue
        end = _end_of_thing(words, start, covered, lexicon)
        old = None if end is None else _thing_before(words, place, covered, lexicon)
        if end is not None and old is not None:
            new = (words[start].start, words[end - 1].end)
            pause = next(p for p in range(place - 1, -1, -1) if words[p].text not in PAUSES) + 1
            paused = end + 1 < len(words) and words[end].text in PAUSES and words[end].text != "-"
            further = paused and end + 1 not in covered
            said = (words[old.start].start, words[old.stop - 1].end)
            yield CorrectedThing(pause, start, end, further, said, new)


def _end_of_thing(words: Sequence[Word], start: int, covered: frozenset[int], lexicon: Lexicon) -> int | None:
    """Give where a thing ends that is named alone, before a pause or a time; None for other words."""
    inside = (
        p for p in range(start, len(words)) if p in covered or words[p].text in {*PAUSES, "!", "?", ")", "\n"}
    )
    end = next(inside, len(words))
    return end if _is_thing(words, start, end, lexicon) else None


def _is_thing(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words are an article or an owner with a name behind it, or a name with a capital."""
    if not start < end <= start + LONGEST:
        return False
    opened = words[start].text in lexicon.closed.noun_openers and end > start + 1
    rest = words[start + 1 : end] if opened else words[start:end]
    named = opened or all(word.capital for word in rest)
    return named and not any(
        word.text in lexicon.function_words or not word.text[0].isalnum() for word in rest
    )


def _thing_before(
    words: Sequence[Word], place: int, covered: frozenset[int], lexicon: Lexicon
) -> range | None:
    """Give the words of the thing right before a place, or before a time there; None without one."""
    end = place
    while end and (words[end - 1].text in PAUSES or end - 1 in covered):
        end -= 1
    for start in range(end - 1, max(0, end - LONGEST - 1), -1):
        if words[start].text in lexicon.closed.noun_openers:
            return range(start, end) if _is_thing(words, start, end, lexicon) else None
    return range(end - 1, end) if end > 1 and _is_thing(words, end - 1, end, lexicon) else None


def retractions(words: Sequence[Word], lexicon: Lexicon, corrected: Sequence[Span]) -> Iterator[range]:
    """Give the words that let be what was said before: between two pauses, and behind something.

    Not those in what is ``corrected`` by a time behind them: "tonight. Scratch that, tomorrow morning".
    """
    forms = lexicon.conversation["retracting"]
    for place in range(1, len(words)):
        found = longest_match(words, place, forms) if words[place - 1].text in BEGINS else None
        end = place + len(found or ())
        mends = any(first <= words[place].start < last for first, last in corrected)
        if found is not None and not mends and (end == len(words) or words[end].text in {*BEGINS, "?"}):
            yield range(place, end)
