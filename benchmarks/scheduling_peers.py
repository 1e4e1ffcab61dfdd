"""What else could schedule such tasks: CP-SAT, and HiGHS with every start as a variable.

Both choose among start times on a grid, and what they prove holds on it only. PyJobShop and other solvers of
shop problems minimise lateness of various kinds, and have no way to state a satisfaction function.
"""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling import THRESHOLD, Labels, Limits, LocalSearch, Milp, Solver, solve
from fuzzytime.scheduling.bound.paths import arcs_of
from fuzzytime.scheduling.exact.flow import Flow
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Curve, Grid, Ints
from fuzzytime.skills import FuzzyTask

WORST = -math.log(THRESHOLD)

PRECISION = 100_000
"""What CP-SAT, which knows whole numbers only, counts costs in parts of."""


@dataclass(frozen=True)
class Answer:
    """What a solver found and proved; ``cpu`` and ``seconds`` are the time it took."""

    cost: float
    lower: float
    proved: bool
    seconds: float
    cpu: float


def costs_on_grid(task: FuzzyTask, step: float) -> tuple[list[tuple[int, Floats]], Ints]:
    """Give each skill's first slot that satisfies, costs from there on, and durations in slots."""
    curves = []
    for skill in task.skills:
        support = skill.satisfaction.support
        first = max(0, math.ceil(support.low / step))
        times = step * np.arange(first, math.floor(support.high / step) + 1)
        value = np.maximum(skill.satisfaction(times), THRESHOLD)
        curves.append((first, -np.log(value) + 0.0))
    durations = np.array([math.ceil(skill.duration / step) for skill in task.skills], np.int64)
    return curves, durations


def ours(solver: Solver | None) -> Callable[[FuzzyTask, float], Answer]:
    """Give a function that runs one of the library's solvers."""

    def run(task: FuzzyTask, limit: float) -> Answer:
        begun, used = time.perf_counter(), time.process_time()
        schedule = solve(task, solver=solver, limits=Limits(seconds=limit))
        seconds, used = time.perf_counter() - begun, time.process_time() - used
        certificate = schedule.certificate
        return Answer(
            schedule.weighted_cost, certificate.lower_cost, certificate.status == "optimal", seconds, used
        )

    return run


def cp_sat(task: FuzzyTask, limit: float, step: float = 5.0) -> Answer:
    """State optional intervals that do not overlap, or m at most, with costs by table."""
    from ortools.sat.python import cp_model

    begun, used = time.perf_counter(), time.process_time()
    curves, durations = costs_on_grid(task, step)
    model = cp_model.CpModel()
    intervals, terms = [], []
    worst = round(WORST * PRECISION)
    for (first, costs), duration in zip(curves, durations.tolist(), strict=True):
        start = model.new_int_var(first, first + costs.size - 1, "")
        done = model.new_bool_var("")
        intervals.append(model.new_optional_fixed_size_interval_var(start, duration, done, ""))
        table = np.rint(costs * PRECISION).astype(int).tolist()
        here, cost = model.new_int_var(0, worst, ""), model.new_int_var(0, worst, "")
        model.add_element(start - first, table, here)
        model.add(cost == here).only_enforce_if(done)
        model.add(cost == worst).only_enforce_if(~done)
        terms.append(cost)
    if task.agents == 1:
        model.add_no_overlap(intervals)
    else:
        model.add_cumulative(intervals, [1] * len(intervals), task.agents)
    model.minimize(sum(terms))
    solver = cp_model.CpSolver()
    solver.parameters.max_time_in_seconds = limit
    solver.parameters.num_workers = 2
    status = solver.solve(model)
    found = status in {cp_model.OPTIMAL, cp_model.FEASIBLE}
    return Answer(
        solver.objective_value / PRECISION if found else np.inf,
        max(solver.best_objective_bound, 0.0) / PRECISION,
        status == cp_model.OPTIMAL,
        time.perf_counter() - begun,
        time.process_time() - used,
    )


def time_indexed(task: FuzzyTask, limit: float, step: float = 5.0) -> Answer:
    """Give HiGHS the flow program with all starts: no prices, no fixing."""
    begun, used = time.perf_counter(), time.process_time()
    curves, durations = costs_on_grid(task, step)
    lane = [Curve(first, np.where(costs < WORST, costs - WORST, np.inf)) for first, costs in curves]
    slots = max(curve.stop - 1 + int(duration) for curve, duration in zip(lane, durations, strict=True))
    everything = np.full(len(lane), WORST)
    grid = Grid(step, 0, durations, everything, tuple((curve,) for curve in lane), slots)
    program = Flow(grid, [arcs_of(lane, durations)], [task.agents], ())
    solved = program.solve(Stopwatch(Limits(seconds=limit)))
    gained = 0.0 if solved.chosen is None else float(program.arcs.gain[solved.chosen].sum())
    total = float(everything.sum())
    return Answer(
        total + gained,
        max(0.0, total + solved.bound),
        solved.best,
        time.perf_counter() - begun,
        time.process_time() - used,
    )


SOLVERS: dict[str, Callable[[FuzzyTask, float], Answer]] = {
    "auto": ours(None),
    "labels": ours(Labels()),
    "milp": ours(Milp()),
    "local-search": ours(LocalSearch()),
    "cp-sat": cp_sat,
    "time-indexed": time_indexed,
}
"""All by their names on the command line."""
