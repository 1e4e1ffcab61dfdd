"""What is done each time that something repeated is: "turn her every two hours and check her pulse then"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.recurrences.delayed_recurrence import DelayedRecurrence
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.requirement import Constraint, Edge, TimeRequirement


def each_time(
    requirements: Sequence[TimeRequirement], anchors: Anchors, *, joined: bool
) -> list[TimeRequirement]:
    """Let what counts from something repeated be done as often as that.

    So is what is done at the same time as it ("whenever you turn her"). What is ``joined`` to it in one
    sentence comes so long after each, or behind each ("every morning feed the cat, then walk the dog"),
    unless it has a time of its own.
    """
    if any(part.recurrence is not None for part in requirements):
        return list(requirements)
    found = [_each_time(part, anchors, joined=joined) for part in requirements]
    if not joined or found != list(requirements) or any(map(_is_timed, requirements)):
        return found
    return [_behind_each(part, anchors) for part in found]


def _is_timed(part: TimeRequirement) -> bool:
    """Whether it is a time that is not counted from another instruction."""
    return part.anchor is None and part.constraint not in {Constraint.FOR, Constraint.VAGUE}


def _behind_each(part: TimeRequirement, anchors: Anchors) -> TimeRequirement:
    """Let what comes behind something repeated come behind each of it."""
    anchor = part.anchor
    target = None if anchor is None else anchor.target
    repeated = None if target is None else anchors.told.repetition(target)
    if anchor is None or target is None or repeated is None or repeated.recurrence is None:
        return part
    behind = part.constraint is Constraint.AFTER and anchor.edge is Edge.END and not anchor.exact
    if not behind or not repeated.recurrence.endless or not _holds_for_both(target, repeated, anchors):
        return part
    return replace(
        part, constraint=Constraint.EVERY, recurrence=repeated.recurrence, grain=repeated.grain, number=None
    )


def _holds_for_both(target: int, repeated: TimeRequirement, anchors: Anchors) -> bool:
    """Whether how often holds for what comes behind it, too.

    So it does where it is said in front of both, and of days anywhere: who stirs "every ten minutes, then"
    serves, does so once.
    """
    interval = repeated.recurrence.interval if repeated.recurrence is not None else None
    operation = anchors.operation_at(target)
    in_front = operation is not None and repeated.span[1] <= operation.span[0]
    return in_front or interval is None or interval >= DAY_SECONDS


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
