"""Reading models: trapezoids and bells whose numbers are sums."""

import math
from collections.abc import Mapping
from itertools import pairwise
from types import MappingProxyType

from fuzzytime.documents.nodes import Node, Scalar
from fuzzytime.requirement import Constraint
from fuzzytime.rulebook.tables.contents import BellForm, Corners, Model
from fuzzytime.rulebook.tables.expression import Sum, SumError, parse_sum
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.vocabulary import CLAUSE_MODELS

FORMS = ("breakpoints", "bell")
"""The keys that state a model's form."""

_PROBES = (
    {"t": 60.0, "w": 240.0, "c": 80.0, "a": 3600.0, "b": 7200.0},
    {"t": 600.0, "w": 150.0, "c": 60.0, "a": 43200.0, "b": 129600.0},
    {"t": 28800.0, "w": 3600.0, "c": 1200.0, "a": 86400.0, "b": 691200.0},
)
"""Settings at which the order of breakpoints is checked: it must hold at one of them."""


def read_models(scope: Scope, node: Node, key: str) -> Mapping[str, Model]:
    """Read models by name."""
    read: dict[str, Model] = {}
    keys = scope.reader.keys(node)
    for name, value in scope.reader.mapping(node, key).items():
        path = f"{key}.{name}"
        if name in CLAUSE_MODELS:
            scope.reader.mistake(keys[name], path, f"the model {name!r} is built in and cannot be changed")
            continue
        found = scope.row(value, path, (*FORMS, "constraint"))
        given = scope.reader.one_of(value, path, FORMS, "must give either 'breakpoints' or 'bell'")
        form = read_form(scope, found[given], path, given) if given is not None else None
        constraint = ""
        if "constraint" in found:
            constraint = scope.reader.choice(found["constraint"], f"{path}.constraint", tuple(Constraint))
        if form is not None:
            place = scope.reader.place(keys[name])
            read[name] = Model(name, form, place, Constraint(constraint) if constraint else None)
    return MappingProxyType(read)


def read_form(scope: Scope, node: Node, key: str, form: str) -> Corners | BellForm | None:
    """Read a form, one of `FORMS`; None where it is not sound."""
    return (_bell if form == "bell" else _corners)(scope, node, f"{key}.{form}")


def _corners(scope: Scope, node: Node, key: str) -> Corners | None:
    items = scope.reader.sequence(node, key, 4)
    sums = [_sum(scope, item, f"{key}[{i}]") for i, item in enumerate(items)]
    first, second, third, fourth = sums if len(sums) == 4 else (None, None, None, None)
    if first is None or second is None or third is None or fourth is None:
        return None
    corners = (first, second, third, fourth)
    for i in (0, 2):
        if math.isinf(corners[i].constant) != math.isinf(corners[i + 1].constant):
            scope.reader.mistake(items[i], f"{key}[{i}]", "an open side needs two infinite breakpoints")
            return None
    for i, (one, following) in enumerate(pairwise(corners), 1):
        if not any(one.value(probe) <= following.value(probe) for probe in _PROBES):
            scope.reader.mistake(items[i], f"{key}[{i}]", "breakpoints must not decrease")
            return None
    return Corners(corners)


def _bell(scope: Scope, node: Node, key: str) -> BellForm | None:
    parts = ("centre", "width", "slope")
    found = scope.reader.mapping(node, key, parts, parts)
    centre = _sum(scope, found["centre"], f"{key}.centre") if "centre" in found else None
    width = _sum(scope, found["width"], f"{key}.width") if "width" in found else None
    slope = scope.reader.number(found["slope"], f"{key}.slope", 0.1, 100.0) if "slope" in found else 1.0
    if centre is None or width is None:
        return None
    for name, part in (("centre", centre), ("width", width)):
        if not math.isfinite(part.constant):
            scope.reader.mistake(found[name], f"{key}.{name}", "must be finite")
            return None
    if all(width.value(probe) <= 0 for probe in _PROBES):
        scope.reader.mistake(found["width"], f"{key}.width", "a bell's width must be above 0")
    return BellForm(centre, width, slope)


def _sum(scope: Scope, node: Node, key: str) -> Sum | None:
    if not isinstance(node, Scalar):
        scope.reader.string(node, key)
        return None
    try:
        return parse_sum(node.text)
    except SumError as error:
        scope.reader.mistake(node, key, str(error), error.offset)
        return None
