"""What becomes so at a part of the day: "before it gets dark" is before dark, where no reading will tell.

Which words are such, the grammar of time says: "dark" is one, as "after dark" is a time, and "hot" is none.
"""

from collections.abc import Iterable
from dataclasses import replace
from datetime import datetime, timedelta

from fuzzytime.language import Lexicon, find_times
from fuzzytime.requirement import Constraint, TimeRequirement, Unit

IT = "it"
BEFORE, AFTER = "before", "after"
SIDES = {Constraint.WHEN: AFTER, Constraint.AFTER: AFTER, Constraint.BEFORE: BEFORE}


def told_by_the_sky(
    requirement: TimeRequirement, others: Iterable[TimeRequirement], given: datetime, lexicon: Lexicon
) -> TimeRequirement | None:
    """Give when something becomes so that the calendar knows, on the day that others name; or None."""
    side, word = SIDES.get(requirement.constraint), becomes(requirement)
    if side is None or word is None:
        return None
    days = (part.earliest for part in others if part.grain is Unit.DAY)
    begin = next((day for day in days if day is not None and day > 0), 0.0)
    found = find_times(f"{side} {word}", given + timedelta(seconds=begin), lexicon).requirements
    if len(found) != 1 or found[0].t_spec is None:
        return None
    return replace(
        found[0].shifted(begin), text=requirement.text, span=requirement.span, reference=requirement.reference
    )


def becomes(requirement: TimeRequirement) -> str | None:
    """Give what "it" is, or gets, by some words about time: "once it is dark", "before it gets dark"."""
    condition, anchor = requirement.condition, requirement.anchor
    if condition is not None and condition.subject == IT and not condition.negated:
        return condition.word
    if anchor is None or anchor.target is not None or anchor.lag or (anchor.object or "").lower() != IT:
        return None
    return anchor.text.lower().split()[-1]
