"""Random small tasks in which skills follow others closely: events, curves, and what satisfies for ever."""

from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import ALWAYS, Rectangle, SatisfactionFunction
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import LAST, random_bound_task, random_function


def random_close_task(seed: int, most: int = 4) -> FuzzyTask:
    """Draw a task of curves of any kind: whole seconds are good start times, but seldom the best."""
    task = random_bound_task(seed, most)
    generator = np.random.default_rng([seed, 4])
    skills = tuple(
        replace(
            skill,
            satisfaction=random_function(generator, float(LAST)),
            priority=float(generator.choice([1, 1, 2, 0.5])),
            duration=float(generator.choice([0, skill.duration])),
        )
        for skill in task.skills
    )
    return replace(task, skills=skills)


def random_event_task(seed: int, most: int = 5) -> FuzzyTask:
    """Draw a task of steps for one or two agents with events, whose moment is mostly not known."""
    task = random_endless_task(seed, most)
    generator = np.random.default_rng([seed, 5])
    skills = [
        replace(skill, duration=0.0, elapsed=None, agent=None, happens=True)
        if generator.random() < 0.4
        else skill
        for skill in task.skills
    ]
    return replace(task, skills=tuple(skills))


def random_endless_task(seed: int, most: int = 4) -> FuzzyTask:
    """Draw a task of steps, some of which satisfy for ever, where some must follow others closely."""
    generator = np.random.default_rng([seed, 6])
    count, agents = int(generator.integers(2, most + 1)), int(generator.choice([1, 1, 2]))
    skills = [
        FuzzySkill(
            f"skill {index}",
            _step(generator),
            duration := float(generator.integers(1, 8)),
            elapsed=duration + float(generator.choice([0, 0, 5])),
            agent=int(generator.integers(1, agents + 1)) if generator.random() < 0.2 else None,
        )
        for index in range(count)
    ]
    precedences = []
    for pair in [(first, second) for second in range(count) for first in range(second)]:
        if generator.random() < 0.5:
            low = float(generator.choice([0, 0, 2, -3]))
            precedences.append(Precedence(*pair, low, low + float(generator.choice([np.inf, 0, 3, 6]))))
    start = float(generator.integers(0, 12))
    busy = (Busy(start, start + 4),) if generator.random() < 0.3 else ()
    return FuzzyTask(tuple(skills), agents, tuple(precedences), busy)


def _step(generator: np.random.Generator) -> SatisfactionFunction:
    """A step up, a step down, both, or none: in the first twelve seconds."""
    low, high = np.sort(generator.integers(0, 13, 2)).astype(float).tolist()
    match generator.choice(["after", "until", "between", "moment", "always"]):
        case "after":
            return Rectangle(low, np.inf)
        case "until":
            return Rectangle(-np.inf, high)
        case "between":
            return Rectangle(low, high)
        case "moment":
            return Rectangle(low, low)
        case _:
            return ALWAYS
