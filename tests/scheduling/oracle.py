"""An independent optimiser for small tasks: every accepted set in every order, timed over a common lattice.

It shares no code with the solvers. With s_k = t_k − (durations before k) the s_k of an order do not decrease;
over a lattice of s that holds all corners less all sums of durations, and fine steps between, dynamic
programming finds the best timing of an order to within the steps.
"""

import itertools
import math

import numpy as np

from fuzzytime.skills import FuzzyTask


def best_cost(task: FuzzyTask, threshold: float, step: float = 0.25) -> float:
    """Give the least Σ −priority·log max(ψ, ε) for one agent; precedences without lags are kept."""
    count = len(task.skills)
    lattice = _lattice(task, step)
    rejection = [-skill.priority * math.log(threshold) for skill in task.skills]
    for index, skill in enumerate(task.skills):
        if float(skill.satisfaction(math.inf)) > threshold:
            rejection[index] = -skill.priority * math.log(float(skill.satisfaction(math.inf)))
    best, known = math.inf, dict[tuple[int, float], np.ndarray]()
    for size in range(count + 1):
        for order in itertools.permutations(range(count), size):
            if _keeps(task, order):
                left_out = math.fsum(rejection[index] for index in range(count) if index not in order)
                best = min(best, left_out + _timed(task, order, lattice, threshold, known))
    return best


def _keeps(task: FuzzyTask, order: tuple[int, ...]) -> bool:
    place = {index: rank for rank, index in enumerate(order)}
    return all(
        entry.second not in place or place.get(entry.first, math.inf) < place[entry.second]
        for entry in task.precedences
    )


def _lattice(task: FuzzyTask, step: float) -> np.ndarray:
    corners = {0.0} | {entry.end for entry in task.busy}
    sums = {0.0}
    for skill in task.skills:
        corners |= {kink for kink in skill.satisfaction.kinks if math.isfinite(kink)}
        corners |= {entry.start - skill.duration for entry in task.busy}
        sums |= {total + skill.duration for total in sums}
    exact = np.array([corner - total for corner in corners for total in sums])
    reach = max(corners) + max(sums)
    return np.unique(np.concatenate([np.arange(-max(sums), reach, step), exact]))


def _timed(
    task: FuzzyTask,
    order: tuple[int, ...],
    lattice: np.ndarray,
    threshold: float,
    known: dict[tuple[int, float], np.ndarray],
) -> float:
    """Give what an order costs at its best; ``known`` is what skills cost behind so many seconds."""
    best = np.zeros(lattice.size)
    before = 0.0
    for index in order:
        if (index, before) not in known:
            known[index, before] = _costs(task, index, lattice + before, threshold)
        best = np.minimum.accumulate(best + known[index, before])
        before += task.skills[index].duration
    return float(best[-1])


def _costs(task: FuzzyTask, index: int, times: np.ndarray, threshold: float) -> np.ndarray:
    skill = task.skills[index]
    start = _on_corners(times, task, index)
    value = skill.satisfaction(start)
    allowed = (start >= 0) & (value > threshold)
    for entry in task.busy:
        allowed &= (start <= entry.start - skill.duration) | (start >= entry.end)
    with np.errstate(divide="ignore"):
        return np.where(allowed, -skill.priority * np.log(value), np.inf)


def _on_corners(times: np.ndarray, task: FuzzyTask, index: int) -> np.ndarray:
    """Corners less sums of durations, plus those durations again, differ from corners by rounding."""
    skill = task.skills[index]
    corners = np.unique(
        [0.0, *skill.satisfaction.kinks]
        + [entry.end for entry in task.busy]
        + [entry.start - skill.duration for entry in task.busy]
    )
    place = np.clip(np.searchsorted(corners, times - 1e-9), 0, corners.size - 1)
    return np.where(np.abs(corners[place] - times) <= 1e-9, corners[place], times)


def best_shared_cost(task: FuzzyTask, threshold: float) -> float:
    """Give the same for several agents and no precedences: every way to share the skills out."""
    count = len(task.skills)
    agents = range(1, task.agents + 1)
    alone: dict[tuple[int, tuple[int, ...]], float] = {}
    best = math.inf
    for choice in itertools.product(agents, repeat=count):
        wrong = [skill.agent not in {None, agent} for skill, agent in zip(task.skills, choice, strict=True)]
        if any(wrong):
            continue
        total = 0.0
        for agent in agents:
            mine = tuple(index for index in range(count) if choice[index] == agent)
            if (agent, mine) not in alone:
                skills = tuple(task.skills[index] for index in mine)
                busy = tuple(entry for entry in task.busy if entry.agent in {None, agent})
                alone[agent, mine] = best_cost(FuzzyTask(skills, busy=busy, agents=task.agents), threshold)
            total += alone[agent, mine]
        best = min(best, total)
    return best


def best_whole_cost(task: FuzzyTask, threshold: float, last: int) -> float:
    """Give the least cost over whole start times up to the last, by trying all.

    Where every ψ is a staircase whose steps, like all durations and lags, are whole numbers, no other times
    are better: the times of a schedule can be rounded without breaking a difference of whole numbers. What
    satisfies for ever, and need not follow anything closely, may be done later than the last time.
    """
    count = len(task.skills)
    order = _after_what_must_come_before(task)
    times = np.arange(last + 1, dtype=float)
    costs = []
    for skill in task.skills:
        value = skill.satisfaction(times)
        with np.errstate(divide="ignore"):
            costs.append(np.where(value > threshold, -skill.priority * np.log(value), np.inf).tolist())
    closely = {entry.second for entry in task.precedences if entry.maximum_lag < math.inf}
    late = [
        0.0 if index in closely else float(skill.satisfaction(math.inf))
        for index, skill in enumerate(task.skills)
    ]
    rejections = [
        -skill.priority * math.log(max(threshold, level))
        for skill, level in zip(task.skills, late, strict=True)
    ]
    least = [min(*mine, worst) for mine, worst in zip(costs, rejections, strict=True)]
    rest = [math.fsum(least[index] for index in order[depth:]) for depth in range(count + 1)]
    chosen: dict[int, tuple[int, int] | None] = {}
    best = math.fsum(rejections)

    def descend(depth: int, cost: float) -> None:
        nonlocal best
        if cost + rest[depth] >= best:
            return
        if depth == count:
            best = cost
            return
        index = order[depth]
        for agent in _agents(task, index):
            possible = _starts(task, chosen, index, last, agent)
            # The cheapest first: those behind one that cannot be better cannot be, either.
            for value, start in sorted((costs[index][start], start) for start in possible):
                if value == math.inf or cost + value + rest[depth + 1] >= best:
                    break
                chosen[index] = (start, agent)
                descend(depth + 1, cost + value)
        chosen[index] = None
        descend(depth + 1, cost + rejections[index])
        del chosen[index]

    descend(0, 0.0)
    return best


def _after_what_must_come_before(task: FuzzyTask) -> list[int]:
    order: list[int] = []
    while len(order) < len(task.skills):
        missing = {entry.second for entry in task.precedences if entry.first not in order}
        order.append(min(set(range(len(task.skills))) - missing - set(order)))
    return order


def _agents(task: FuzzyTask, index: int) -> range:
    """Give who may do a skill; an event takes nobody from work, whoever it is of."""
    skill = task.skills[index]
    if skill.agent is not None:
        return range(skill.agent, skill.agent + 1)
    return range(1, 2 if skill.happens else task.agents + 1)


def _starts(
    task: FuzzyTask, chosen: dict[int, tuple[int, int] | None], index: int, last: int, agent: int
) -> list[int]:
    """Give when an agent may start a skill beside what was chosen before."""
    skill = task.skills[index]
    taken = [(entry.start, entry.end) for entry in task.busy if entry.agent in {None, agent}]
    for other, place in chosen.items():
        if other != index and place is not None and place[1] == agent and not task.skills[other].happens:
            taken.append((place[0], place[0] + task.skills[other].duration))
    starts = list(range(last + 1))
    if not skill.happens:
        for low, high in taken:
            starts = [start for start in starts if start >= high or start + skill.duration <= low]
    for entry in task.precedences:
        if entry.second == index:
            place = chosen[entry.first]
            if place is None:
                return []
            low, high = entry.minimum_lag, entry.maximum_lag
            done = place[0] + task.skills[entry.first].time_until_done
            starts = [start for start in starts if low <= start - done <= high]
    return starts
