"""Reading linguistic variables, their terms, and the hedges of terms."""

import math
from collections.abc import Mapping
from itertools import pairwise
from types import MappingProxyType

from fuzzytime.documents.nodes import Node, Scalar
from fuzzytime.rulebook.logic.grammar import KEYWORDS
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.sections.signals import read_per, read_value
from fuzzytime.rulebook.tables.sections.widths import LONGEST
from fuzzytime.rulebook.tables.variables import Source, Term, Variable
from fuzzytime.spelling import suggestion

_SHAPES = {"trapezoid": 4, "triangle": 3, "rising": 2, "falling": 2}
"""The shapes of terms, and how many breakpoints each has."""

_FOR_RATES = ("over", "per")


def read_variables(scope: Scope, node: Node, key: str) -> Mapping[str, Variable]:
    """Read variables by name."""
    keys = scope.reader.keys(node)
    read: dict[str, Variable] = {}
    for name, value in scope.reader.mapping(node, key).items():
        path = f"{key}.{name}"
        _check_name(scope, keys[name], path, "a variable")
        allowed = (*Source, *_FOR_RATES, "words", "terms")
        found = scope.row(value, path, allowed, ("terms",))
        rule = "must give exactly one of 'of', 'rate_of' and 'since'"
        given = scope.reader.one_of(value, path, tuple(Source), rule)
        if given is None:
            continue
        source = Source(given)
        signal = _signal(scope, found[source], f"{path}.{source}", source)
        over, per = _rate_parts(scope, found, value, path, source)
        unit = _unit(scope, signal, source)
        words = scope.reader.strings(found["words"], f"{path}.words") if "words" in found else ()
        terms = _terms(scope, found["terms"], f"{path}.terms", unit) if "terms" in found else {}
        if signal is not None:
            read[name] = Variable(
                name=name,
                source=source,
                signal=signal,
                unit=scope.names.units[signal],
                terms=terms,
                over=over,
                per=per,
                words=tuple(text.lower() for text in words),
                place=scope.reader.place(keys[name]),
            )
    return MappingProxyType(read)


def _check_name(scope: Scope, node: Node, key: str, what: str) -> None:
    name = scope.reader.string(node, key)
    if not name.isidentifier():
        scope.reader.mistake(node, key, f"{what}'s name must be one word, got {name!r}")
    elif name in KEYWORDS:
        scope.reader.mistake(node, key, f"{what}'s name must not be a word of the grammar, got {name!r}")


def _signal(scope: Scope, node: Node, key: str, source: Source) -> str | None:
    """Read the name of the signal or event that a variable looks at; None where there is no such one."""
    names = scope.names
    name = scope.reader.string(node, key)
    if not name:
        if isinstance(node, Scalar) and not node.refused:
            scope.reader.mistake(node, key, "must name a signal or an event")
    elif name not in names.units:
        scope.reader.mistake(node, key, f"unknown signal {name!r}{suggestion(name, names.units)}")
    elif source is Source.SINCE and name not in names.events:
        scope.reader.mistake(node, key, f"'since' needs an event, got the signal {name!r}")
    elif source is not Source.SINCE and name in names.events:
        scope.reader.mistake(
            node, key, f"{source.value!r} needs a signal with values, got the event {name!r}"
        )
    else:
        return name
    return None


def _unit(scope: Scope, signal: str | None, source: Source) -> str | None:
    if source is Source.SINCE:
        return "s"
    return scope.names.units.get(signal or "") if source is Source.OF else None


def _rate_parts(
    scope: Scope, found: Mapping[str, Node], node: Node, key: str, source: Source
) -> tuple[float, float]:
    over, per = 0.0, 1.0
    if source is not Source.RATE_OF:
        scope.reader.refuse_keys(node, key, _FOR_RATES, "belongs to 'rate_of' only")
        return over, per
    if "over" in found:
        over = scope.reader.duration(found["over"], f"{key}.over", 1e-3, LONGEST)
    else:
        scope.reader.missing(node, key, ("over",))
    if "per" in found:
        per = read_per(scope, found["per"], f"{key}.per")
    return over, per


def _terms(scope: Scope, node: Node, key: str, unit: str | None) -> Mapping[str, Term]:
    keys = scope.reader.keys(node)
    if not keys:
        scope.reader.missing(node, key, (), "must have at least one term")
    read: dict[str, Term] = {}
    for name, value in scope.reader.mapping(node, key).items():
        path = f"{key}.{name}"
        _check_name(scope, keys[name], path, "a term")
        found = scope.row(value, path, (*_SHAPES, "words"))
        rule = f"must give exactly one shape of {', '.join(_SHAPES)}"
        shape = scope.reader.one_of(value, path, _SHAPES, rule)
        if shape is None:
            continue
        corners = _corners(scope, found[shape], f"{path}.{shape}", shape, unit)
        words = scope.reader.strings(found["words"], f"{path}.words") if "words" in found else ()
        if corners is not None:
            read[name] = Term(name, corners, tuple(text.lower() for text in words))
    return MappingProxyType(read)


def _corners(
    scope: Scope, node: Node, key: str, shape: str, unit: str | None
) -> tuple[float, float, float, float] | None:
    items = scope.reader.sequence(node, key, _SHAPES[shape])
    read = [read_value(scope, item, f"{key}[{i}]", unit) for i, item in enumerate(items)]
    values = [value for value in read if value is not None]
    if len(values) != _SHAPES[shape]:
        return None
    for i, (one, following) in enumerate(pairwise(values), 1):
        if following < one:
            scope.reader.mistake(
                items[i], f"{key}[{i}]", f"breakpoints must not decrease, got {one:g} and then {following:g}"
            )
            return None
    if shape == "rising":
        return values[0], values[1], math.inf, math.inf
    if shape == "falling":
        return -math.inf, -math.inf, values[0], values[1]
    first, second, *_, third, fourth = (
        values if shape == "trapezoid" else (values[0], values[1], values[1], values[2])
    )
    return first, second, third, fourth


def read_term_hedges(scope: Scope, node: Node, key: str) -> Mapping[str, float]:
    """Read the powers that hedges raise a degree to: 2 for "very"."""
    keys = scope.reader.keys(node)
    read: dict[str, float] = {}
    for name, value in scope.reader.mapping(node, key).items():
        path = f"{key}.{name}"
        _check_name(scope, keys[name], path, "a hedge")
        found = scope.row(value, path, ("power",), ("power",))
        power = scope.reader.number(found["power"], f"{path}.power", 0.01, 100.0) if "power" in found else 1.0
        read[name.lower()] = power or 1.0
    return MappingProxyType(read)
