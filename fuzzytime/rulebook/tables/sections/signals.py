"""Reading signals: units, limits, and how each goes on."""

import math
from collections.abc import Mapping
from types import MappingProxyType

from fuzzytime.context.signals import LARGEST, Approach, Course, Hold, Linear, Signal
from fuzzytime.context.units import UNITS, convert, misspelt, parse_quantity
from fuzzytime.documents.nodes import Node, Scalar
from fuzzytime.errors import FuzzytimeError
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.sections.widths import LONGEST
from fuzzytime.times import DAY

_COURSES: Mapping[str, tuple[str, ...]] = {
    "hold": (),
    "linear": ("rate", "per"),
    "approach": ("set_point", "time_constant", "spread"),
}
"""The models of forecasts, and the keys of each beside its horizon."""

_FOR_VALUES = ("unit", "range", "noise", "softness", "max_age", "max_gap", "forecast")
"""What only signals with values have."""

_KEYS = (*_FOR_VALUES, "event", "words")


def read_signals(scope: Scope, node: Node, key: str) -> Mapping[str, Signal]:
    """Read signals by name."""
    keys = scope.reader.keys(node)
    read: dict[str, Signal] = {}
    for name, value in scope.reader.mapping(node, key).items():
        path = f"{key}.{name}"
        if not name.isidentifier():
            scope.reader.mistake(keys[name], path, f"a signal's name must be one word, got {name!r}")
        found = scope.row(value, path, _KEYS)
        event = scope.reader.boolean(found["event"], f"{path}.event") if "event" in found else False
        if event:
            scope.reader.refuse_keys(value, path, _FOR_VALUES, "an event has no value")
        unit = _unit(scope, found["unit"], f"{path}.unit") if "unit" in found else None
        low, high = _range(scope, found["range"], f"{path}.range", unit) if "range" in found else _OPEN
        course: Course = Hold()
        if "forecast" in found:
            course = _course(scope, found["forecast"], f"{path}.forecast", unit)
        limits = {
            limit: scope.reader.duration(found[limit], f"{path}.{limit}", 1e-3)
            for limit in ("max_age", "max_gap")
            if limit in found
        }
        noise: float | None = None
        if "noise" in found:
            noise = scope.reader.number(found["noise"], f"{path}.noise", 1e-9, LARGEST) or 1.0
        softness: float | None = None
        if "softness" in found:
            softness = scope.reader.number(found["softness"], f"{path}.softness", 0.0, LARGEST)
        words = scope.reader.strings(found["words"], f"{path}.words") if "words" in found else ()
        read[name] = Signal(
            name=name,
            unit=unit,
            low=low,
            high=high,
            event=event,
            course=course,
            noise=noise,
            softness=softness,
            words=tuple(text.lower() for text in words),
            **limits,
        )
    return MappingProxyType(read)


_OPEN = (-math.inf, math.inf)


def _unit(scope: Scope, node: Node, key: str) -> str:
    text = scope.reader.string(node, key)
    if isinstance(node, Scalar) and (not text.strip() or len(text) > 30):
        scope.reader.mistake(node, key, f"a unit must be a short text, got {text!r}")
    elif (meant := misspelt(text)) is not None:
        scope.reader.mistake(node, key, f"unknown unit {text!r} (did you mean {meant!r}?)")
    return text


def _range(scope: Scope, node: Node, key: str, unit: str | None) -> tuple[float, float]:
    items = scope.reader.sequence(node, key, 2)
    if len(items) != 2:
        return _OPEN
    low, high = (read_value(scope, item, f"{key}[{i}]", unit) for i, item in enumerate(items))
    if low is None or high is None:
        return _OPEN
    if low >= high:
        scope.reader.mistake(items[1], f"{key}[1]", f"a range must increase, got {low:g} to {high:g}")
        return _OPEN
    return low, high


def read_value(scope: Scope, node: Node, key: str, unit: str | None) -> float | None:
    """Read a value of a signal, in the signal's unit or with one that converts to it; None if it is none."""
    if not isinstance(node, Scalar):
        scope.reader.string(node, key)
        return None

    def converted(text: str) -> float:
        value, given = parse_quantity(text)
        if abs(value) > LARGEST:
            raise FuzzytimeError(f"must be at most {LARGEST:g}, got {text!r}")
        if given is None:
            return value
        if unit is None:
            raise FuzzytimeError(f"must be a bare number, as there is no unit, got {text!r}")
        if unit not in UNITS and given != unit:
            raise FuzzytimeError(f"must be in {unit!r}, got {text!r}")
        return convert(value, given, unit)

    return scope.reader.read(node, key, converted)


def _course(scope: Scope, node: Node, key: str, unit: str | None) -> Course:
    found = scope.reader.mapping(node, key, ("model", "horizon", *sum(_COURSES.values(), ())), ("model",))
    model = scope.reader.choice(found["model"], f"{key}.model", tuple(_COURSES)) if "model" in found else ""
    if model:
        others = [part for part in found if part not in ("model", "horizon", *_COURSES[model])]
        scope.reader.refuse_keys(node, key, others, f"does not belong to the model {model!r}")
    horizon = math.inf
    if "horizon" in found:
        horizon = scope.reader.duration(found["horizon"], f"{key}.horizon", 1e-3, LONGEST)
    if model == "linear":
        return Linear(rate=_rate(scope, found, key), horizon=horizon)
    if model == "approach":
        return _approach(scope, found, key, unit, horizon)
    return Hold(horizon=horizon)


def _rate(scope: Scope, found: Mapping[str, Node], key: str) -> float | None:
    if "rate" not in found:
        if "per" in found:
            scope.reader.mistake(found["per"], f"{key}.per", "must not stand without 'rate'")
        return None
    per = read_per(scope, found["per"], f"{key}.per") if "per" in found else 1.0
    return scope.reader.number(found["rate"], f"{key}.rate", -1e12, 1e12) / per


def read_per(scope: Scope, node: Node, key: str) -> float:
    """Read a unit of time in which a rate is given: ``s``, ``min``, ``h``."""
    sizes = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": DAY}
    return sizes.get(scope.reader.choice(node, key, tuple(sizes)), 1.0)


def _approach(
    scope: Scope, found: Mapping[str, Node], key: str, unit: str | None, horizon: float
) -> Approach:
    set_point = time_constant = None
    spread = Approach().spread
    if "set_point" in found:
        set_point = read_value(scope, found["set_point"], f"{key}.set_point", unit)
    if "time_constant" in found:
        time_constant = scope.reader.duration(found["time_constant"], f"{key}.time_constant", 1e-2, LONGEST)
    if "spread" in found:
        spread = scope.reader.number(found["spread"], f"{key}.spread", 1.01, 100.0)
    return Approach(
        set_point=set_point, time_constant=time_constant or None, spread=spread or 1.3, horizon=horizon
    )
