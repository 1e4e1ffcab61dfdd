"""A length that nobody said gives way to a time that was said: "meet at 8:15", "register at 8:20".

How long a meeting takes is only assumed. Who says that something else begins five minutes later has told that
it is over by then. Work is cut short by half at most: who paints at nine still paints when Ann is called.
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Lexicon
from fuzzytime.requirement import Constraint, Reference, TimeRequirement, Unit

SHARE = 0.5
"""Share of an assumed length that is left of work at least."""

HOURS = frozenset({Unit.HOUR, Unit.MINUTE, Unit.SECOND})
"""What a clock time is said to."""


def giving_way(skills: Sequence[Interpreted], lexicon: Lexicon, agents: int) -> list[Interpreted]:
    """End what has an assumed length where something else begins that the same hands are wanted for."""
    if agents > 1:
        return list(skills)
    begins = [(one.wish.identifier, hour) for one in skills if (hour := _hour(one)) is not None]
    return [_until(one, begins, lexicon) for one in skills]


def _until(one: Interpreted, begins: Sequence[tuple[str, float]], lexicon: Lexicon) -> Interpreted:
    """Give a skill that is over when the next one begins, where that leaves enough of it."""
    start, length = _hour(one), one.skill.duration
    if start is None or not one.duration.assumed:
        return one
    left = min(
        (hour - start for wish, hour in begins if wish != one.wish.identifier and hour > start),
        default=length,
    )
    met = one.operation is not None and one.operation.lemma in lexicon.doing.meeting
    if left >= length or (left < SHARE * length and not met):
        return one
    elapsed = one.skill.time_until_done if one.skill.time_until_done > length else left
    duration = replace(one.duration, hands_on=left, elapsed=elapsed)
    return replace(one, duration=duration, skill=replace(one.skill, duration=left, elapsed=elapsed))


def _hour(one: Interpreted) -> float | None:
    """Give the clock time, in seconds from now, at which hands are wanted for it; None without one."""
    said = [part for part in one.requirements if _is_clock(part)]
    wanted = one.skill.duration > 0 and len(said) == len(one.requirements) == 1
    return said[0].earliest if wanted else None


def _is_clock(part: TimeRequirement) -> bool:
    """Whether a time is when something begins, by the clock and without a hedge."""
    plain = part.constraint is Constraint.AT and part.reference is Reference.START
    bound = part.anchor is not None or part.condition is not None or part.recurrence is not None
    return plain and part.grain in HOURS and not (bound or part.fuzziness or part.alternative)
