"""What is prepared, and for what: "the bus leaves at 8:05, so be there by 8", "…, leave at ten to"."""

from collections.abc import Sequence

from fuzzytime.language.instruction import Instruction
from fuzzytime.language.meaning.expressions import HourMark, Phrase, Wall, wall_of
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.instants import midnight
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock, Part
from fuzzytime.language.sentence.sketches.its_times.referred import is_there
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import HOUR

HALF = 30
"""Minutes past an hour from which on a mark is one to the next hour: "twenty to"."""


def due_of(
    text: str,
    before: Sequence[Sketch],
    sketch: Sketch,
    instructions: Sequence[Instruction],
    moment: Moment,
) -> float | None:
    """Give when in seconds that happens which an instruction prepares, by those before it; None for none."""
    words = text[: sketch.part.segment.span[0]].lower().split()
    # "The train goes at five past nine, be on the platform by nine"
    bounded = any(phrase.said.constraint is Constraint.BEFORE for phrase in sketch.phrases)
    goes = _goes(sketch)
    if goes and _is_to_the_hour(sketch):
        # "Vet at ten", then "leave at twenty to"
        return _begin_of(instructions[-1]) if before else moment.since
    if before and is_on_the_way(before[-1], sketch):
        return _begin_of(instructions[-1], due=True)
    part = next((part for part in map(_part_due, sketch.phrases) if part is not None), None)
    if part is not None and moment.now is not None:
        here = moment.grounding().now
        return (part.start - (here - midnight(here.date())).total_seconds()) % DAY_SECONDS
    so = words[-1:] == ["so"]
    if not before or not (so or bounded or goes) or before[-1].operation is None:
        return None
    listed = sketch.operation is not None and (sketch.operation.stated or sketch.operation.due is not None)
    # "I need to be at the dentist at ten to three so leave by quarter past two"
    told = before[-1].operation.stated or before[-1].operation.due is not None or (so and _goes(before[-1]))
    if not told or (listed and not so) or _is_past(before[-1], sketch):
        # "Story at seven, lights out by half past" is one after the other, and so is what is due past an
        # hour: "there's a drill at eleven, so have all back by half past".
        return None
    return _begin_of(instructions[-1], due=so)


def _part_due(phrase: Phrase) -> Part | None:
    """Give the part of a day before which something is to be done: "before bed, around ten"."""
    wall = phrase.said.time
    if not isinstance(wall, Wall) or wall.clock is not None or wall.days is not None:
        return None
    return wall.part if phrase.said.constraint is Constraint.BEFORE else None


def _begin_of(instruction: Instruction, *, due: bool = False) -> float | None:
    """Give when something begins, in seconds; of what is repeated, the first of today.

    What is ``due`` begins by its deadline: "I have to be at work by nine, so I need to leave at eight".
    """
    # "From monday the shop opens at eight" begins at eight.
    requirements = sorted(instruction.requirements, key=lambda one: one.constraint is not Constraint.AT)
    said = [one.latest if due and _is_due(one) else one.earliest for one in requirements]
    repeats = instruction.repeats
    said += repeats.occurrences(DAY_SECONDS)[:1] if repeats is not None else ()
    return next((seconds for seconds in said if seconds is not None), None)


def _is_due(requirement: TimeRequirement) -> bool:
    """Whether it is said by when something is to begin; "Sam's here till sunday" says how long it goes on."""
    return requirement.earliest is None and requirement.preposition != "until"


def _goes(sketch: Sketch) -> bool:
    """Whether somebody is to leave, or to be somewhere: "leave at nine"."""
    operation = sketch.operation
    return operation is not None and operation.is_asked and is_there(operation, sketch.lexicon)


def is_on_the_way(before: Sketch, sketch: Sketch) -> bool:
    """Whether somebody sets off for where to be by the order before: "be there by seven and leave at six".

    It is a way of so many hours (``hours_before``): who is at work by nine and leaves at six stays there.
    """
    arrives, leaves, doing = before.operation, sketch.operation, sketch.lexicon.doing
    if arrives is None or leaves is None or not arrives.is_asked or not leaves.is_asked:
        return False
    if not {leaves.lemma, leaves.phrase} & (doing.setting_off | doing.leaving):
        return False
    there = is_there(arrives, sketch.lexicon) or arrives.phrase in doing.getting_there
    if not there or arrives.object is not None or {arrives.lemma, arrives.phrase} & doing.setting_off:
        return False
    walls = [[wall_of(phrase.said.time) for phrase in one.times] for one in (before, sketch)]
    clocks = [[w.clock for w in one if w.clock is not None and w.part is None] for one in walls]
    ways = ((by - at) % DAY_SECONDS for by in _seconds(clocks[0]) for at in _seconds(clocks[1]))
    return any(0 < way <= sketch.lexicon.policy.hours_before * HOUR for way in ways)


def _seconds(clocks: Sequence[Clock]) -> list[int]:
    """Give when in a day some clock times may be, in seconds."""
    return [seconds for clock in clocks for seconds in clock.candidates()]


def _is_past(before: Sketch, sketch: Sketch) -> bool:
    """Whether its time is so many minutes past an hour that is not said, and later in it than what was told.

    "The round starts at half eight, so have the charts out by twenty past" is not.
    """
    clocks = [wall_of(phrase.said.time).clock for phrase in before.phrases]
    minutes = (clock.minute + clock.shift // 60 for clock in clocks if clock is not None)
    told = max((minute % 60 for minute in minutes), default=HALF)
    times = [phrase.said.time for phrase in sketch.phrases]
    return bool(times) and all(isinstance(t, HourMark) and t.open and told < t.minute <= HALF for t in times)


def _is_to_the_hour(sketch: Sketch) -> bool:
    """Whether its time is so many minutes to an hour that is not said."""
    times = [phrase.said.time for phrase in sketch.phrases]
    return bool(times) and all(isinstance(t, HourMark) and t.open and t.minute > HALF for t in times)
