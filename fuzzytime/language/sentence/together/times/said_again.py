"""What is done at several times: "before lunch and again at two", "one at six, the other at ten"."""

from collections.abc import Container, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.calendar import is_day_of_month, is_weekday
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Phrase, Range, Wall
from fuzzytime.language.meaning.times_of_day import Half
from fuzzytime.language.sentence.segments.events.instances import Instances
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint, Unit

SEVERAL = 2
ONE_OF = "one of the "
"""What is said of one of several: "one of the alarms"."""


def done_again(sketch: Sketch, words: Sequence[Word]) -> list[Sketch]:
    """Give one sketch for each time that "and again" joins to those before it.

    Times that go on for a while are of all of them; what else is said belongs to the time that it stands by.
    """
    cuts = list(_cuts(sketch, words))
    if not cuts or sketch.operation is None:
        return [sketch]
    lasting = {phrase.span[0] for phrase in sketch.phrases if phrase.said.constraint is Constraint.FOR}
    ends = pairwise([0, *(cut[1] for cut in cuts), len(words) and words[-1].end])
    return [replace(_of_stretch(sketch, range(*stretch), lasting), joints=tuple(cuts)) for stretch in ends]


def each_of(sketch: Sketch, instances: Instances) -> list[Sketch]:
    """Give one sketch for each of several of one kind; what is said before the first holds for all."""
    first, end = sketch.part.segment.span
    starts = [start for start in instances.starts if first <= start < end]
    operation = sketch.operation
    if len(starts) < SEVERAL or operation is None:
        return [sketch]
    if instances.counted and operation.object is not None:
        # "Give him two pills" has who gets them in front.
        before, counted, behind = (
            operation.object.removesuffix(" and").rstrip(" ,").partition(instances.counted)
        )
        operation = replace(operation, object=f"{before}{ONE_OF}{counted}{behind}" if counted else before)
    leading = (span[0] for span in sketch.heard if span[0] < starts[0] < span[1])
    starts[0] = next(leading, starts[0])
    named = replace(sketch, operation=operation)
    return [_of_stretch(named, range(*stretch), range(starts[0])) for stretch in pairwise([*starts, end])]


def _of_stretch(sketch: Sketch, stretch: range, shared: Container[int]) -> Sketch:
    """Give a sketch with its times and clauses in a stretch, and those that begin at shared places."""

    def is_its(span: Span) -> bool:
        return span[0] in stretch or span[0] in shared

    clauses = tuple(clause for clause in sketch.clauses if is_its(clause.span))
    return replace(sketch.keeping(lambda phrase: is_its(phrase.span)), clauses=clauses)


def _cuts(sketch: Sketch, words: Sequence[Word]) -> Iterator[Span]:
    """Give the stretches between two times that say that something is done again."""
    beside = sketch.lexicon.beside
    for (_, end), (start, _) in pairwise(sorted(sketch.heard)):
        between = {word.text for word in words if end <= word.start < start}
        again = between & beside.twice and between <= beside.beside_twice
        if again and between & {"and", "&", ",", "then"}:
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
            found.append(phrase.at(decided))
        else:
            found.append(phrase)
    return found


def with_shared_clock(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give days of a list the clock time of the last of them: "monday, wednesday and friday at ten"."""
    for giving, others in ((phrases[-1], phrases[:-1]), (phrases[0], phrases[1:])):
        if isinstance(hours := giving.said.time, Range):
            return _with_shared_hours(giving, others, hours) or list(phrases)
    # "At eleven on tuesday and thursday"
    walls = (phrase.said.wall for phrase in (phrases[-1], phrases[0]))
    time = next((wall for wall in walls if wall.clock is not None), None)
    if time is None or not _is_listed(time):
        return list(phrases)
    if not all(_is_listed(phrase.said.wall) for phrase in phrases):
        return list(phrases)
    found = []
    for phrase in phrases:
        own = phrase.said.wall
        found.append(phrase if own.is_timed else phrase.at(replace(own, clock=time.clock)))
    return found


def with_shared_part(phrases: Sequence[Phrase], words: Sequence[Word]) -> list[Phrase]:
    """Give days of a list the part that the first is of: "on the nights of the 4th and 5th"."""
    walls = [phrase.said.wall for phrase in phrases]
    of = "of" in (word.text for word in words[phrases[0].first : phrases[0].end])
    parted = walls[0].part is not None and not any(wall.part for wall in walls[1:])
    if not of or not parted or not all(map(_is_listed, walls)):
        return list(phrases)
    clock = walls[0].clock or walls[-1].clock
    told = (replace(wall, part=walls[0].part, clock=wall.clock or clock, weak=False) for wall in walls)
    return [phrase.at(wall) for phrase, wall in zip(phrases, told, strict=True)]


def _with_shared_hours(giving: Phrase, others: Sequence[Phrase], hours: Range) -> list[Phrase]:
    """Give days of a list the hours of the first or the last: "monday and friday from seven till eleven"."""
    first, last = hours.first, hours.last
    alone = all(_is_listed(phrase.said.wall) and not phrase.said.wall.is_timed for phrase in others)
    if not alone or not isinstance(first, Wall) or not isinstance(last, Wall) or not _is_listed(first):
        return []
    found = [giving]
    for phrase in others:
        days = phrase.said.wall.days
        ends = replace(last, days=days) if last.days is not None else last
        told = replace(giving.said, time=replace(hours, first=replace(first, days=days), last=ends))
        found.append(replace(phrase, said=replace(told, preposition=phrase.said.preposition)))
    return sorted(found, key=lambda phrase: phrase.span)


def _is_listed(wall: Wall) -> bool:
    """Whether it is a day of the week or of some month, or so far from today, as a list may have several."""
    days = wall.days
    if isinstance(days, Relative):
        return days.grain is Unit.DAY
    return is_weekday(days) or is_day_of_month(days)


def _open(phrase: Phrase) -> tuple[int, int, int] | None:
    """Give a clock time without am or pm, and without a day."""
    wall = phrase.said.wall
    clock = wall.clock if wall.days is None and wall.part is None else None
    return None if clock is None or not clock.is_open else (clock.hour, clock.minute, clock.shift)
