"""Random small tasks of every kind of ψ, and what every schedule must keep."""

from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import (
    ALWAYS,
    Bell,
    Either,
    Rectangle,
    Sampled,
    SatisfactionFunction,
    Trapezoid,
    Triangle,
)
from fuzzytime.scheduling import Schedule
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence

KINDS = ("trapezoid", "triangle", "rectangle", "spike", "bell", "points", "after", "always")


def random_function(generator: np.random.Generator, horizon: float) -> SatisfactionFunction:
    """Draw ψ about some time before the horizon, with whole numbers every other time."""
    centre, width = generator.uniform(0, horizon), generator.uniform(0.02, 0.4) * horizon
    if generator.random() < 0.5:
        centre, width = round(centre), max(1, round(width))
    match generator.choice(KINDS):
        case "trapezoid":
            return Trapezoid(
                *np.sort(np.round(generator.uniform(centre - width, centre + width, 4), 1)).tolist()
            )
        case "triangle":
            return Triangle(centre - width, centre, centre + width)
        case "rectangle":
            return Rectangle(centre, centre + width)
        case "spike":
            return Rectangle(centre, centre)
        case "bell":
            return Bell(centre, width / 2, float(generator.uniform(0.6, 4)))
        case "points":
            return _random_points(generator, centre, width)
        case "after":
            return Trapezoid(centre, centre + width, np.inf, np.inf)
        case _:
            return ALWAYS


def _random_points(generator: np.random.Generator, centre: float, width: float) -> Sampled:
    """A curve with holes, and often a jump."""
    times = np.unique(
        np.round(generator.uniform(centre - width, centre + width, generator.integers(2, 9)), 1)
    )
    values = generator.uniform(0, 1, times.size)
    values[generator.random(times.size) < 0.25] = 0
    if times.size > 2 and generator.random() < 0.4:
        times, values = np.insert(times, 1, times[1]), np.insert(values, 1, generator.uniform(0, 1))
    return Sampled(times, values)


def random_task(seed: int, most: int = 5) -> FuzzyTask:
    """Draw a task for one agent, often with busy times and precedences."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(2, most + 1))
    durations = generator.uniform(0, 60, count)
    if generator.random() < 0.6:
        durations = np.round(durations)
    if generator.random() < 0.2:
        durations[0] = 0.0
    horizon = max(float(durations.sum()), 5.0) / generator.choice([0.4, 0.8, 1.5])
    skills = tuple(
        FuzzySkill(
            f"skill {index}",
            random_function(generator, horizon),
            float(duration),
            priority=float(generator.choice([1, 1, 2, 0.5])),
        )
        for index, duration in enumerate(durations)
    )
    busy: tuple[Busy, ...] = ()
    if generator.random() < 0.4:
        starts = np.round(generator.uniform(0, horizon, generator.integers(1, 3)), 1)
        busy = tuple(Busy(start, start + float(generator.integers(1, 30))) for start in starts.tolist())
    precedences: tuple[Precedence, ...] = ()
    if generator.random() < 0.3:
        pairs = [(first, second) for second in range(count) for first in range(second)]
        precedences = tuple(Precedence(*pair) for pair in pairs if generator.random() < 0.3)
    return FuzzyTask(skills, precedences=precedences, busy=busy)


def random_either_task(seed: int) -> FuzzyTask:
    """Draw a task for one agent in which several times are offered for each skill."""
    generator = np.random.default_rng([seed, 11])
    task = random_task(seed)
    reach = sum(skill.duration for skill in task.skills) + 20.0

    def hill() -> Trapezoid:
        centre, width = generator.uniform(0, reach), generator.uniform(2, 0.2 * reach)
        return Trapezoid(*np.sort(np.round(generator.uniform(centre - width, centre + width, 4))).tolist())

    offered = [Either([hill() for _ in range(generator.integers(1, 4))]) for _ in task.skills]
    skills = (replace(a, satisfaction=b) for a, b in zip(task.skills, offered, strict=True))
    return replace(task, skills=tuple(skills))


def random_far_task(seed: int) -> tuple[FuzzyTask, list[FuzzyTask]]:
    """Draw a task that lies on several days, up to three months apart; also what each day would be alone."""
    generator = np.random.default_rng([seed, 8])
    days = [random_task(int(generator.integers(10**6)), 3) for _ in range(generator.integers(2, 4))]
    skills: list[FuzzySkill] = []
    busy: list[Busy] = []
    precedences: list[Precedence] = []
    for number, day in enumerate(days):
        by, past = float(number * generator.choice([5 * 3600, 7 * 86400, 30 * 86400])), len(skills)
        for entry in day.precedences:
            precedences.append(replace(entry, first=entry.first + past, second=entry.second + past))
        skills += [replace(skill, satisfaction=skill.satisfaction.shifted(by)) for skill in day.skills]
        busy += [Busy(entry.start + by, entry.end + by) for entry in day.busy]
    return FuzzyTask(tuple(skills), precedences=tuple(precedences), busy=tuple(busy)), days


def random_ready_task(seed: int, most: int = 6) -> FuzzyTask:
    """Draw a task for one agent that may begin with anything: being late is all that can be wrong."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(2, most + 1))
    durations = generator.uniform(1, 60, count)
    if generator.random() < 0.8:
        durations = np.ceil(durations / 5) if generator.random() < 0.5 else np.round(durations)
    work = float(durations.sum())
    skills = []
    for index, duration in enumerate(durations):
        late, vanishing = np.sort(generator.uniform(0, work, 2)).tolist()
        match generator.choice(["trapezoid", "bell", "always", "soon"]):
            case "trapezoid":
                function: SatisfactionFunction = Trapezoid(-np.inf, -np.inf, late, vanishing + work / 2)
            case "soon":
                function = Trapezoid(0.0, 0.0, 0.0, round(vanishing + work))
            case "bell":
                function = Bell(0.0, vanishing + 1, float(generator.uniform(0.6, 4)))
            case _:
                function = ALWAYS
        priority = float(generator.choice([1, 1, 2, 0.5]))
        skills.append(FuzzySkill(f"skill {index}", function, float(duration), priority=priority))
    return FuzzyTask(tuple(skills))


def _inside(start: float, end: float, low: float, high: float) -> bool:
    if start == end:
        return low + 1e-9 < start < high - 1e-9
    return low == high and start + 1e-9 < low < end - 1e-9


def faults(schedule: Schedule) -> list[str]:
    """Say in which way a schedule breaks its task: overlaps, lags, times before now."""
    task, found = schedule.task, []
    taken = {
        agent: [(entry.start, entry.end) for entry in task.busy if entry.agent in {None, agent}]
        for agent in range(1, task.agents + 1)
    }
    working = [skill for skill, its in zip(schedule.skills, task.skills, strict=True) if not its.happens]
    found += [f"{skill.name} starts at {skill.start}" for skill in schedule.skills if skill.start < 0]
    for skill in sorted(working, key=lambda skill: (skill.start, skill.duration)):
        for low, high in taken[skill.agent]:
            # What takes no time must not lie strictly inside, either.
            if min(skill.end, high) - max(skill.start, low) > 1e-9 or _inside(
                skill.start, skill.end, low, high
            ):
                found.append(f"{skill.name} at {skill.start} overlaps {low} to {high}")
        taken[skill.agent].append((skill.start, skill.end))
    for entry in task.precedences:
        gap = schedule.start_times[entry.second] - schedule.skills[entry.first].done
        late = gap > entry.maximum_lag + 1e-9 and not schedule.rejected[entry.second]
        if gap < entry.minimum_lag - 1e-9 or late:
            found.append(f"skill {entry.second} starts {gap} s after skill {entry.first} is done")
    return found


def random_shared_task(seed: int, most: int = 5) -> FuzzyTask:
    """Draw a task for two or three agents, with skills that ask for one and appointments of one."""
    generator = np.random.default_rng([seed, 2])
    agents = int(generator.integers(2, 4))
    task = random_task(seed, most)
    skills = tuple(
        replace(skill, agent=int(generator.integers(1, agents + 1)) if generator.random() < 0.2 else None)
        for skill in task.skills
    )
    busy = tuple(
        replace(entry, agent=int(generator.integers(1, agents + 1)) if generator.random() < 0.5 else None)
        for entry in task.busy
    )
    return FuzzyTask(skills, agents, busy=busy)


LAST = 24
"""The last second in which a skill of `random_bound_task` can start."""


def random_bound_task(seed: int, most: int = 4) -> FuzzyTask:
    """Draw a task of staircases in whole seconds, with lags of every kind, for one to three agents."""
    generator = np.random.default_rng([seed, 3])
    count, agents = int(generator.integers(2, most + 1)), int(generator.choice([1, 1, 2, 3]))
    skills = []
    for index in range(count):
        edges = np.unique(generator.integers(0, LAST, generator.integers(2, 6)))
        values = np.append(generator.uniform(0.05, 1, edges.size), 0.0)
        duration = float(generator.integers(1, 10))
        skills.append(
            FuzzySkill(
                f"skill {index}",
                Sampled(np.repeat(np.append(edges, LAST), 2)[1:], np.repeat(values, 2)[:-1]),
                duration,
                elapsed=duration + float(generator.choice([0, 0, 6])),
                agent=int(generator.integers(1, agents + 1)) if generator.random() < 0.2 else None,
            )
        )
    pairs = [(first, second) for second in range(count) for first in range(second)]
    precedences = []
    for pair in pairs:
        if generator.random() < 0.5:
            low = float(generator.choice([0, 0, 3, -4, -20]))
            precedences.append(Precedence(*pair, low, float(generator.choice([np.inf, low, low + 5]))))
    start = float(generator.integers(0, LAST))
    busy = (Busy(start, start + 5),) if generator.random() < 0.4 else ()
    return FuzzyTask(tuple(skills), agents, tuple(precedences), busy)
