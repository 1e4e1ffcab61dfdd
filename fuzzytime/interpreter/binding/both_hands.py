"""What was to be done during something else, and is behind it in a plan, as both keep the hands."""

import math
from collections.abc import Iterator

from fuzzytime.interpreter.interpretation import Interpretation, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.requirement import TimeRequirement
from fuzzytime.scheduling import Schedule
from fuzzytime.skills import Precedence

NEARLY = 1e-6
"""Seconds by which times may differ that are the same."""


def behind_each_other(interpretation: Interpretation, schedule: Schedule) -> Iterator[Problem]:
    """Say of what was to be done during something else that it only comes once that is done."""
    for entry in interpretation.precedences:
        if not _is_during(entry) or schedule.rejected[entry.first] or schedule.rejected[entry.second]:
            continue
        first, second = interpretation.skills[entry.first], interpretation.skills[entry.second]
        done = schedule.start_times[entry.first] + first.skill.time_until_done
        keeps = first.keeps_hands >= first.skill.time_until_done > 0 < second.skill.duration
        named = any(map(_names_another, second.requirements))
        if keeps and named and schedule.start_times[entry.second] >= done - NEARLY:
            message = (
                f"{second.skill.name} comes behind {first.skill.name}, and not during it: both keep the hands"
            )
            yield problem_of(second.wish, ProblemKind.NOTE, message, identifier=second.identifier)


def _names_another(part: TimeRequirement) -> bool:
    """Whether words name what something is done during, as "meanwhile" does not."""
    anchor = part.anchor
    return anchor is not None and (anchor.exact or anchor.verb is not None or anchor.object is not None)


def _is_during(entry: Precedence) -> bool:
    """Whether one was wished to begin before the other is done, and not long after that begins."""
    wished = -math.inf if entry.wished_lag is None else entry.wished_lag
    if entry.maximum_lag == math.inf:
        # Behind it, where one agent does both.
        return entry.minimum_lag < 0 and wished == 0
    return entry.minimum_lag < 0 and wished < 0
