"""What a skill waits for where no reading tells of the state that it is to wait for."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime

from fuzzytime.interpreter.in_other_words.by_the_sky import told_by_the_sky
from fuzzytime.interpreter.request import Request
from fuzzytime.language import Lexicon
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement
from fuzzytime.rulebook import Rulebook


def without_readings(
    parts: Sequence[TimeRequirement], given: datetime, request: Request, lexicon: Lexicon
) -> list[TimeRequirement]:
    """Give when what the calendar knows becomes so, where no reading tells of it now, or may later."""
    if request.context.readings or request.awaits_readings:
        return list(parts)
    return [told_by_the_sky(part, parts, given, lexicon) or part for part in parts]


def with_waits(requirement: TimeRequirement, rulebook: Rulebook, request: Request) -> TimeRequirement:
    """Wait for what makes a condition true where no reading tells of it: an instruction, or some time.

    One that is only about the same thing is taken where nothing may tell of it later, either.
    """
    condition = requirement.condition
    if condition is None or condition.about is condition.target is condition.takes is None:
        return requirement
    readings = bool(request.context.readings) or request.awaits_readings
    if readings and rulebook.tells_of(condition, request.context):
        return requirement
    target, takes = condition.target, condition.takes
    assumed = target is None and takes is None
    if target is None and not (assumed and request.awaits_readings):
        target = condition.about
    if target is not None:
        edge = Edge.END if takes is None and not condition.goes_on else Edge.FREE
        anchor = Anchor(text=condition.text, target=target, edge=edge, lag=takes or 0.0, assumed=assumed)
        return replace(requirement, constraint=Constraint.AFTER, condition=None, anchor=anchor)
    if takes is None:
        return requirement
    return replace(requirement, constraint=Constraint.AFTER, condition=None, t_spec=takes, earliest=takes)
