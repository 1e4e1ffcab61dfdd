"""What is done day by day for so long: "three times a day with food for two days", "at night for a week"."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.understood.filled import apart
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import Coming, Duration, Phrase, Repeat, Said, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat, is_of_day
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.joined.throughout import THROUGHOUT, in_part, in_parts_of_each_day
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint, Reference, Unit


def day_by_day(sketch: Sketch, text: str) -> Sketch:
    """Let a length of days bound the repetition beside it, or put what is in a part of the day on each day.

    Of several parts of the day, each is on each day; what is at a clock time may begin there.
    """
    lengths = [phrase for phrase in sketch.phrases if _is_of_days(phrase.said)]
    if len(lengths) != 1:
        return sketch
    bound = lengths[0].said
    bound = replace(bound, constraint=Constraint.FOR) if isinstance(bound.time, Duration) else bound
    series = [phrase for phrase in sketch.phrases if isinstance(phrase.said.time, Repeat)]
    if not series and not _goes_on(sketch):
        series = _of_each_day(sketch, lengths[0], text)
    repeat = _repeated(series, _nightly(lengths[0], text, sketch.lexicon))
    bounded = None if repeat is None else _within(repeat, bound)
    if bounded is None:
        return sketch
    told = Said(bounded, Constraint.EVERY, series[0].said.preposition, series[0].said.hedges)
    both = (*series, lengths[0])
    return replace(
        sketch,
        phrases=tuple(
            replace(one, said=replace(one.said.borrowing(told), lasting=_lasting(one.said)))
            if one in both
            else one
            for one in sketch.phrases
        ),
    )


def _lasting(said: Said) -> Duration | None:
    """Give how long each time of a repetition is: "an hour a day for a week" is an hour on each day."""
    return said.lasting if isinstance(said.time, Repeat) else None


def each_day_too(sketch: Sketch, words: Sequence[Word]) -> Sketch:
    """Put a part of the day on each day that "and" joins to others: "before each meal and at bedtime"."""
    for first, second in pairwise(sketch.phrases):
        between = {word.text for word in words[first.end : second.first]}
        series = [one.said.time for one in (first, second) if isinstance(one.said.time, Repeat)]
        parts = [one.said for one in (first, second) if _is_part(one)]
        if len(series) != 1 or len(parts) != 1 or not between or between - sketch.lexicon.closed.additions:
            continue
        more = in_parts_of_each_day(parts) if _is_daily_in_parts(series[0]) else None
        if more is not None:
            told = Said(replace(series[0], walls=(*series[0].walls, *more.walls)), Constraint.EVERY)
            both = (first, second)
            return replace(
                sketch, phrases=tuple(replace(p, said=told) if p in both else p for p in sketch.phrases)
            )
    return sketch


def _is_daily_in_parts(repeat: Repeat) -> bool:
    """Whether it is in parts of every day, and nothing else."""
    days = {(wall.days, wall.clock, wall.part is None) for wall in repeat.walls}
    return days == {(Cycle(Unit.DAY), None, False)} and repeat == Repeat(
        walls=repeat.walls, plural=repeat.plural
    )


def _repeated(series: Sequence[Phrase], part: Part | None) -> Repeat | None:
    """Give the repetition that is said, or that times of the day are on each day, in a part of it."""
    if len(series) == 1 and isinstance(series[0].said.time, Repeat):
        return series[0].said.time
    # "At seven and seven"
    said = [phrase.said for phrase in apart(series)]
    return in_parts_of_each_day([one if part is None else in_part(one, part) for one in said])


def _nightly(length: Phrase, text: str, lexicon: Lexicon) -> Part | None:
    """Give the part of the day that a length counts: "for the next three nights lock the door at ten"."""
    counted = text[slice(*length.span)].lower().rpartition(" ")[2]
    return next((one.value for one in lexicon.entries.get(counted, ()) if one.category == "parts"), None)


def _within(repeat: Repeat, bound: Said) -> Repeat | None:
    """Give a repetition within a length of days, or all through a period: "all next week wake me at six"."""
    if isinstance(bound.time, Wall):
        return narrowed_repeat(repeat, bound.time)
    return bounded_repeat(repeat, bound)


def _is_of_days(said: Said) -> bool:
    """Whether it is a length of two days or more, said in days or longer units, or all of a longer period."""
    time = said.time
    if isinstance(time, Wall):
        return said.preposition == THROUGHOUT
    length = time.duration if isinstance(time, Coming) and time.direction > 0 else time
    if not isinstance(length, Duration) or said.constraint not in {Constraint.FOR, Constraint.BETWEEN}:
        return False
    return length.unit not in SUB_DAY and length.seconds > UNIT_SECONDS[Unit.DAY]


def _of_each_day(sketch: Sketch, length: Phrase, text: str) -> list[Phrase]:
    """Give the parts of a day that is not said, where all of them are meant.

    So of clock times, if what is to be done is soon over ("water the plants at seven for a week"), or the
    days are not how long it lasts: "for three days lock the door at ten", "run it at ten for the next days".
    """
    times = [phrase for phrase in sketch.phrases if _is_part(phrase)]
    operation = sketch.operation
    if not times and operation is not None:
        in_front = length.span[1] <= operation.span[0]
        apart = in_front or not isinstance(length.said.time, Duration)
        if not apart and not _is_soon_over(operation, sketch.lexicon):
            return []
        walls = ((phrase, phrase.said.wall) for phrase in sketch.phrases)
        times = [phrase for phrase, wall in walls if wall.days is None and wall.clock is not None]
    between = text[times[0].span[1] : times[-1].span[0]].lower().split() if times else []
    return times if sketch.lexicon.closed.alternatives.isdisjoint(between) else []


def _is_part(phrase: Phrase) -> bool:
    """Whether it is a part of a day that is not said, or one side of it."""
    return is_of_day(phrase.said.time) and phrase.said.wall.clock is None


def _is_soon_over(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether what is done takes no days: "take the pill at seven for a week"."""
    brought = operation.lemma in lexicon.doing.bringing and operation.place is not None
    return not brought and operation.lemma in lexicon.dosing | lexicon.doing.by_the_day


def _goes_on(sketch: Sketch) -> bool:
    """Whether it is what goes on for days itself: "rent a car in the morning for three days"."""
    operation: Operation | None = sketch.operation
    if operation is None or operation.stated or Reference.THROUGHOUT in sketch.references:
        return True
    return operation.lemma in sketch.lexicon.doing.for_days | sketch.lexicon.timing
