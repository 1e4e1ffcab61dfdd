"""What becomes so at a part of the day: "before it gets dark" is before dark, where no reading will tell.

Which words are such, the grammar of time says: "dark" is one, as "after dark" is a time, and "hot" is none.
What the sky does is in the lexicon: "when the sun goes down".
"""

from collections.abc import Iterable, Sequence
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
    side, word = SIDES.get(requirement.constraint), becomes(requirement, lexicon)
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


def becomes(requirement: TimeRequirement, lexicon: Lexicon) -> str | None:
    """Give the part of the day at which some words about time are so.

    It is named by what "it" is, or gets, and by what the sky does: "once it is dark", "before the sun sets".
    """
    condition, anchor = requirement.condition, requirement.anchor
    if anchor is not None and (anchor.target is not None or anchor.lag):
        return None
    said = [word for word in requirement.text.lower().split() if word not in lexicon.closed.articles]
    named = (name for name, forms in lexicon.sky.items() if any(_ends(said, form.split()) for form in forms))
    does = next(named, None)
    if does is not None:
        return None if condition is not None and condition.negated else does
    if condition is not None and condition.subject == IT and not condition.negated:
        return condition.word
    return said[-1] if anchor is not None and (anchor.object or "").lower() == IT else None


def _ends(said: Sequence[str], form: Sequence[str]) -> bool:
    """Whether a text ends with some words, and has its marker before them."""
    return len(said) > len(form) and list(said[-len(form) :]) == list(form)
