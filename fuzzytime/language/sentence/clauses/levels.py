"""Levels that say when: "at 60 degrees add the yeast", "stop charging at 90%", "below 5 degrees"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import Span

POINTS = frozenset({".", ","})
"""What stands within a number: "3.5 bar", "1,200 rpm"."""


def level_end(words: Sequence[Word], place: int, lexicon: Lexicon) -> int | None:
    """Give where a level ends that is named at a place, with its number and unit; None where none is."""
    beside = lexicon.beside
    if place >= len(words) or words[place].text not in beside.level_prepositions:
        return None
    end = place + 1
    while end < len(words) and (words[end].text in beside.around_levels or words[end].text in beside.minus):
        end += 1
    first = end
    while end < len(words) and _is_of_number(words, end, first, lexicon):
        end += 1
    if first == end or end == len(words) or words[end].text not in beside.level_units:
        return None
    end += 1
    while end < len(words) and words[end].text in beside.level_scales | beside.levelled:
        end += 1
    return None if end < len(words) and words[end].text in beside.no_levels else end


def levels_behind_joints(words: Sequence[Word], lexicon: Lexicon) -> Iterator[Span]:
    """Give the levels that lead a further order: "heat the milk and | at 60 degrees | add the honey"."""
    for place in range(1, len(words)):
        end = level_end(words, place, lexicon)
        if end is not None and words[place - 1].text in lexicon.closed.joints_of_orders:
            yield words[place].start, words[end - 1].end


def is_level(text: str, lexicon: Lexicon) -> bool:
    """Whether a text is a level, and nothing else."""
    words = words_of(text)
    return level_end(words, 0, lexicon) == len(words)


def _is_of_number(words: Sequence[Word], place: int, first: int, lexicon: Lexicon) -> bool:
    word = words[place]
    within = place > first and word.glued and word.text in POINTS
    return word.is_digits or word.text in lexicon.numbers or within
