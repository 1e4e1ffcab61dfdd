"""Planning on: what has started stays where it is, holds its agent, and releases what waits for it."""

import math
from collections.abc import Container, Sequence
from dataclasses import replace

from fuzzytime.interpreter.binding.left_out import renumbered
from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.joining import both
from fuzzytime.interpreter.remarks import too_late
from fuzzytime.interpreter.request import Started
from fuzzytime.satisfaction import NEVER, Rectangle
from fuzzytime.skills import Busy, Precedence


def without_started(
    interpretation: Interpretation, started: tuple[Started, ...]
) -> tuple[Interpretation, tuple[Busy, ...]]:
    """Take started skills out of an interpretation, and give the time for which they hold their agents.

    A skill that must come after a started one starts between that one's being done plus the lags, and never
    where it asked to come after one that failed; what must come before a started one is free.
    """
    by_identifier = {one.identifier: one for one in started}
    failed = {one.identifier for one in started if one.done == math.inf}
    open_positions = [
        position
        for position, interpreted in enumerate(interpretation.skills)
        if interpreted.identifier not in by_identifier
    ]
    moved = {position: place for place, position in enumerate(open_positions)}
    skills = {position: _possible(interpretation.skills[position], failed) for position in open_positions}
    for precedence in (*interpretation.precedences, *interpretation.order):
        if precedence.second in moved and precedence.first not in moved:
            first = by_identifier[interpretation.skills[precedence.first].identifier]
            skills[precedence.second] = _released(skills[precedence.second], first, precedence)
    return replace(
        interpretation,
        skills=tuple(skills[position] for position in open_positions),
        precedences=renumbered(interpretation.precedences, moved),
        order=renumbered(interpretation.order, moved),
        problems=_open_problems(interpretation, by_identifier),
    ), _held(interpretation, started)


def _open_problems(interpretation: Interpretation, started: Container[str]) -> tuple[Problem, ...]:
    """Give what is still worth saying, and of each open skill whether it comes too late for a started one."""
    skills = interpretation.skills
    kept = (
        problem
        for problem in interpretation.problems
        if problem.kind is not ProblemKind.NOTE or problem.identifier not in started
    )
    missed = (
        too_late(skills[entry.first], skills[entry.second])
        for entry in interpretation.precedences
        if skills[entry.first].identifier not in started and skills[entry.second].identifier in started
        if not skills[entry.first].skill.satisfaction.support.empty
    )
    return (*kept, *missed)


def _held(interpretation: Interpretation, started: Sequence[Started]) -> tuple[Busy, ...]:
    """Give the time for which started skills still hold their agents."""
    names = {interpreted.identifier: interpreted.skill.name for interpreted in interpretation.skills}
    return tuple(
        Busy(max(0.0, one.start), one.end, names.get(one.identifier, one.identifier), one.agent)
        for one in started
        if one.end > 0
    )


def _possible(interpreted: Interpreted, failed: set[str]) -> Interpreted:
    """Give a skill as it is, or never satisfied where it asked to come after one that failed."""
    lost = next((identifier for identifier in interpreted.follows if identifier in failed), None)
    if lost is None:
        return interpreted
    never = replace(interpreted.skill, satisfaction=NEVER)
    reason = f"must come after {lost}, which failed"
    return replace(interpreted, skill=never, reason=reason, waits=False)


def _released(interpreted: Interpreted, first: Started, precedence: Precedence) -> Interpreted:
    if first.done == math.inf:
        return interpreted
    earliest = first.done + precedence.minimum_lag
    latest = first.done + precedence.maximum_lag
    if earliest <= 0 and latest == math.inf:
        return interpreted
    # A wish whose last moment has passed is late, not lost: it may start as soon as it can.
    window = Rectangle(earliest, max(latest, 0.0, earliest))
    function = both(interpreted.skill.satisfaction, window)
    reason = interpreted.reason
    if function.support.empty and not reason:
        reason = f"must come after {first.identifier}, and that leaves no time that satisfies"
    preferred = interpreted.skill.preferred
    if preferred is None and precedence.wished_lag is not None:
        preferred = first.done + precedence.wished_lag
    skill = replace(interpreted.skill, satisfaction=function, preferred=preferred)
    return replace(interpreted, skill=skill, reason=reason)
