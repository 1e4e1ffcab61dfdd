"""Kicks: take some jobs of a rough plan out at once, put them back one by one, keep mostly what is better.

A kick (ruin and recreate: Schrimpf, Schneider, Stamm-Wilbrandt and Dueck, J. Comput. Phys. 159 (2000)
139-171) is given to a stretch of the plan while the rest stands still. A loss is kept, too, with a
probability that falls with its size, and from kick to kick (simulated annealing: Kirkpatrick, Gelatt and
Vecchi, Science 220 (1983) 671-680): where many crowd, one skill less is rejected only by way of schedules
that are worse. The best plan on the way is what remains.
"""

import math

import numpy as np

from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.search.rough import IMPROVEMENT, Rough, Stretch

MOST_KICKED = 4
"""Jobs that a kick takes out, at most: many small kicks find more than few large ones."""

LEAST_TOGETHER, MOST_TOGETHER = 30, 90
"""Jobs that a kicked stretch holds: what is gained in a short one takes long ones to be made room for."""

KICKS_A_STRETCH = 20
"""Kicks before another stretch has its turn."""

HOT, COLD = 0.5, 0.1
"""The temperature at first and at last, in mean weights of a job: what a kick may lose and still be kept."""


def kick(plan: Rough, kicks: int, watch: Stopwatch, generator: np.random.Generator) -> None:
    """Kick stretches of a plan drawn at random, cooler and cooler, and leave it as it was at its best.

    Parameters
    ----------
    plan
        Is changed.
    kicks
        How many, as long as the stopwatch is not over: it cools down in the time that is left.
    """
    count = len(plan.placed)
    weight = plan.problem.weight / max(count, 1)
    best, cost, lowest, done = plan.state(), 0.0, 0.0, 0
    whole = watch.remaining
    while done < kicks and not watch.is_over():
        spent = 1 - watch.remaining / whole if whole < math.inf else 0.0
        heat = weight * HOT * (COLD / HOT) ** max(done / kicks, spent)
        stretch = Stretch(plan, _drawn(plan, generator), generator)
        for _ in range(min(kicks - done, KICKS_A_STRETCH)):
            if watch.is_over():
                break
            _kick(stretch, heat, generator)
        stretch.settle()
        cost, done = cost + stretch.gain - stretch.begun, done + KICKS_A_STRETCH
        if cost < lowest - IMPROVEMENT:
            best, lowest = plan.state(), cost
    plan.restore(best)


def _drawn(plan: Rough, generator: np.random.Generator) -> list[int]:
    """Draw jobs next to each other, those at the ends as often as those in the middle."""
    ranking = plan.in_turn()
    size = min(int(generator.integers(LEAST_TOGETHER, MOST_TOGETHER + 1)), len(ranking))
    middle = int(generator.integers(len(ranking)))
    first = min(max(middle - size // 2, 0), len(ranking) - size)
    return ranking[first : first + size]


def _kick(stretch: Stretch, heat: float, generator: np.random.Generator) -> None:
    """Take several jobs out, neighbours or any, and put them back; undo that where it loses too much."""
    gain, agent_of = stretch.gain, dict(stretch.agent_of)
    states = {agent: order.state() for agent, order in stretch.orders.items()}
    ranking = [job for state in states.values() for job in state.sequence]
    ranking += [job for job in stretch.members if job not in agent_of]
    size = min(int(generator.integers(2, MOST_KICKED + 1)), len(ranking))
    if generator.random() < 0.5:
        middle = int(generator.integers(len(ranking)))
        ranking = ranking[max(middle - size, 0) : middle + size + 1]
    out = generator.permutation(ranking)[:size].tolist()
    for agent, order in stretch.orders.items():
        order.remove_all([job for job in out if agent_of.get(job) == agent])
    for job in out:
        stretch.agent_of.pop(job, None)
    for job in out:
        stretch.reinsert(job)
    if stretch.gain > gain + IMPROVEMENT + heat * generator.exponential():
        stretch.agent_of = agent_of
        for agent, order in stretch.orders.items():
            order.restore(states[agent])
