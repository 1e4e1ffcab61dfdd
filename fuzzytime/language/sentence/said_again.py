"""What is done at several times: "before lunch and again at two", "… and another one later"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Phrase, Wall
from fuzzytime.language.meaning.times_of_day import Half
from fuzzytime.language.sentence.sketch import Sketch
from fuzzytime.requirement import Constraint

AGAIN = frozenset({"again", "another", "more", "one"})
"""Words of which one stands between two times of what is done twice."""

JOINING = AGAIN | {"and", "&", ",", "then", "once", "time", "dose"}
"""The words that may stand there."""


def done_again(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for each time that "and again" joins to those before it.

    Times that go on for a while are of all of them; what else is said belongs to the time that it stands by.
    """
    cuts = list(_cuts(sketch, words))
    if not cuts or sketch.operation is None:
        return [sketch]
    found = []
    for first, end in pairwise([0, *(cut[1] for cut in cuts), len(words) and words[-1].end]):
        kept = [
            place
            for place, phrase in enumerate(sketch.phrases)
            if first <= phrase.span[0] < end or phrase.said.constraint is Constraint.FOR
        ]
        found.append(
            replace(
                sketch,
                phrases=tuple(sketch.phrases[place] for place in kept),
                references=tuple(sketch.references[place] for place in kept),
                clauses=tuple(clause for clause in sketch.clauses if first <= clause.span[0] < end),
                joints=tuple(cuts),
            )
        )
    return found


def _cuts(sketch: Sketch, words: Sequence[Word]) -> Iterator[Span]:
    """Give the stretches between two times that say that something is done again."""
    for (_, end), (start, _) in pairwise(sorted(sketch.heard)):
        between = {word.text for word in words if end <= word.start < start}
        if between & AGAIN and between <= JOINING and between & {"and", "&", ",", "then"}:
            yield end, start


def apart(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give times for one thing with clock times that are said twice in both halves of a day: "at 8 and 8"."""
    clocks = [_open(phrase) for phrase in phrases]
    found = []
    for place, phrase in enumerate(phrases):
        time, clock = phrase.said.time, clocks[place]
        if clock is not None and isinstance(time, Wall) and clocks.count(clock) > 1:
            half = Half.PM if clock in clocks[:place] else Half.AM
            decided = replace(time, clock=replace(time.clock, half=half)) if time.clock else time
            found.append(replace(phrase, said=replace(phrase.said, time=decided)))
        else:
            found.append(phrase)
    return found


def with_shared_clock(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give days of the week the clock time of the last of them: "monday, wednesday and friday at ten"."""
    time = phrases[-1].said.time
    if not isinstance(time, Wall) or time.clock is None or not _is_weekday(time):
        return list(phrases)
    walls = [phrase.said.time for phrase in phrases[:-1]]
    if not all(isinstance(wall, Wall) and _is_weekday(wall) for wall in walls):
        return list(phrases)
    found = []
    for phrase in phrases:
        own = phrase.said.time
        alone = isinstance(own, Wall) and own.clock is None and own.part is None
        told = replace(own, clock=time.clock) if alone and isinstance(own, Wall) else own
        found.append(replace(phrase, said=replace(phrase.said, time=told)))
    return found


def _is_weekday(wall: Wall) -> bool:
    return isinstance(wall.days, Fields) and wall.days.weekly


def _open(phrase: Phrase) -> tuple[int, int, int] | None:
    """Give a clock time without am or pm, and without a day."""
    time = phrase.said.time
    clock = time.clock if isinstance(time, Wall) and time.days is None and time.part is None else None
    return None if clock is None or not clock.is_open else (clock.hour, clock.minute, clock.shift)
