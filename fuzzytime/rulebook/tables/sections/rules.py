"""Reading rules, and how their conditions join degrees."""

from collections.abc import Mapping
from types import MappingProxyType

from fuzzytime.documents.nodes import Mapping as MappingNode
from fuzzytime.documents.nodes import Node, Scalar
from fuzzytime.rulebook.logic.formula import Formula
from fuzzytime.rulebook.logic.grammar import parse_condition
from fuzzytime.rulebook.logic.norms import Norm
from fuzzytime.rulebook.tables.matching import Match
from fuzzytime.rulebook.tables.rules import Effect, Rule
from fuzzytime.rulebook.tables.sections.rows import read_match
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.sections.widths import LONGEST, read_factor
from fuzzytime.rulebook.tables.vocabulary import CLAUSE_MODELS

_TIMES = (("t", 0.0), ("w", 1e-3), ("core", 0.0), ("fade", 0.0))
"""Times that a rule may set, with the least value of each."""


def read_norm(scope: Scope, node: Node, key: str) -> Norm:
    """Read ``{and: min, or: max}``; "or" must be the dual of "and"."""
    found = scope.reader.mapping(node, key, ("and", "or"))
    duals = {norm.dual: norm for norm in Norm}
    norm = dual = None
    if "and" in found:
        norm = scope.reader.choice(found["and"], f"{key}.and", tuple(Norm))
    if "or" in found:
        dual = scope.reader.choice(found["or"], f"{key}.or", tuple(duals))
    if norm and dual and Norm(norm).dual != dual:
        message = f"must be the dual of 'and', which is {Norm(norm).dual!r}, got {dual!r}"
        scope.reader.mistake(found["or"], f"{key}.or", message)
    return Norm(norm) if norm else duals[dual] if dual else Norm.MIN


def read_rules(scope: Scope, node: Node, key: str) -> Mapping[str, Rule]:
    """Read rules in their order, by name; one without a name is called by its place."""
    read: dict[str, Rule] = {}
    first: dict[str, int] = {}
    for i, item in enumerate(scope.reader.sequence(node, key)):
        path = f"{key}[{i}]"
        found = scope.row(item, path, ("name", "on", "if", "then", "weight"), ("then",))
        name = scope.reader.place(item)
        if "name" in found:
            name = scope.reader.phrase(found["name"], f"{path}.name")
            path = f"{path}({name})"
            if name in first:
                message = f"names of rules must differ, got {name!r} as on line {first[name]}"
                scope.reader.mistake(found["name"], f"{path}.name", message)
            first.setdefault(name, found["name"].line + 1)
        effect = _effect(scope, found, path)
        weight = (
            scope.reader.number(found["weight"], f"{path}.weight", 0.0, 1.0) if "weight" in found else 1.0
        )
        read[name] = Rule(
            name=name,
            place=scope.reader.place(item),
            match=read_match(scope, found["on"], f"{path}.on") if "on" in found else Match(),
            condition=_condition(scope, found["if"], f"{path}.if") if "if" in found else None,
            effect=effect,
            weight=weight,
        )
    return MappingProxyType(read)


def _condition(scope: Scope, node: Node, key: str) -> Formula | None:
    text = scope.reader.string(node, key)
    if not isinstance(node, Scalar):
        return None
    parsed = parse_condition(text, scope.names.terms, scope.names.term_hedges, scope.names.variables)
    for problem in parsed.problems:
        scope.reader.mistake(node, key, problem.message, problem.offset)
    return parsed.formula


def _effect(scope: Scope, found: Mapping[str, Node], key: str) -> Effect:
    if "then" not in found:
        return Effect()
    node, path = found["then"], f"{key}.then"
    parts = scope.reader.mapping(node, path, ("model", *(name for name, _ in _TIMES), "scale"))
    model = ""
    if "model" in parts:
        models = (*scope.names.models, *CLAUSE_MODELS)
        model = scope.reader.choice(parts["model"], f"{path}.model", models)
        if model in CLAUSE_MODELS and "if" not in found:
            scope.reader.mistake(
                parts["model"], f"{path}.model", f"the model {model!r} needs an 'if' to wait for"
            )
    if model and model not in CLAUSE_MODELS:
        scope.reader.refuse_keys(node, path, ("core", "fade"), f"does not belong to the model {model!r}")
    times = {
        name: scope.reader.duration(parts[name], f"{path}.{name}", low, LONGEST)
        for name, low in _TIMES
        if name in parts
    }
    scale: dict[str, float] = {}
    if "scale" in parts:
        factors = scope.reader.mapping(parts["scale"], f"{path}.scale", ("t", "w"))
        if isinstance(parts["scale"], MappingNode) and not parts["scale"].entries:
            scope.reader.mistake(parts["scale"], f"{path}.scale", "must scale 't' or 'w'")
        scale = {name: read_factor(scope, value, f"{path}.scale.{name}") for name, value in factors.items()}
    if isinstance(node, MappingNode) and not node.entries:
        scope.reader.mistake(node, path, "must ask for something: a model, a parameter or a scale")
    return Effect(model=model or None, scale=MappingProxyType(scale), **times)
