"""What is left of the order of steps where one of them cannot be done."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from fuzzytime.interpreter.binding.apart import asks_for_first
from fuzzytime.interpreter.binding.left_out import without
from fuzzytime.interpreter.binding.steps import OWN_TIME
from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.requirement import Constraint
from fuzzytime.skills import Precedence


def loosened(interpretation: Interpretation, rejected: Sequence[bool] | None = None) -> Interpretation:
    """Give an interpretation in which no step waits for one that is not done.

    Parameters
    ----------
    interpretation
        What is understood.
    rejected
        What a schedule rejects; None before there is one, for what nothing can satisfy anyway.

    What comes after a rejected step comes after those before it; a rejected step with a time of its own
    follows nothing any more, so that its time may be kept. What a rejected skill asked to come before does
    not fall with it.
    """
    order, problems = interpretation.order, list(interpretation.problems)
    precedences = interpretation.precedences
    for position, one in enumerate(interpretation.skills):
        hopeless = one.skill.satisfaction.support.empty
        gone = hopeless
        if rejected is not None:
            gone = rejected[position] and not _falls_with(position, interpretation.order, rejected)
        if not gone:
            continue
        lost = rejected is not None and _falls_with(position, interpretation.precedences, rejected)
        precedences = tuple(
            entry
            for entry in precedences
            if entry.first != position or asks_for_first(entry, interpretation.skills)
        )
        frees = not hopeless and not lost and _has_time(one)
        looser = without(order, position, also_before=frees)
        if looser == order:
            continue
        message = (
            f"{one.skill.name}: its time comes before what it was said after: their order is not kept"
            if frees and any(entry.second == position for entry in order)
            else f"{one.skill.name} is not planned: what was said after it goes on without it"
        )
        problems.append(problem_of(one.wish, ProblemKind.NOTE, message, identifier=one.identifier))
        order = looser
    if order == interpretation.order and precedences == interpretation.precedences:
        return interpretation
    return replace(interpretation, order=order, precedences=precedences, problems=tuple(problems))


def may_be_loosened(interpretation: Interpretation) -> bool:
    """Whether what a schedule rejects could loosen what binds the others."""
    asked = (asks_for_first(entry, interpretation.skills) for entry in interpretation.precedences)
    return bool(interpretation.order) or not all(asked)


def _falls_with(position: int, entries: Iterable[Precedence], rejected: Sequence[bool]) -> bool:
    """Whether a rejected step must come after another that is."""
    return any(entry.second == position and rejected[entry.first] for entry in entries)


def _has_time(one: Interpreted) -> bool:
    return any(part.constraint in OWN_TIME | {Constraint.BEFORE} for part in one.requirements)
