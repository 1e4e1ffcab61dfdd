"""The engine infers what other libraries infer; their numbers stand here, so that none of them is needed.

``benchmarks/rules.py`` compares many more, where they are installed.
"""

from pathlib import Path

import numpy as np
import pytest

from fuzzytime.context import Context
from fuzzytime.rulebook.logic.traces import Past
from fuzzytime.rulebook.logic.windows import Extent, sometime, throughout
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.inference import hear, takagi_sugeno
from rulebook.books import book

ORACLE = """
signals: {x: {range: [0, 100]}, y: {range: [0, 100]}}
variables:
  x:
    of: x
    terms:
      a: {trapezoid: [0, 10, 30, 50]}
      b: {trapezoid: [20, 40, 60, 80]}
      c: {rising: [50, 70]}
      d: {trapezoid: [-1, 0, 100, 101]}
  y:
    of: y
    terms:
      a: {trapezoid: [-1, 0, 40, 60]}
      b: {trapezoid: [30, 50, 70, 90]}
      c: {rising: [50, 80]}
      d: {trapezoid: [20, 30, 30, 45]}
rules:
  - {name: one, on: {cue: soon}, if: x is very a and y is a, then: {model: soon, t: 5 s}}
  - {name: two, on: {cue: soon}, if: x is b and y is b, then: {model: soon, t: 40 s}, weight: 0.5}
  - {name: three, on: {cue: soon}, if: x is c and y is c, then: {model: soon, t: 90 s}}
  - {name: four, on: {cue: soon}, if: x is d and y is d, then: {model: soon, t: 20 s}, weight: 0.25}
"""


def test_rules_infer_what_other_libraries_infer(tmp_path: Path) -> None:
    # By ferrifuzz 0.2.1, fuzzytool 0.7.0 and scikit-fuzzy 0.5.0, to the last digit the same.
    oracle = [
        (5, 10, 5.0),
        (25, 35, 10.322580645161288),
        (33, 55, 24.782608695652176),
        (45, 41, 31.288659793814436),
        (55, 66, 56.666666666666664),
        (72, 85, 84.44444444444444),
        (90, 58, 90.0),
    ]
    rulebook = book(tmp_path, ORACLE)
    for x, y, expected in oracle:
        context = Context.of({"x": float(x), "y": float(y)}).admitted(rulebook.signals)
        heard = hear(tuple(rulebook.tables.rules.values()), World.of(context, rulebook.tables, ("x", "y")))
        found = takagi_sugeno([part.weight for part in heard], [part.rule.effect.t or 0.0 for part in heard])
        assert float(found) == pytest.approx(expected, abs=1e-12)


def test_crisp_windows_equal_those_of_rtamt() -> None:
    # `once[0:3]` and `historically[0:3]` in the discrete time of rtamt 0.4.10, where the window is full.
    samples = np.array([[0.1, 0.9, 0.4, 0.3, 0.8, 0.2, 0.2, 0.6, 0.5, 0.0]])
    once = [0.9, 0.9, 0.8, 0.8, 0.8, 0.6, 0.6]
    historically = [0.1, 0.3, 0.2, 0.2, 0.2, 0.2, 0.0]
    extent = Extent(3.0, 3.0)
    assert sometime(Past(samples, 0.0), extent)[0, 3:].tolist() == once
    assert throughout(Past(samples, 0.0), extent)[0, 3:] == pytest.approx(historically)
