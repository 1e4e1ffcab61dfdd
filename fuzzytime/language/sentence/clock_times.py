"""The last clock time that was said: one without am or pm that follows is hardly before it."""

from collections.abc import Iterable

from fuzzytime.language.meaning.chosen_clocks import FOLLOWING
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.sentence.contradictions import SAID_WHEN
from fuzzytime.requirement import Constraint, TimeRequirement


def last_said(requirements: Iterable[TimeRequirement], since: float | None) -> float | None:
    """Give the last clock time that is said, in seconds; that of before where there is none."""
    for requirement in requirements:
        if requirement.constraint in SAID_WHEN | {Constraint.BEFORE} and requirement.grain in SUB_DAY:
            begin, latest = requirement.earliest, requirement.latest
            if latest is not None and (begin is None or latest - begin > FOLLOWING.total_seconds()):
                # "Charge overnight and be ready at seven"
                begin = latest
            since = begin if begin is not None else since
    return since
