"""Days said apart from their clock times: "tomorrow open the blinds at seven".

A day in front of an order holds for all that is joined to it; a day with a clock time for the clock times
behind it; any other for the times of its own instruction.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from fuzzytime.language.meaning.beside import told_apart
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Range, Repeat, Said, Wall
from fuzzytime.language.sentence.drafts import Heading
from fuzzytime.language.sentence.segments import ENDS
from fuzzytime.language.sentence.sketch import Sketch
from fuzzytime.requirement import Constraint, Unit

HEADED = "heading"
"""The rule of a day that a line above says."""

WHEN = frozenset({None, Constraint.AT, Constraint.BETWEEN, Constraint.EVERY})
"""How a day binds on which something is to be done."""


@dataclass(frozen=True, slots=True)
class _Day:
    """A day that holds for instructions behind; ``phrase`` where it holds for those without a time too."""

    said: Said
    phrase: Phrase | None = None


def on_their_days(sketches: Sequence[Sketch], text: str, heading: Heading | None = None) -> list[Sketch]:
    """Put each time of some instructions on the day that was said for it elsewhere.

    That is in the same sentence, or on a line above, as a heading.
    """
    placed: list[Sketch] = []
    above = None if heading is None else _Day(heading.said, Phrase(heading.said, 0, 0, (0, 0), HEADED))
    held = above
    for sketch in sketches:
        if placed and ENDS & set(text[placed[-1].part.segment.span[1] : sketch.part.segment.span[0]]):
            held = above
        named = [place for place, phrase in enumerate(sketch.phrases) if _is_day(phrase.said)]
        named += [place for place, phrase in enumerate(sketch.phrases) if _is_first_day(phrase.said)]
        told = sketch
        if named:
            told = _on_own_day(sketch, named[0])
        elif held is not None:
            told = _on_day(sketch, held)
        held = _day_of(sketch) or held
        placed.append(told)
    return placed


def _is_day(said: Said) -> bool:
    """Whether it is a day, a part of one, or a repetition of days, without a clock time."""
    time = said.time
    if isinstance(time, Repeat):
        timed = any(wall.clock is not None for wall in time.walls)
        return bool(time.walls) and not timed and time.starting is None and time.until is None
    return isinstance(time, Wall) and time.clock is None and not time.weak and said.constraint in WHEN


def _is_at_most(said: Said) -> bool:
    """Whether it is a length of time that something takes no longer than."""
    return isinstance(said.time, Duration) and said.preposition == "within"


def _is_first_day(said: Said) -> bool:
    """Whether it is a day from which on something holds: "from monday on sign in by ten to nine"."""
    time = said.time
    days = time.days if isinstance(time, Wall) and time.clock is None and time.part is None else None
    return said.constraint is Constraint.AFTER and days is not None and days.grain is Unit.DAY


def _is_open(said: Said, day: Said) -> bool:
    """Whether it is a time of day, or a weekday in the week that is said; not a second day."""
    time = said.time
    if isinstance(time, Offset):
        return isinstance(time.anchor, Wall) and time.anchor.clock is not None and time.anchor.days is None
    if isinstance(time, Range):
        ends = (time.first, time.last)
        return all(isinstance(end, Wall) and end.clock is not None and end.days is None for end in ends)
    if not isinstance(time, Wall):
        return False
    if time.days is None:
        return True
    coarse = isinstance(day.time, Wall) and day.time.days is not None and day.time.days.grain is not Unit.DAY
    return coarse and isinstance(time.days, Fields) and time.days.weekly


def _on_own_day(sketch: Sketch, place: int) -> Sketch:
    """Put the other times of an instruction on its day; those of a repetition are all of it."""
    day, phrases = sketch.phrases[place].said, list(sketch.phrases)
    repeated = [place]
    for other, phrase in enumerate(sketch.phrases):
        if other != place and _is_at_most(phrase.said):
            # "Run it in under 25 minutes on saturday"
            hedges = ("at most", *phrase.said.hedges)
            told_length = replace(phrase.said, constraint=Constraint.FOR, preposition="for", hedges=hedges)
            phrases[other] = replace(phrase, said=told_length)
            continue
        told = told_apart(phrase.said, day) if other != place and _is_open(phrase.said, day) else None
        if told is None:
            continue
        phrases[other] = replace(phrase, said=told)
        if isinstance(told.time, Repeat):
            day = told
            repeated.append(other)
    if len(repeated) > 1:
        for other in repeated:
            said = phrases[other].said
            phrases[other] = replace(phrases[other], said=replace(said, time=day.time))
    return replace(sketch, phrases=tuple(phrases))


def _on_day(sketch: Sketch, held: _Day) -> Sketch:
    """Put the times of an instruction on a day that was said before it; without a time, it has that day."""
    if held.phrase is not None and not sketch.phrases and not sketch.clauses:
        alone = sketch.part.segment.connective in {"", "and"} and sketch.operation is not None
        return replace(sketch, phrases=(held.phrase,), references=(None,)) if alone else sketch
    phrases = []
    for phrase in sketch.phrases:
        told = told_apart(phrase.said, held.said) if _is_open(phrase.said, held.said) else None
        phrases.append(phrase if told is None else replace(phrase, said=told))
    return replace(sketch, phrases=tuple(phrases))


def _day_of(sketch: Sketch) -> _Day | None:
    """Give the day that an instruction hands on to those joined to it."""
    start = sketch.operation.span[0] if sketch.operation is not None else 0
    for phrase in sketch.phrases:
        said = phrase.said
        if _is_day(said) and phrase.span[1] <= start:
            return _Day(said, phrase)
        if isinstance(said.time, Wall) and said.time.clock is not None and said.time.days is not None:
            return _Day(Said(Wall(said.time.days)))
    return None
