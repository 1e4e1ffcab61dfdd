"""Measure the rule engine: speed and error beside other libraries, mistakes located, forecasts, refusals.

``PYTHONPATH=. python benchmarks/rules.py``. Peers are compared where they are installed
(``pip install ferrifuzz fuzzytool scikit-fuzzy rtamt``); the figures of `docs/rules.md` come from here.
"""

import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from rules_peers import STATIC, StaticRule, by_rtamt, installed

from fuzzytime.context import Context
from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import DocumentError
from fuzzytime.requirement import Condition, Constraint, TimeRequirement
from fuzzytime.rulebook import Profile, Resolution, Rulebook, check
from fuzzytime.rulebook.over_time.truth import trace_all
from fuzzytime.rulebook.over_time.world import Grid, World
from fuzzytime.rulebook.resolving.inference import takagi_sugeno
from fuzzytime.rulebook.tables.documents import SHIPPED, Document, load, read_over, shipped_tables
from fuzzytime.satisfaction import Floats

SEEDED = Path(__file__).parent.parent / "tests" / "rulebook" / "seeded_mistakes.yaml"
RULES, ROWS, SAMPLES, RUNS = 50, 10_000, 1801, 20


def least_of(act: Callable[[], object], runs: int = RUNS) -> float:
    """Give the least processor time of some runs, in milliseconds: what else runs here only adds to it."""
    taken = []
    for _ in range(runs):
        start = time.process_time()
        act()
        taken.append(1e3 * (time.process_time() - start))
    return min(taken)


def row(what: str, figure: str, goal: str = "") -> None:
    """Print a figure beside its goal."""
    print(f"{what:68} {figure:>18}  {goal}")


def static_rules(number: int, seed: int) -> list[StaticRule]:
    """Make rules with terms, weights and hedges by chance."""
    rng = np.random.default_rng(seed)

    def corners() -> tuple[float, float, float, float]:
        a, b, c, d = np.sort(rng.uniform(0, 100, 4)).tolist()
        return a, b, c, d

    return [
        StaticRule(corners(), corners(), float(rng.uniform(0, 100)), float(rng.choice([0.25, 0.5, 1.0])))
        for _ in range(number)
    ]


def rulebook_of(text: str) -> Rulebook:
    """Read a table of one's own over the shipped lookup."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mine.yaml"
        path.write_text(f"fuzzytime: 1\n{text}", encoding="utf-8")
        documents = [
            Document.shipped("lookup.yaml"),
            Document.shipped("durations.yaml"),
            Document(path, "mine.yaml"),
        ]
        return Rulebook(load(documents, Profile.EVERYDAY))


def table_of(rules: list[StaticRule]) -> str:
    """Write static rules as a rule file."""

    def terms(letter: str, of: list[tuple[float, float, float, float]]) -> str:
        return ", ".join(f"{letter}{i}: {{trapezoid: {list(corners)}}}" for i, corners in enumerate(of))

    lines = [
        "signals: {x: {range: [0, 100]}, y: {range: [0, 100]}}",
        "variables:",
        f"  x: {{of: x, terms: {{{terms('a', [rule.x for rule in rules])}}}}}",
        f"  y: {{of: y, terms: {{{terms('b', [rule.y for rule in rules])}}}}}",
        "rules:",
    ]
    for i, rule in enumerate(rules):
        then = f"{{model: soon, t: {rule.output!r} s}}"
        lines.append(
            f"  - {{name: r{i}, on: {{cue: soon}}, if: x is a{i} and y is b{i}, then: {then}, "
            f"weight: {rule.weight}}}"
        )
    return "\n".join(lines)


def world_over(rulebook: Rulebook, **values: Floats) -> tuple[World, Grid]:
    """Put rows of values on a timeline, one a second up to now."""
    size = len(next(iter(values.values())))
    times = np.arange(-size + 1, 1, dtype=float)
    context = Context.of({name: list(zip(times, row, strict=True)) for name, row in values.items()})
    world = World.of(context.admitted(rulebook.signals), rulebook.tables, values)
    return world, Grid(1.0, times, np.arange(size))


def static_inference() -> None:
    """Fifty rules over ten thousand rows, and the largest difference to each peer."""
    rules = static_rules(RULES, 1)
    rulebook = rulebook_of(table_of(rules))
    x, y = np.random.default_rng(2).uniform(0, 100, (2, ROWS))
    world, grid = world_over(rulebook, x=x, y=y)
    conditions = [rule.condition for rule in rulebook.tables.rules.values() if rule.condition is not None]

    def inferred() -> Floats:
        degrees = [traced.truth.low for traced in trace_all(conditions, world, grid)]
        weights = np.array([[rule.weight] for rule in rules]) * np.array(degrees)
        return takagi_sugeno(weights, np.array([[rule.output] for rule in rules]))

    ours = inferred()
    row(f"{RULES} rules, {ROWS:,} rows: ours", f"{least_of(inferred):.1f} ms", "< 50 ms")
    for name, build in STATIC.items():
        if not installed(name):
            row(f"{RULES} rules, {ROWS:,} rows: {name}", "not installed")
            continue
        peer = build(rules)
        difference = float(np.nanmax(np.abs(peer(x, y) - ours)))
        row(f"{RULES} rules, {ROWS:,} rows: {name}", f"{least_of(lambda p=peer: p(x, y)):.1f} ms")
        row("    largest difference to ours", f"{difference:.1e}", "< 1e-12")


def temporal_rules() -> None:
    """Fifty windows over the samples of one signal."""
    lengths = np.random.default_rng(3).integers(5, 300, RULES).tolist()
    kinds = [("sometime", "once"), ("throughout", "historically")]
    formulas = [(*kinds[i % 2], length) for i, length in enumerate(lengths)]
    rules = [
        f"  - {{name: r{i}, on: {{cue: soon}}, if: x is high {ours} in the last {length} s, "
        "then: {t: 1 s}}"
        for i, (ours, _, length) in enumerate(formulas)
    ]
    variable = "{of: x, terms: {high: {trapezoid: [0, 1, 1, 1]}}}"
    text = f"signals: {{x: {{range: [0, 1]}}}}\nvariables: {{x: {variable}}}\nrules:\n" + "\n".join(rules)
    rulebook = rulebook_of(text)
    samples = np.random.default_rng(4).random(SAMPLES)
    world, grid = world_over(rulebook, x=samples)
    conditions = [rule.condition for rule in rulebook.tables.rules.values() if rule.condition is not None]

    def traced() -> list[Floats]:
        return [traced.truth.low for traced in trace_all(conditions, world, grid)]

    row(f"{RULES} temporal rules × {SAMPLES} samples: ours", f"{least_of(traced):.1f} ms", "< 5 ms")
    if not installed("rtamt"):
        row(f"{RULES} temporal rules × {SAMPLES} samples: rtamt", "not installed")
        return
    peer = by_rtamt([(theirs, length) for _, theirs, length in formulas], samples)
    found = peer()
    row(f"{RULES} temporal rules × {SAMPLES} samples: rtamt", f"{least_of(peer, 1):.0f} ms")
    differences = [
        np.abs(one - other)[length:].max()
        for one, other, (_, _, length) in zip(found, traced(), formulas, strict=True)
    ]
    row("    largest difference where the window is full", f"{max(differences):.1e}", "rounding")


def mistakes() -> None:
    """Locate every seeded mistake in one run."""
    lines = SEEDED.read_text(encoding="utf-8").splitlines()
    number = sum(len(line.partition("  #! ")[2].split(" ;; ")) for line in lines if "  #! " in line)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "seeded.yaml"
        plain = [line.partition("  #! ")[0].replace("«", "") if "  #! " in line else line for line in lines]
        path.write_text("\n".join(plain), encoding="utf-8")
        found = check([path])
        row("seeded mistakes located in one run", f"{len(found)} of {number}", "all")
        row("    time for that", f"{least_of(lambda: check([path])):.0f} ms")


BOMB = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]\n" for i in range(1, 12)
)
HOSTILE = {
    "aliases that multiply": BOMB,
    "30,000 brackets deep": "[" * 30_000,
    "30,000 braces deep": "{a: " * 30_000,
    "a tag that runs a command": "a: !!python/object/apply:os.system ['true']",
    "a megabyte of keys": "".join(f"k{i}: 1\n" for i in range(90_000)),
    "two megabytes": "x" * (2 << 20),
    "a condition nested 10,000 deep": "rules: [{name: a, if: '" + "(" * 10_000 + "', then: {t: 1 s}}]",
}


def refusals() -> None:
    """Refuse hostile files fast."""
    shipped = shipped_tables(Profile.EVERYDAY)
    for name, text in HOSTILE.items():

        def refused(text: str = text) -> None:
            try:
                _, found = read_over(shipped, [Reader("hostile.yaml", text)], Profile.EVERYDAY)
            except DocumentError:
                return
            if not found:
                sys.exit(f"was not refused: {text[:40]}")

        row(f"refused: {name}", f"{least_of(refused, 3):.0f} ms", "< 100 ms")


def forecasts(number: int = 200) -> None:
    """Follow a pan from 20 to 230 °C, τ = 150 s, noise 2 °C, read every two seconds for a minute."""
    table = """
signals:
  pan_temp: {unit: degC, range: [0, 350], forecast: {model: approach, set_point: 230, horizon: 15 min}}
variables:
  pan: {of: pan_temp, words: [pan], terms: {hot: {trapezoid: [170, 190, 250, 280]}}}
"""
    rulebook = rulebook_of(table)
    hot = Condition(text="when the pan is hot", subject="pan", word="hot")
    requirement = TimeRequirement(
        text=hot.text, span=(0, 19), constraint=Constraint.WHEN, preposition="while", condition=hot
    )

    def resolved(values: Floats) -> Resolution:
        pairs = list(zip(times.tolist(), values.tolist(), strict=True))
        return rulebook.resolve(requirement, Context.of({"pan_temp": pairs}))

    ahead = np.arange(0.0, 840.0, 0.5)
    half = 150 * np.log(210 / 50) - 60
    times = np.arange(-60.0, 0.1, 2.0)
    clean = 230 - 210 * np.exp(-(times + 60) / 150)
    truth = np.interp(230 - 210 * np.exp(-(ahead + 60) / 150), [170, 190, 250, 280], [0, 1, 1, 0])
    errors, misses, covered = [], [], []
    for seed in range(number):
        values = clean + np.random.default_rng(seed).normal(0, 2, times.size)
        drawn = resolved(values).trace
        if drawn is None:
            sys.exit("a clause without a trace")
        degrees = np.interp(ahead, drawn.times, drawn.low)
        errors.append(abs(float(np.interp(0.5, np.maximum.accumulate(degrees), ahead)) - half))
        misses.append(float(np.abs(degrees - truth).mean()))
        (signal,) = drawn.signals
        bounds = [
            float(np.interp(180, band, signal.forecast_times))
            for band in (signal.forecast_high, signal.forecast_low)
        ]
        covered.append(bounds[0] <= half <= bounds[1])
    row(
        f"half-hot time after 60 s of noisy readings, median error of {number}",
        f"{np.median(errors):.2f} s",
        "≤ 3 s",
    )
    row("    mean absolute error of the degree", f"{np.mean(misses):.4f}", "≤ 0.01")
    row("    share of 90 % intervals of that time that hold it", f"{np.mean(covered):.2f}", "0.85 to 0.95")
    once = clean + np.random.default_rng(1).normal(0, 2, times.size)
    row("    one resolution, fit and forecast", f"{least_of(lambda: resolved(once)):.1f} ms")


def main() -> None:
    """Print every figure."""
    static_inference()
    row("weights 1 and 0.5, outputs 0 and 10", f"{takagi_sugeno([1, 0.5], [0, 10]):.4f}", "3.3333")
    temporal_rules()
    mistakes()
    refusals()
    forecasts()
    documents = [Document.shipped(name) for name in SHIPPED]
    row("the shipped tables, read whole", f"{least_of(lambda: load(documents, Profile.EVERYDAY), 3):.0f} ms")


if __name__ == "__main__":
    main()
