"""One of several times of what is repeated: "every day at six or at eight" is done at the first."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Phrase, Repeat, Wall
from fuzzytime.language.meaning.joined.bounded_repeats import is_of_day
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint


def first_of_choices(sketch: Sketch, words: Sequence[Word]) -> tuple[Sketch, list[Span]]:
    """Keep the first of the times of day that "or" joins in a repetition; give where those left out stand.

    A repetition has one time a turn, and no second that may be kept instead of it.
    """
    phrases = list(sketch.phrases)
    left: list[Phrase] = []
    for group in _groups(sketch.phrases, words, sketch.lexicon):
        daily = [phrase for phrase in group if _is_timed(phrase)]
        framed = any(_is_days(phrase) for phrase in sketch.phrases)
        if len(daily) == 1 or (framed and not daily):
            first = _at_time_of(group[0], daily[0]) if daily else group[0]
            phrases[phrases.index(group[0])] = first
            left += group[1:]
    told = replace(sketch, phrases=tuple(phrases)).keeping(lambda phrase: phrase not in left)
    return told, [phrase.span for phrase in left]


def _groups(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[list[Phrase]]:
    """Give the times of day, of any or of each day, that "or" joins: "at six, at seven or at eight"."""
    group, joints = list(phrases[:1]), set[str]()
    for first, second in pairwise(phrases):
        between = {word.text for word in words[first.end : second.first]}
        joins = bool(between) and between <= lexicon.closed.alternatives | {","}
        if joins and all(_is_timed(one) or _is_of_any_day(one) for one in (first, second)):
            group.append(second)
            joints |= between
            continue
        if joints & lexicon.closed.alternatives:
            yield group
        group, joints = [second], set()
    if joints & lexicon.closed.alternatives:
        yield group


def _at_time_of(first: Phrase, daily: Phrase) -> Phrase:
    """Give a repetition at the time of day that is said first: "at six or at eight every day"."""
    repeat, wall = daily.said.time, first.said.time
    if not isinstance(repeat, Repeat) or not isinstance(wall, Wall):
        return first
    clock = wall.clock and replace(wall.clock, bare=False, pair=False)
    walls = (replace(one, clock=clock, part=wall.part) for one in repeat.walls)
    return replace(first, said=daily.at(replace(repeat, walls=tuple(dict.fromkeys(walls)))).said)


def _is_timed(phrase: Phrase) -> bool:
    """Whether it is repeated at a time of day."""
    time = phrase.said.time
    return (
        isinstance(time, Repeat) and bool(time.walls) and all(wall.clock or wall.part for wall in time.walls)
    )


def _is_days(phrase: Phrase) -> bool:
    """Whether it is repeated on days, at no time of them."""
    time = phrase.said.time
    return isinstance(time, Repeat) and any(not wall.clock and not wall.part for wall in time.walls)


def _is_of_any_day(phrase: Phrase) -> bool:
    """Whether it is a time of a day that is not said."""
    return is_of_day(phrase.said.time) and phrase.said.constraint in {None, Constraint.AT, Constraint.BETWEEN}
