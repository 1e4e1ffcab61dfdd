"""When something is to be done that is not to be done at some time: "not on friday", "any time but noon"."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.requirement import Constraint, Recurrence, TimeRequirement

FAR = 21 * DAY_SECONDS
"""Seconds up to which the occurrences of a repetition are left out: "never on sundays"."""

Stretch = tuple[float, float]
"""From when to when, in seconds; open sides are infinite."""


def beside(
    denied: Sequence[TimeRequirement], recurrence: Recurrence | None, moment: Moment
) -> tuple[TimeRequirement, ...]:
    """Give the times left beside those at which something is not to be done: one of them is enough.

    "Not at lunch" is before lunch or after it; "not this week" is after this week.

    Raises
    ------
    UngroundedError
        If it is not known when it is not to be done: "not soon".
    """
    if recurrence is not None:
        stretches = list(recurrence.windows(FAR))
    else:
        stretches = [stretch for one in denied if (stretch := _stretch(one)) is not None]
    left = list(_left(sorted(_kept_off(stretches, moment.policy.kept_off * 60.0))))
    if not stretches or not left:
        raise UngroundedError("when not to do something is not known, so it is not used")
    return tuple(_required(denied[0], stretch, place > 0) for place, stretch in enumerate(left))


def _stretch(requirement: TimeRequirement) -> Stretch | None:
    """Give from when to when something is not to be done; None where that is not known."""
    begin, end = requirement.earliest, requirement.latest
    if begin is None and end is None:
        return None
    return -math.inf if begin is None else begin, math.inf if end is None else end


def _kept_off(stretches: Sequence[Stretch], width: float) -> Iterator[Stretch]:
    """Give stretches with room beside moments: "not at noon" is not at one minute past it."""
    for begin, end in stretches:
        yield (begin - width, end + width) if begin == end else (begin, end)


def _left(denied: Sequence[Stretch]) -> Iterator[Stretch]:
    """Give what is left between stretches, from now on."""
    over = -math.inf
    for begin, end in denied:
        if begin > max(over, 0.0):
            yield over, begin
        over = max(over, end)
    if over < math.inf:
        yield over, math.inf


def _required(denied: TimeRequirement, stretch: Stretch, alternative: bool) -> TimeRequirement:  # noqa: FBT001 - as the field
    """Give one of the times that are left, in the words of the one that is denied."""
    begin, end = (None if math.isinf(side) else side for side in stretch)
    bound, preposition = Constraint.BETWEEN, "between"
    if begin is None:
        bound, preposition = Constraint.BEFORE, "no later than"
    elif end is None:
        bound, preposition = Constraint.AFTER, "not before"
    return replace(
        denied,
        constraint=bound,
        preposition=preposition,
        fuzziness=(),
        word=None,
        t_spec=end if begin is None else begin if end is None else None,
        earliest=begin,
        latest=end,
        recurrence=None,
        number=None,
        unit=None,
        alternative=alternative,
    )
