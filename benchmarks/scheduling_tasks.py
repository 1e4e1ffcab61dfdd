"""Families of random tasks: wishes spread over the time that the work needs, or crowded about few moments."""

from enum import StrEnum

import numpy as np

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.skills import FuzzySkill, FuzzyTask


class Kind(StrEnum):
    """Where wishes lie."""

    SPREAD = "spread"
    HOT = "hot"


def random_task(count: int, load: float, kind: Kind, seed: int, agents: int = 1) -> FuzzyTask:
    """Draw trapezoids and durations in whole seconds.

    Parameters
    ----------
    count
        Skills.
    load
        Work by time: above 1 some skill must suffer.
    kind
        Spread evenly, or crowded about one moment and one more for every ten skills.
    seed
        Of the draw.
    agents
        Who share the work.
    """
    generator = np.random.default_rng([count, round(100 * load), agents, kind == Kind.HOT, seed])
    durations = 5.0 * generator.integers(6, 121, count)
    horizon = durations.sum() / (load * agents)
    if kind is Kind.HOT:
        moments = generator.uniform(0.1, 0.9, 1 + count // 10) * horizon
        near = generator.normal(0, 0.03 * horizon / np.sqrt(moments.size), count)
        wishes = np.abs(generator.choice(moments, count) + near)
    else:
        wishes = generator.uniform(0, horizon, count)
    # People are vaguer about what is further away, though not in proportion (the paper's section IV).
    vague = np.where(wishes <= 3600, wishes, 60 * np.sqrt(np.maximum(wishes, 1.0)))
    plateau = generator.uniform(0.02, 0.15, (2, count)) * vague
    flank = 30 + generator.uniform(0.05, 0.3, (2, count)) * vague
    start, end = np.rint(np.maximum(0, wishes - plateau[0])), np.rint(wishes + plateau[1])
    corners = np.rint([start - flank[0], start, end, end + flank[1]]).T
    return FuzzyTask(
        tuple(
            FuzzySkill(f"skill {index}", Trapezoid(*row), duration)
            for index, (row, duration) in enumerate(zip(corners.tolist(), durations.tolist(), strict=True))
        ),
        agents,
    )
