"""A plan as plain data, by the JSON Schema `fuzzytime-plan/1` that ships beside this package."""

import math
from collections import defaultdict
from typing import Any

from fuzzytime.interpreter import Interpreted, Plan, Problem
from fuzzytime.requirement import TimeRequirement
from fuzzytime.satisfaction import Either, Rectangle, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.scheduling import best_alone

SCHEMA = "fuzzytime-plan/1"

Json = dict[str, Any]
"""A JSON object; its shape is the schema's matter, not the type checker's."""


def document_of(plan: Plan) -> Json:
    """Give the whole plan as one JSON object."""
    schedule = plan.schedule
    certificate = schedule.certificate
    return {
        "schema": SCHEMA,
        "now": plan.request.now.isoformat(),
        "agents": plan.request.agents,
        "horizon_s": plan.interpretation.horizon,
        "threshold": schedule.threshold,
        "satisfaction": {
            "product": schedule.satisfaction,
            "cost": schedule.cost,
            "weighted_cost": schedule.weighted_cost,
            "geometric_mean": schedule.geometric_mean,
            "least": min(schedule.satisfactions, default=1.0),
        },
        "certificate": {
            "status": certificate.status.value,
            "upper_bound": finite(certificate.upper_bound),
            "lower_cost": finite(certificate.lower_cost),
            "gap": finite(certificate.gap),
            "method": certificate.method,
            "seconds": certificate.seconds,
            "clash": [plan.skills[position].identifier for position in schedule.clash],
        },
        "busy": [
            {
                "start": plan.instant(busy.start).isoformat(),
                "start_s": busy.start,
                "end_s": busy.end,
                "what": busy.what,
                "agent": busy.agent,
            }
            for busy in plan.request.busy
        ],
        "skills": skills_of(plan),
        "waiting": [_waiting(one) for one in plan.waiting],
        "problems": [problem_of(problem) for problem in plan.problems],
    }


def skills_of(plan: Plan) -> list[Json]:
    """Give each skill as a JSON object, in the order of the request."""
    return [_skill(plan, position, interpreted) for position, interpreted in enumerate(plan.skills)]


def _skill(plan: Plan, position: int, interpreted: Interpreted) -> Json:
    schedule = plan.schedule
    skill, specific = interpreted.skill, schedule.skills[position]
    acceptable = skill.satisfaction.acceptable()
    return {
        **_asked(interpreted),
        "start": plan.instant(specific.start).isoformat(),
        "start_s": specific.start,
        "end_s": specific.end,
        "done_s": specific.done,
        "duration_s": specific.duration,
        "duration_source": interpreted.duration.source,
        "agent": specific.agent,
        "priority": skill.priority,
        "satisfaction": schedule.satisfactions[position],
        "alone": best_alone(schedule.task, position, specific.start).satisfaction,
        "rejected": schedule.rejected[position],
        "reason": interpreted.reason or None,
        **_when(interpreted),
        "satisfaction_function": function_of(skill.satisfaction),
        "rules": _rules(interpreted),
        "acceptable": None if acceptable.empty else [max(0.0, acceptable.low), acceptable.high],
    }


def _waiting(interpreted: Interpreted) -> Json:
    """Give what has no time yet: nobody has told what it waits for."""
    return {
        **_asked(interpreted),
        "duration_s": interpreted.skill.duration,
        "duration_source": interpreted.duration.source,
        "priority": interpreted.skill.priority,
        "reason": interpreted.reason,
        **_when(interpreted),
    }


def _asked(interpreted: Interpreted) -> Json:
    """Give what is to be done, and which words asked for it."""
    skill = interpreted.skill
    return {
        "id": interpreted.identifier,
        "instruction": interpreted.words,
        "line": interpreted.wish.line,
        "name": skill.name,
        "operation": _operation(interpreted),
        "happens": skill.happens,
        "in_passing": skill.in_passing,
        "fuzzy_parameters": [
            {"text": parameter.text, "noun": parameter.noun, "quantity": parameter.quantity}
            for parameter in skill.fuzzy_parameters
        ],
    }


def _when(interpreted: Interpreted) -> Json:
    """Give what was said about its time."""
    return {
        "requirement": requirement_of(interpreted.requirements[0]) if interpreted.requirements else None,
        "requirements": [requirement_of(requirement) for requirement in interpreted.requirements],
    }


def _operation(interpreted: Interpreted) -> Json | None:
    operation = interpreted.instruction.operation if interpreted.instruction is not None else None
    if operation is None:
        return None
    return {"verb": operation.verb, "object": operation.object, "place": operation.place}


def requirement_of(requirement: TimeRequirement) -> Json:
    """Give a time requirement in the terms of the plan's schema."""
    return {
        "text": requirement.text,
        "reference": requirement.reference.value,
        "constraint": requirement.constraint.value,
        "preposition": requirement.preposition,
        "word": requirement.word,
        "fuzziness": " ".join(requirement.fuzziness) or None,
        "number": requirement.number,
        "unit": requirement.unit.value if requirement.unit is not None else None,
        "t_spec_s": requirement.t_spec,
        "earliest_s": requirement.earliest,
        "latest_s": requirement.latest,
        **({"alternative": True} if requirement.alternative else {}),
        **_repeats(requirement),
    }


def _repeats(requirement: TimeRequirement) -> Json:
    """Give how often it comes, of one occurrence of a repetition."""
    recurrence = requirement.recurrence
    if recurrence is None:
        return {}
    return {"repeats": {"interval_s": recurrence.interval, "endless": recurrence.endless}}


def function_of(function: SatisfactionFunction) -> Json:
    """Give ψ by its shape: triangles and rectangles are trapezoids; everything else is as it is."""
    if isinstance(function, Either):
        return {"model": function.model, "parameters": {"functions": [*map(function_of, function.functions)]}}
    if isinstance(function, (Trapezoid, Triangle, Rectangle)):
        function = Trapezoid(*function.corners)
    return {"model": function.model, "parameters": function.parameters}


def _rules(interpreted: Interpreted) -> list[Json]:
    """Give the rows and rules behind ψ; those of several requirements stand one after the other."""
    shares: dict[tuple[str, str], float] = defaultdict(float)
    for resolution in interpreted.resolutions:
        for share in resolution.shares:
            shares[share.name, share.source] += share.share
    return [{"name": name, "source": source, "share": share} for (name, source), share in shares.items()]


def problem_of(problem: Problem) -> Json:
    """Give a problem as a JSON object."""
    return {
        "kind": problem.kind.value,
        "message": problem.message,
        "line": problem.line,
        "instruction": problem.text or None,
        "span": list(problem.span) if problem.span is not None else None,
        "id": problem.identifier or None,
    }


def finite(number: float) -> float | None:
    """Give a number that JSON can hold, None where there is no bound."""
    return number if math.isfinite(number) else None
