"""What is done day by day from a day on: "starting tomorrow wake me at six", "from now on lock it at ten"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.expressions import Edge, Phrase, Repeat, Said, TimeWord, Wall
from fuzzytime.language.meaning.joined.first_times import beginning
from fuzzytime.language.meaning.joined.throughout import in_part, in_parts_of_each_day, is_clock_time
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import Constraint

HABITS = frozenset({"starting", "from"})
"""Prepositions of days from which on something is done again and again; "not before monday" is done once."""


def days_on(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Let repetitions, and clock times, begin with a day that is said apart from them.

    A day in front of an order is of those that it is joined to, too: "from monday on wake me at six and feed
    the cat at seven".
    """
    found: list[Sketch] = []
    held: Phrase | None = None
    for sketch in sketches:
        if found and ENDS & set(text_between(found[-1], sketch, text)):
            held = None
        days = [
            one for one in sketch.phrases if _is_first_day(one.said) and _goes_on(one, text, sketch.lexicon)
        ]
        own = days[0] if len(days) == 1 else None
        first = own or (held if not days else None)
        told = sketch if first is None else _from_day_on(sketch, first, text)
        if own is not None:
            # "Starting tomorrow take the pill every morning and call Ann at six" asks for one call.
            alone = not sketch.repeats
            held = own if alone and told is not sketch else None
        found.append(told)
    return found


def _from_day_on(sketch: Sketch, first: Phrase, text: str) -> Sketch:
    """Give a sketch whose repetition begins with a day; clock times are on each day from then on."""
    others = [phrase for phrase in sketch.phrases if phrase is not first]
    series = [phrase for phrase in others if isinstance(phrase.said.time, Repeat)]
    repeats = {phrase.said.time for phrase in series}
    repeat = series[0].said.time if len(repeats) == 1 else None
    if not series and first.said.preposition in HABITS and _is_habit(sketch):
        series = _clocks(others, text, sketch.lexicon)
        part = first.said.wall.part
        repeat = in_parts_of_each_day(
            [one.said if part is None else in_part(one.said, part) for one in series]
        )
    if not isinstance(repeat, Repeat) or not repeat.walls:
        return sketch
    began = _beginning(repeat, first.said)
    if began is None:
        return sketch
    hedges = series[0].said.hedges
    told = Said(began, Constraint.EVERY, series[0].said.preposition, hedges, lasting=series[0].said.lasting)
    return sketch.telling((first, *series), told)


def _beginning(repeat: Repeat, first: Said) -> Repeat | None:
    """Give a repetition from a day on; None where it has begun. From now on is no bound."""
    if isinstance(first.time, TimeWord):
        return repeat
    if repeat.starting is not None or not isinstance(first.time, Wall):
        return None
    return beginning(repeat, Wall(first.time.days))


def _is_first_day(said: Said) -> bool:
    """Whether it says from which day on something holds: "from now on", and not "after monday"."""
    if said.constraint is not Constraint.AFTER or said.edge is not Edge.START or said.hedges:
        return False
    return isinstance(said.time, TimeWord) or (said.wall.days is not None and said.wall.clock is None)


def _goes_on(first: Phrase, text: str, lexicon: Lexicon) -> bool:
    """Whether it is a day, or "from now on"; but "at 2:15 from now"."""
    last = text[slice(*first.span)].lower().split()[-1]
    return not isinstance(first.said.time, TimeWord) or last in lexicon.beside.onward


def _is_habit(sketch: Sketch) -> bool:
    """Whether it may be done day by day: "from monday the meeting is at three" is told, and no order."""
    operation = sketch.operation
    if operation is None or operation.stated or operation.negated:
        return False
    return not {operation.lemma, operation.phrase} & sketch.lexicon.moving


def _clocks(phrases: Sequence[Phrase], text: str, lexicon: Lexicon) -> list[Phrase]:
    """Give the clock times of what has no other times, where all of them are meant."""
    clocks = [phrase for phrase in phrases if is_clock_time(phrase.said)]
    between = text[clocks[0].span[1] : clocks[-1].span[0]].lower().split() if clocks else []
    whole = len(clocks) == len(phrases) and lexicon.closed.alternatives.isdisjoint(between)
    return clocks if whole else []
