"""What is done again and again between two others of one thing begins behind the one and ends at the other.

"Put the roast in at noon, baste it every half hour and take it out at three".
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.days.relations import Away
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Repeat, Wall
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import MOMENTS, Unit

JUST = Duration(((1, Unit.MINUTE),))
"""How long before the last of them nothing is repeated any more."""


def again_between(sketches: Sequence[Sketch]) -> list[Sketch]:
    """Bound open repetitions by the times of what is asked of the same thing right before and behind."""
    found = list(sketches)
    for place, sketch in enumerate(sketches):
        if not any(_is_open(phrase) for phrase in sketch.phrases):
            continue
        begin = _time_of(sketches[place - 1]) if place and _goes_on(sketches, place) else None
        if begin is None:
            continue
        behind = place + 1 < len(sketches) and _goes_on(sketches, place + 1)
        end = _time_of(sketches[place + 1]) if behind and not sketch.clauses else None
        then = sketch.part.segment.connective == "then"
        phrases = tuple(_bounded(phrase, begin, end, then=then) for phrase in sketch.phrases)
        found[place] = replace(sketch, phrases=phrases)
    return found


def _is_open(phrase: Phrase) -> bool:
    """Whether it repeats, and from when on is not said."""
    time = phrase.said.time
    return isinstance(time, Repeat) and time.starting is None and not time.apart


def _bounded(phrase: Phrase, begin: Wall, end: Wall | None, *, then: bool) -> Phrase:
    """Give a repetition its first time, so long behind a begin, and its end, which is none of its times.

    One of days has those from the day on, or from the next on ("and every monday after that", at that hour).
    """
    time = phrase.said.time
    if not _is_open(phrase) or not isinstance(time, Repeat):
        return phrase
    if time.every is None:
        if begin.days is None or begin.days.grain is not Unit.DAY:
            return phrase
        if not then:
            # "Sow them on sunday and water them every day"
            return phrase.at(replace(time, starting=Wall(begin.days)))
        walls = tuple(replace(wall, clock=wall.clock or begin.clock) for wall in time.walls)
        return phrase.at(replace(time, walls=walls, starting=Wall(Away(1, Unit.DAY, begin.days))))
    until = Offset(JUST, -1, end) if time.until is None and end is not None else time.until
    starting = Offset(replace(time.every, hedges=()), 1, begin)
    return phrase.at(replace(time, starting=starting, until=until, lent=time.until is None))


def _time_of(sketch: Sketch) -> Wall | None:
    """Give the only time at which an instruction is done: a clock time or a day."""
    if len(sketch.phrases) != 1 or sketch.clauses:
        return None
    said = sketch.phrases[0].said
    return said.time if isinstance(said.time, Wall) and said.constraint in MOMENTS else None


def _goes_on(sketches: Sequence[Sketch], place: int) -> bool:
    """Whether an instruction is about the thing of the one before it."""
    first, second = sketches[place - 1], sketches[place]
    if first.operation is None or second.operation is None:
        return False
    closed = second.lexicon.closed
    thing = second.operation.object
    anaphor = thing is not None and thing.lower() in closed.all_anaphors
    return anaphor or second.operation.again or (thing is not None and thing == first.operation.object)
