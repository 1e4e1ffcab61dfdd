"""Which half of the day a time is in that may be kept instead of another: "at eleven or at one"."""

from dataclasses import replace

from fuzzytime.language.meaning.expressions import Phrase, Wall
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.required.requirements import Grounded
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, NOON, Half
from fuzzytime.requirement import Constraint


def alternative_to(before: tuple[Phrase, Grounded] | None, phrase: Phrase, moment: Moment) -> Phrase:
    """Give an alternative with the half of the day that the time before it, ``before``, leaves it.

    Of two clock times of one day the second is near the first, and what may be "before six or after eight"
    is not before the one and after the other. Without a time before it, it is none.
    """
    said = phrase.said
    if not said.alternative:
        return phrase
    if before is None:
        return replace(phrase, said=replace(said, alternative=False))
    time, other = said.time, before[0].said.time
    if not isinstance(time, Wall) or time.clock is None or not time.clock.is_open or time.part is not None:
        return phrase
    parted = isinstance(other, Wall) and other.part is not None and other.clock is None and time.days is None
    if not parted and not (isinstance(other, Wall) and other.clock is not None and time.days == other.days):
        return phrase
    chosen = _chosen(time.clock.candidates(), before[1], said.constraint, moment)
    if chosen is None:
        return phrase
    decided = replace(time.clock, half=Half.AM if chosen < NOON else Half.PM)
    return replace(phrase, said=replace(said, time=replace(time, clock=decided)))


def _chosen(
    candidates: tuple[int, ...], first: Grounded, constraint: Constraint | None, moment: Moment
) -> int | None:
    """Give which time of day is meant, in seconds since midnight; None where the policy is to say."""
    bound, since = first.requirement.constraint, first.requirement.t_spec
    since = first.requirement.earliest if bound is Constraint.BETWEEN else since
    if moment.now is None or since is None:
        return None
    begun = (moment.now.hour * 3600 + moment.now.minute * 60 + since) % DAY_SECONDS
    if bound is Constraint.BETWEEN or (bound, constraint) == (Constraint.BEFORE, Constraint.AFTER):
        # "This afternoon or at eight", "before six or after eight"
        return min((one for one in candidates if one > begun), default=max(candidates))
    if bound not in {Constraint.AT, constraint}:
        return None
    policy = moment.policy
    awake = range(*(at.hour * 3600 + at.minute * 60 for at in (policy.plausible_from, policy.plausible_to)))
    return min(candidates, key=lambda one: (abs((one - begun + NOON) % DAY_SECONDS - NOON), one not in awake))
