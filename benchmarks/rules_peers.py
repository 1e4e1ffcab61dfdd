"""The same rules in other libraries, to compare speed and results; each may be missing.

Peers: ferrifuzz 0.2.1, fuzzytool 0.7.0 and scikit-fuzzy 0.5.0 for static inference, rtamt 0.4.10 for windows.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec

import numpy as np

from fuzzytime.satisfaction import Floats

Corners = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class StaticRule:
    """Say that if x is A (to a power) and y is B, then t is the output; terms are trapezoids."""

    x: Corners
    y: Corners
    output: float
    weight: float = 1.0
    power: float = 1.0


def installed(name: str) -> bool:
    """Tell whether a peer can be imported."""
    return find_spec(name) is not None


def by_ferrifuzz(rules: Sequence[StaticRule]) -> Callable[[Floats, Floats], Floats]:
    """Build a Sugeno system of ferrifuzz; it knows no weight and no hedge beside its own."""
    import ferrifuzz as ff

    system = ff.FuzzySystem(and_method="min", defuzz_method="weighted_average")
    inputs = {name: ff.Variable(name, 0, 100) for name in ("x", "y")}
    out = ff.Variable("t", -1, 101)
    for number, rule in enumerate(rules):
        inputs["x"][f"a{number}"] = ff.mf.trapezoid(*rule.x)
        inputs["y"][f"b{number}"] = ff.mf.trapezoid(*rule.y)
        out[f"z{number}"] = ff.mf.singleton(rule.output)
    for variable in inputs.values():
        system.add_input(variable)
    system.add_output(out)
    for number, rule in enumerate(rules):
        hedge = {1.0: "", 2.0: "very "}[rule.power]
        text = f"IF x IS {hedge}a{number} AND y IS b{number} THEN t IS z{number}"
        parsed = ff.Rule.from_string(text)
        parsed.weight = rule.weight
        system.add_rule(parsed)
    return lambda x, y: np.asarray(system.compute_batch({"x": x, "y": y})["t"])


def by_fuzzytool(rules: Sequence[StaticRule]) -> Callable[[Floats, Floats], Floats]:
    """Build a TSK system of fuzzytool."""
    import fuzzytool

    terms: Mapping[str, dict[str, object]] = {"x": {}, "y": {}}
    for number, rule in enumerate(rules):
        terms["x"][f"a{number}"] = _powered(fuzzytool.trap(*rule.x), rule.power)
        terms["y"][f"b{number}"] = fuzzytool.trap(*rule.y)
    x, y = (fuzzytool.Variable(name, (0, 100), found) for name, found in terms.items())
    system = fuzzytool.TSK(tnorm="min")
    for number, rule in enumerate(rules):
        system.rule(x[f"a{number}"] & y[f"b{number}"], rule.output, weight=rule.weight)
    return lambda one, other: np.asarray(system.predict(x=one, y=other))


def _powered(membership: Callable[[Floats], Floats], power: float) -> Callable[[Floats], Floats]:
    return membership if power == 1.0 else lambda values: membership(values) ** power


def by_scikit_fuzzy(rules: Sequence[StaticRule]) -> Callable[[Floats, Floats], Floats]:
    """Put together memberships of scikit-fuzzy, which has no Takagi-Sugeno system of its own."""
    import skfuzzy

    def inferred(x: Floats, y: Floats) -> Floats:
        total = np.zeros(x.size)
        weights = np.zeros(x.size)
        for rule in rules:
            degree = np.fmin(skfuzzy.trapmf(x, list(rule.x)) ** rule.power, skfuzzy.trapmf(y, list(rule.y)))
            weights += rule.weight * degree
            total += rule.weight * degree * rule.output
        with np.errstate(invalid="ignore"):
            return total / weights

    return inferred


STATIC: Mapping[str, Callable[[Sequence[StaticRule]], Callable[[Floats, Floats], Floats]]] = {
    "ferrifuzz": by_ferrifuzz,
    "fuzzytool": by_fuzzytool,
    "skfuzzy": by_scikit_fuzzy,
}


def by_rtamt(formulas: Sequence[tuple[str, int]], samples: Floats) -> Callable[[], list[Floats]]:
    """Evaluate ``once`` and ``historically`` over the last so many samples by rtamt, in discrete time."""
    import rtamt

    specifications = []
    for operator, steps in formulas:
        specification = rtamt.StlDiscreteTimeSpecification()
        specification.declare_var("x", "float")
        specification.spec = f"{operator}[0:{steps}](x)"
        specification.parse()
        specifications.append(specification)
    data = {"time": list(range(samples.size)), "x": samples.tolist()}

    def evaluated() -> list[Floats]:
        return [
            np.array([value for _, value in specification.evaluate(data)]) for specification in specifications
        ]

    return evaluated
