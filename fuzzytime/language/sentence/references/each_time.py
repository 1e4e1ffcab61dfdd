"""What is done each time that something repeated is: "turn her every two hours and check her pulse then"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.delayed_recurrence import DelayedRecurrence
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.requirement import Constraint, Edge, TimeRequirement


def each_time(
    requirements: Sequence[TimeRequirement], anchors: Anchors, *, joined: bool
) -> list[TimeRequirement]:
    """Let what counts from something repeated be done as often as that.

    So is what is done at the same time as it ("whenever you turn her"), and what is ``joined`` to it in one
    sentence comes so long after each.
    """
    if any(part.recurrence is not None for part in requirements):
        return list(requirements)
    return [_each_time(part, anchors, joined=joined) for part in requirements]


def _each_time(part: TimeRequirement, anchors: Anchors, *, joined: bool) -> TimeRequirement:
    anchor = part.anchor
    repeated = None if anchor is None or anchor.target is None else anchors.told.repetition(anchor.target)
    if anchor is None or repeated is None or repeated.recurrence is None:
        return part
    lag = 0.0
    if not _is_together(part, anchors):
        interval = repeated.recurrence.interval
        within = repeated.recurrence.endless and (interval is None or 0 < anchor.lag < interval)
        if not joined or not anchor.exact or part.constraint is not Constraint.AFTER or not within:
            return part
        lag = anchor.lag
    later = DelayedRecurrence(repeated.recurrence, lag) if lag else repeated.recurrence
    return replace(
        repeated.shifted(lag),
        text=part.text,
        span=part.span,
        preposition=part.preposition,
        fuzziness=part.fuzziness,
        recurrence=later,
    )


def _is_together(part: TimeRequirement, anchors: Anchors) -> bool:
    """Whether it is said to be done when the other is: "at the same time", "each time you turn her"."""
    beside, anchor = anchors.lexicon.beside, part.anchor
    if part.preposition in beside.each_time:
        return True
    at = part.constraint is Constraint.AT and anchor is not None and anchor.edge is Edge.START
    return at and part.text.lower() in beside.at_the_same_time
