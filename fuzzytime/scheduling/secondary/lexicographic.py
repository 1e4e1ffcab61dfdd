"""The best of the schedules that satisfy equally, by secondary objectives.

The found schedule leaves each skill a set of starts at which it is as satisfied as it is now; a solver then
arranges the skills within these sets by what an objective wishes, so that no satisfaction falls. Several
objectives count one after the other, each among the schedules that the ones before it leave.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import Floats, Interval, SatisfactionFunction
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Job, Lag, Problem
from fuzzytime.scheduling.problem.windows import above, in_common
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.secondary.as_said import in_order_said
from fuzzytime.scheduling.secondary.clusters import with_clusters_moved
from fuzzytime.scheduling.secondary.distances import at_distances, wished_distances
from fuzzytime.scheduling.secondary.objectives import Arrangement, Objective
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.chains import Block, by_the_clock, round_blocks
from fuzzytime.scheduling.timing.settle import lanes_of_agents, nearest, sequences, settled
from fuzzytime.skills import FuzzySkill, FuzzyTask

AT_AN_END = 1e-6
"""Seconds: a start so near to the end of the starts that are as good is that end, but for rounding."""

FLAT = 1.0
"""Seconds: where a skill may move by less than this, it does not move at all."""

SEARCHED = 50
"""Up to so many skills another order is sought even where no start was named, and pauses keep that said."""

COUNTS = 1e3
"""How much a gentle wish counts: enough for a search to see the difference of a second in a long horizon."""

UNWANTED = 1e3 * COUNTS
"""The cost of leaving a skill out, far above that of any start."""

TURNS = 4
"""How often an objective is followed at most where what is at a distance from others follows them."""

EQUAL = 1e-9
"""Costs of wishes that differ by less are equal."""

NAMED = 1e-6
"""Seconds: a start so near to the one that was named is that one, and two skills so near follow on."""


def rearranged(
    problem: Problem,
    task: FuzzyTask,
    draft: Draft,
    objectives: Sequence[Objective],
    watch: Stopwatch,
) -> Draft:
    """Give the best draft, by some objectives in turn, of those that satisfy each skill as well as one does.

    Parameters
    ----------
    problem
        What the draft solves.
    task
        The problem's: its skills are found by the jobs' positions.
    draft
        Jobs that it rejects stay so.
    objectives
        The first counts most.
    watch
        The order of the skills is kept where it is over.
    """
    placed = [index for index, start in enumerate(draft.starts.tolist()) if not math.isnan(start)]
    first = problem.select(placed)
    starts, agents = draft.starts[placed], draft.agents[placed]
    lanes = lanes_of_agents(problem)
    equal = _as_good(first, starts, agents, lanes)
    mine = tuple(task.skills[job.position] for job in equal.jobs)
    distances = wished_distances(task, [job.position for job in equal.jobs])
    for objective in objectives:
        reach = max((job.latest for job in equal.jobs), default=0.0) + 1.0
        wishing, following = equal, mine
        for _ in range(TURNS if distances else 1):
            # What is at a distance from another follows it when that has its place.
            arrangement = Arrangement(following, tuple(starts.tolist()), tuple(agents.tolist()), reach)
            wishing = replace(equal, jobs=tuple(map(_wishing, equal.jobs, objective.wishes(arrangement))))
            for members in wishing.groups():
                named = any(following[member].preferred is not None for member in members)
                search = objective.reorders and (named or len(members) <= SEARCHED)
                group = wishing.select(members)
                found = _best(group, starts[members], agents[members], watch if search else None)
                if search and objective.in_order and group.lags and len(members) <= SEARCHED:
                    near = [at for at, one in enumerate(members) if following[one].preferred is not None]
                    found = in_order_said(group, found, near)
                starts[members], agents[members] = found.starts, found.agents
            before, following = following, at_distances(mine, distances, starts)
            if following == before:
                break
        bounds = objective.bounds(Arrangement(mine, tuple(starts.tolist()), tuple(agents.tolist()), reach))
        equal = _bounded(_as_good(wishing, starts, agents, lanes), starts, bounds)
    everything, everyone = draft.starts.copy(), draft.agents.copy()
    everything[placed], everyone[placed] = _rounded(first, task, starts, agents), agents
    return draft_of(problem, everything, everyone, draft.lower_cost)


def _as_good(problem: Problem, starts: Floats, agents: Ints, lanes: Mapping[int, int]) -> Problem:
    """Narrow all windows to the starts at which a job costs no more than at its own."""
    jobs = []
    for job, start, agent in zip(problem.jobs, starts.tolist(), agents.tolist(), strict=True):
        level = float(np.nextafter(float(job.function(start)), -1.0))
        good = above(job.function, level, max(job.latest, start))
        windows = []
        for index, lane in enumerate(job.windows):
            spans = [_with(span, start) for span in in_common(lane, good)]
            if index == lanes[agent] and not any(start in span for span in spans):
                spans = sorted([*spans, Interval(start, start)], key=lambda span: span.low)
            windows.append(tuple(spans))
        jobs.append(replace(job, windows=tuple(windows)))
    return replace(problem, jobs=tuple(jobs))


def _bounded(problem: Problem, starts: Floats, bounds: Sequence[Interval]) -> Problem:
    """Cut windows to bounds, which hold the starts but for rounding."""
    jobs = []
    for job, start, bound in zip(problem.jobs, starts.tolist(), bounds, strict=True):
        within = Interval(min(bound.low, start), max(bound.high, start))
        jobs.append(replace(job, windows=tuple(in_common(lane, [within]) for lane in job.windows)))
    return replace(problem, jobs=tuple(jobs))


def _with(span: Interval, start: float) -> Interval:
    """Let a span end at a start that is at its end; one without room to speak of is the start alone."""
    low = start if abs(span.low - start) <= AT_AN_END else span.low
    high = start if abs(span.high - start) <= AT_AN_END else span.high
    return Interval(start, start) if low <= start <= high and high - low < FLAT else Interval(low, high)


def _wishing(job: Job, wish: SatisfactionFunction) -> Job:
    """Give a job with another satisfaction function, that must not be left out."""
    return replace(job, function=wish, weight=COUNTS, worst=UNWANTED, rejection=UNWANTED, over=math.inf)


def _best(problem: Problem, starts: Floats, agents: Ints, watch: Stopwatch | None) -> Draft:
    """Give the best timing of the order that is, and with a stopwatch that of any order."""
    best = draft_of(problem, starts, agents)
    reach = max(job.latest - job.earliest for job in problem.jobs)
    again = settled(problem, starts, agents, reach + 1.0)
    best = min(best, again, key=lambda draft: draft.cost)
    if watch is None or watch.is_over() or best.cost <= problem.least_cost + EQUAL:
        return best
    best = with_clusters_moved(problem, LocalSearch().search(problem, watch, best), watch)
    return _exchanged(problem, best, watch) if len(problem.jobs) <= SEARCHED else best


def _exchanged(problem: Problem, best: Draft, watch: Stopwatch) -> Draft:
    """Let what was said first and comes later change places, as a search that moves one at a time cannot.

    Only two whose starts would please both together more if they were exchanged are tried.
    """
    reach = max(job.latest - job.earliest for job in problem.jobs)
    lengths = np.array([job.duration for job in problem.jobs])
    better = True
    while better:
        better = False
        behind = best.starts[:, None] + lengths[:, None] - lengths[None, :]
        own = np.array([job.costs(start) for job, start in zip(problem.jobs, best.starts, strict=True)])
        sooner = np.array([job.costs(best.starts) for job in problem.jobs])
        later = np.array([job.costs(times) for job, times in zip(problem.jobs, behind.T, strict=True)]).T
        gains = own[:, None] + own[None, :] - sooner - later
        late = np.triu(best.starts[:, None] > best.starts[None, :], 1)
        late &= best.agents[:, None] == best.agents[None, :]
        for first, second in np.argwhere(late & (gains > EQUAL)).tolist():
            if watch.is_over():
                return best
            hints = best.starts.copy()
            hints[[first, second]] = best.starts[[second, first]]
            found = settled(problem, hints, best.agents, reach + 1.0)
            if found.cost < best.cost - EQUAL:
                # What is gained by others is told by the new places.
                best, better = found, True
                break
    return best


def _rounded(problem: Problem, task: FuzzyTask, starts: Floats, agents: Ints) -> Floats:
    """Move what goes on without a pause to the roundest time near by, unless it is where it was named."""
    rounded = starts.copy()
    for agent, row in sequences(problem, starts, agents).items():
        lane = lanes_of_agents(problem)[agent]
        jobs = [problem.jobs[index] for index in row]
        windows = nearest([job.windows[lane] for job in jobs], starts[row])
        blocks = _blocks(jobs, windows, starts[row], task.skills)
        _hold(blocks, row, problem.lags)
        round_blocks(jobs, blocks)
        following = [*(block.start for block in blocks[1:]), math.inf]
        for block, after in zip(blocks, following, strict=False):
            if task.skills[jobs[block.members[0]].position].by_the_clock:
                by_the_clock(jobs, block, after, task.past_hour)
        for block in blocks:
            if block.low <= block.start <= block.high:
                members = [row[place] for place in block.members]
                ends = np.array([(windows[place].low, windows[place].high) for place in block.members])
                # Rounding in long sums must not push a start out of its window.
                rounded[members] = np.clip(block.start + np.array(block.offsets), *ends.T)
    return rounded


def _blocks(
    jobs: Sequence[Job], windows: Sequence[Interval], starts: Floats, skills: Sequence[FuzzySkill]
) -> list[Block]:
    """Give what one agent does without a pause, and from when to when each may begin as a whole."""
    blocks: list[Block] = []
    free = -math.inf
    for place, (job, window, start) in enumerate(zip(jobs, windows, starts.tolist(), strict=True)):
        follows_on = start <= free + NAMED
        if not follows_on:
            blocks.append(Block([], [], -math.inf, math.inf, start))
        block = blocks[-1]
        # Without what rounding left between two skills, or the end of the last one's window binds all.
        offset = block.offsets[-1] + jobs[place - 1].duration if follows_on else 0.0
        block.members.append(place)
        block.offsets.append(offset)
        named = any(abs(time - start) <= NAMED for time in skills[job.position].named)
        low, high = (start, start) if named else (window.low, window.high)
        block.low, block.high = max(block.low, low - offset), min(block.high, high - offset)
        free = start + job.duration
    return blocks


def _hold(blocks: Sequence[Block], row: Sequence[int], lags: Sequence[Lag]) -> None:
    """Let blocks stay where they are that lags bind to what is not part of them."""
    block_of = {row[place]: block for block in blocks for place in block.members}
    for lag in lags:
        first, second = block_of.get(lag.first), block_of.get(lag.second)
        for block in (first, second):
            if block is not None and first is not second:
                block.low = block.high = block.start
