"""Time the study's road on a study of the paper's size: 14 instructions, 32 participants, 800 samples.

``PYTHONPATH=. python benchmarks/study.py``. Each row is the best and the median of several runs, in seconds.
"""

import json
import statistics
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from study_truth import truth

from fuzzytime.study import (
    AnswerStore,
    Design,
    Model,
    analyse,
    calibrate,
    compare,
    corner_intervals,
    fit_models,
    rule_table,
    simulate,
)
from fuzzytime.study.reporting.numbers import numbers
from fuzzytime.study.reporting.plots import figures, rendered
from fuzzytime.study.reporting.report import report

RUNS = 5


def timed(name: str, act: Callable[[], object], runs: int = RUNS) -> None:
    """Run something several times and print how long it took."""
    seconds = []
    for _ in range(runs):
        start = time.perf_counter()
        act()
        seconds.append(time.perf_counter() - start)
    print(f"{name:58} {min(seconds):8.3f} {statistics.median(seconds):8.3f}")


def main() -> None:
    """Time every step."""
    design = Design.shipped()
    answers = simulate(design, truth, 32, seed=1)
    groups = [list(answers.subjective(group).values()) for group in design.groups]
    drawn = answers.subjective()

    def fits() -> None:
        for subjective in drawn.values():
            fit_models(subjective.times, subjective.median, (Model.TRAPEZOID, Model.BELL))

    def all_fits() -> None:
        for subjective in drawn.values():
            fit_models(subjective.times, subjective.median)

    def whole() -> None:
        json.dumps(numbers(analyse(answers)))

    def stored() -> None:
        with (
            tempfile.TemporaryDirectory() as folder,
            AnswerStore.create(Path(folder) / "a.sqlite", design) as store,
        ):
            store.add(answers.participants)
            store.answers()

    def drawings() -> None:
        report(analysis, {name: rendered(draw, "svg")[0] for name, draw in figures(analysis)})

    analysis = analyse(answers)
    print(f"{'14 instructions, 32 participants, 800 samples':58} {'best':>8} {'median':>8}")
    timed("simulate", lambda: simulate(design, truth, 32, seed=1))
    timed("store and read again", stored)
    timed("fits: trapezoid and bell, 3 starts, 14 medians", fits)
    timed("fits: all five models, 14 medians", all_fits)
    timed("permutation test, 999 permutations, 14 instructions", lambda: compare(*groups))
    timed("analysis with all fits, groups and numbers", whole)
    timed(
        "bootstrap of one instruction's corners, 200 resamples",
        lambda: corner_intervals(analysis.overall["in-30"]),
        2,
    )
    timed("calibrate and write the table", lambda: rule_table(calibrate(answers)))
    timed("17 figures as SVG and the report", drawings, 2)


if __name__ == "__main__":
    main()
