"""What waits, set apart from what is scheduled: nobody has told yet when it may begin.

It is not impossible, and so no loss of a plan; what asked to come behind it waits with it.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from fuzzytime.interpreter.binding.left_out import renumbered, without
from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.skills import Precedence


def apart(interpretation: Interpretation) -> Interpretation:
    """Give an interpretation with what waits set apart, and a problem for each that says for what."""
    skills = _with_who_waits_behind(interpretation)
    waiting = [place for place, one in enumerate(skills) if one.waits]
    if not waiting:
        return interpretation
    order, said = interpretation.order, [_said_of(skills[place]) for place in waiting]
    for place in waiting:
        if any(entry.first == place for entry in order):
            message = f"{skills[place].skill.name} waits: what was said after it goes on without it"
            identifier = skills[place].identifier
            said.append(problem_of(skills[place].wish, ProblemKind.NOTE, message, identifier=identifier))
        order = without(order, place, also_before=False)
    kept = [place for place in range(len(skills)) if place not in waiting]
    moved = {place: new for new, place in enumerate(kept)}
    return replace(
        interpretation,
        skills=tuple(skills[place] for place in kept),
        waiting=tuple(skills[place] for place in waiting),
        precedences=renumbered(interpretation.precedences, moved),
        order=renumbered(order, moved),
        problems=(*interpretation.problems, *said),
    )


def asks_for_first(entry: Precedence, skills: Sequence[Interpreted]) -> bool:
    """Whether the second of two asked for the first: "serve it after frying", not "set it before dinner"."""
    first, second = skills[entry.first], skills[entry.second]
    return first.identifier in second.follows or first.wish.identifier in second.wish.after


def _with_who_waits_behind(interpretation: Interpretation) -> list[Interpreted]:
    """Give the skills, of which those wait as well that are told by one which does."""
    skills = list(interpretation.skills)
    behind = [place for place, one in enumerate(skills) if one.waits]
    for place in behind:
        for other in _told_by(place, interpretation):
            if other not in behind and not skills[other].reason:
                reason = f"{skills[place].skill.name} has no time yet"
                skills[other] = replace(skills[other], waits=True, reason=reason)
                behind.append(other)
    return skills


def _told_by(place: int, interpretation: Interpretation) -> Iterator[int]:
    """Give who asked to come behind a skill, or at some distance before it."""
    for entry in interpretation.precedences:
        asked = asks_for_first(entry, interpretation.skills)
        if entry.first == place and asked:
            yield entry.second
        elif entry.second == place and not asked and entry.maximum_lag < math.inf:
            yield entry.first


def _said_of(one: Interpreted) -> Problem:
    message = f"{one.skill.name}: waits: {one.reason}"
    return problem_of(one.wish, ProblemKind.WAITS, message, identifier=one.identifier)
