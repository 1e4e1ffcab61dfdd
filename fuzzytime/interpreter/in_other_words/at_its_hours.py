"""The hours of a meal, or an evening out, where a day alone is said for it: "dinner with Bob on sunday"."""

from dataclasses import replace
from datetime import datetime

from fuzzytime.language import Instruction, Lexicon, Operation, hours_on_a_day
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.times import DAY, HOUR, SECOND, hours_of_its_day


def at_its_hours(instruction: Instruction, given: datetime, lexicon: Lexicon) -> Instruction:
    """Put what has its hours into those of the day that is said for it, or of that on which it is said.

    What says a time of day, or waits for something, says when by itself. Hours that are over are none.

    Parameters
    ----------
    given
        When the instruction was given.
    """
    hours = hours_on_a_day(instruction.operation, lexicon)
    bounds = [part for part in instruction.requirements if part.constraint is not Constraint.FOR]
    if hours is None or len(bounds) > 1 or not all(map(_is_day, bounds)):
        return instruction
    said = next(iter(bounds), None) or _any_time(instruction.operation)
    if said is None:
        return instruction
    earliest, latest = hours_of_its_day(given, said.earliest or 0.0, *hours)
    if latest <= 0:
        return instruction
    timed = replace(said, earliest=earliest, latest=latest, grain=Unit.HOUR)
    others = tuple(part for part in instruction.requirements if part is not said)
    return replace(instruction, requirements=(timed, *others))


def turn_at_its_hours(
    turn: TimeRequirement, operation: Operation | None, given: datetime, lexicon: Lexicon
) -> TimeRequirement:
    """Put one of what is repeated on whole days into its hours: "have lunch with Ann every friday"."""
    hours = hours_on_a_day(operation, lexicon)
    if hours is None:
        return turn
    start, end = turn.earliest or 0.0, turn.latest or 0.0
    begins, ends = hours_of_its_day(given, start, 0.0, DAY)
    whole = abs(end - ends) < SECOND and (start <= 0.0 or abs(start - begins) < SECOND)
    if not whole:
        return turn
    earliest, latest = hours_of_its_day(given, start, *hours)
    return replace(turn, earliest=earliest, latest=latest, grain=Unit.HOUR)


def _is_day(part: TimeRequirement) -> bool:
    """Whether it leaves nothing open but when on its day."""
    if part.constraint is not Constraint.BETWEEN or part.grain is not Unit.DAY or part.denied:
        return False
    bounded = part.earliest is not None and part.latest is not None and part.anchor is None
    return bounded and not part.alternative and (part.latest or 0.0) - (part.earliest or 0.0) <= DAY + HOUR


def _any_time(operation: Operation | None) -> TimeRequirement | None:
    """Give what is asked where no words say when."""
    if operation is None:
        return None
    return TimeRequirement(text=operation.name, span=operation.span, constraint=Constraint.BETWEEN)
