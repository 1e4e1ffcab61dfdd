"""The best start times, in continuous time, for jobs in a fixed order on one agent.

Minimise Σ f_k(t_k) with t_k+1 ≥ t_k + d_k and t_k in a window. With s_k = t_k − D_k, D_k the durations before
k, the s_k must not decrease: a separable isotonic problem. Where every f_k is convex (ψ log-concave) *pooling
adjacent violators* solves it: blocks of jobs without idle time between them, each at its own best time, merge
while one would start before the block in front of it has ended. Best, Chakravarti and Ubhaya, Minimizing
separable convex functions subject to simple chain constraints, SIAM J. Optim. 10 (2000) 658-672.

Other curves are first searched by dynamic programming over candidate times near a given timing, in ever
smaller steps; pooling then settles the timing within the pieces of windows that were found.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

import numpy as np

from fuzzytime.satisfaction import EVERYWHERE, Floats, Interval
from fuzzytime.scheduling.problem.jobs import Job

SAMPLES = 100
"""Times at which a block's cost is compared in each round of its minimisation."""

PRECISION = 1e-10
"""Relative precision of times."""

MOMENT = 1.0
"""Seconds that times may be past a round one of the clock: a plan need not begin at a full second."""

SLACK = 1e-12
"""Costs that differ by less are equal: the earliest time, or a corner, is then preferred."""


ROUND = np.array([60.0, 30.0, 15.0, 10.0, 5.0, 1.0, 0.5, 0.1, 0.01, 0.001])
"""Units that people would round a start time to, in seconds."""

CLOCK = (900.0, 300.0)
"""Units of the clock that people meet at, the rounder first: a quarter of an hour, five minutes."""

AHEAD = 2.0
"""A start is put off to a unit of the clock only if it lies so many units ahead."""

SLOPE = 0.05
"""What changes by more from a second to the next is a time that somebody named, and no slope."""

NEXT_TO_NOTHING = 1e-11
"""What a rounder time may cost."""

NEAR = 0.5
"""How far away it may be, in seconds."""

JUMP = 1e-3
"""Costs that differ by more within the precision of times do so at a jump."""


@dataclass(slots=True)
class Block:
    """Jobs in a row without idle time, their offsets from the block's start, and where it starts."""

    members: list[int]
    offsets: list[float]
    low: float
    high: float
    start: float = 0.0


def pooled(jobs: Sequence[Job], windows: Sequence[Interval]) -> Floats | None:
    """Give the best start times, the earliest among equals, or None where the jobs do not fit in this order.

    Parameters
    ----------
    jobs
        In their order, each with a convex cost in its window.
    windows
        One for each job.
    """
    spans = _fitting(jobs, windows)
    if spans is None:
        return None
    blocks = [
        Block([index], [0.0], low, high, min(max(job.function.best.low, low), high))
        for index, (job, (low, high)) in enumerate(zip(jobs, spans, strict=True))
    ]
    count = len(blocks) + 1
    while len(blocks) < count:
        count = len(blocks)
        blocks = [_merged(jobs, run) for run in _runs(jobs, blocks)]
    round_blocks(jobs, blocks)
    starts = np.empty(len(jobs))
    for block in blocks:
        for member, offset in zip(block.members, block.offsets, strict=True):
            # Rounding in long sums must not push a start out of its window.
            starts[member] = min(max(block.start + offset, windows[member].low), windows[member].high)
    return starts


def _runs(jobs: Sequence[Job], blocks: Sequence[Block]) -> list[list[Block]]:
    """Put blocks together of which each would start before the one in front of it has ended.

    Neighbours of which that holds follow each other without idle time in the best timing, whatever the
    others do: so all of a run become one block at once.
    """
    runs = [[block] for block in blocks[:1]]
    for before, block in pairwise(blocks):
        if before.start + _length(jobs, before) > block.start:
            runs[-1].append(block)
        else:
            runs.append([block])
    return runs


def _merged(jobs: Sequence[Job], run: Sequence[Block]) -> Block:
    """Make one block of several, and give it its best start."""
    if len(run) == 1:
        return run[0]
    before = list(accumulate((_length(jobs, block) for block in run[:-1]), initial=0.0))
    pairs = list(zip(run, before, strict=True))
    merged = Block(
        [member for block in run for member in block.members],
        [past + offset for block, past in pairs for offset in block.offsets],
        max(block.low - past for block, past in pairs),
        min(block.high - past for block, past in pairs),
    )
    # The best of a sum of convex costs lies between the first and the last of their best.
    merged.start = best_start(jobs, merged, Interval(run[-1].start - before[-1], run[0].start))
    return merged


def round_blocks(jobs: Sequence[Job], blocks: Sequence[Block]) -> None:
    """Move each block to the roundest start that costs next to nothing more."""
    free = -math.inf
    for index, block in enumerate(blocks):
        length = _length(jobs, block)
        after = blocks[index + 1].start if index + 1 < len(blocks) else math.inf
        low, high = max(block.low, free), min(block.high, after - length)
        times = np.append(np.rint(block.start / ROUND) * ROUND, block.start)
        slack = PRECISION * max(1.0, abs(block.start))
        cost, known = np.zeros(times.size), 0.0
        for member, offset in zip(block.members, block.offsets, strict=True):
            nearly = block.start + np.array([-slack, slack])
            costs = jobs[member].costs(np.append(times, nearly) + offset)
            cost += costs[: times.size]
            here, beside = float(costs[times.size - 1]), float(costs[times.size :].min())
            # At a jump, what rounding has added to the start that is may seem to cost much.
            known += beside if here > beside + JUMP else here
        good = (cost <= known + NEXT_TO_NOTHING) & (times >= low) & (times <= high)
        good &= np.abs(times - block.start) <= NEAR
        good[-1] = True
        block.start = float(times[np.argmax(good)])
        free = block.start + length


def by_the_clock(jobs: Sequence[Job], block: Block, after: float, past_hour: float) -> None:
    """Put a block off to a round time of the clock, where it begins as soon as a vague time is fully there.

    That minute is an accident of how gently its satisfaction rises: nobody named it. Nothing is lost, as all
    of the block satisfies as well at the round time, which comes before ``after``.
    """
    first, start = jobs[block.members[0]], block.start
    rises = float(first.function(start)) - float(first.function(start - 1.0))
    if not 0 < rises < SLOPE:
        return
    last = min(block.high, after - _length(jobs, block))
    for unit in CLOCK:
        time = unit * math.ceil((start + past_hour - MOMENT) / unit) - past_hour
        if abs(time - start) <= MOMENT:
            # It is round already, to who looks at a clock.
            return
        if start >= AHEAD * unit and time <= last and _costs(jobs, block, time, start):
            block.start = time
            return


def _costs(jobs: Sequence[Job], block: Block, time: float, before: float) -> bool:
    """Tell whether a block costs next to nothing more at another time."""
    parts = list(zip(block.members, block.offsets, strict=True))
    more = (float(jobs[job].costs(time + by) - jobs[job].costs(before + by)) for job, by in parts)
    return math.fsum(more) <= NEXT_TO_NOTHING


def _fitting(jobs: Sequence[Job], windows: Sequence[Interval]) -> list[tuple[float, float]] | None:
    """Narrow windows until each bound can be met by the jobs before and after."""
    lows, earliest = [], -math.inf
    for job, window in zip(jobs, windows, strict=True):
        earliest = max(earliest, window.low)
        lows.append(earliest)
        earliest += job.duration
    highs, latest = [], math.inf
    for job, window in zip(reversed(jobs), reversed(windows), strict=True):
        latest = min(latest - job.duration, window.high)
        highs.append(latest)
    spans = list(zip(lows, reversed(highs), strict=True))
    if any(low > high + PRECISION * max(1.0, abs(low)) for low, high in spans):
        return None
    return spans


def _length(jobs: Sequence[Job], block: Block) -> float:
    return block.offsets[-1] + jobs[block.members[-1]].duration


def best_start(jobs: Sequence[Job], block: Block, within: Interval = EVERYWHERE) -> float:
    """Minimise the cost of a block over its start: the earliest best one of ever finer samples."""
    low, high = max(block.low, within.low), min(block.high, within.high)
    if high <= low:
        return low
    pairs = [(jobs[member], offset) for member, offset in zip(block.members, block.offsets, strict=True)]

    def cost_at(times: Floats) -> Floats:
        return np.asarray(sum(job.costs(times + offset) for job, offset in pairs))

    kinks = np.concatenate([np.asarray(job.function.kinks) - offset for job, offset in pairs])
    marks = np.concatenate([[low, high], kinks[(kinks > low) & (kinks < high)]])
    span = PRECISION * max(1.0, abs(low), abs(high))
    times = np.sort(np.concatenate([marks, np.linspace(low, high, SAMPLES)]))
    while high - low > span:
        cost = cost_at(times)
        least = int(np.argmax(cost <= cost.min() + SLACK))
        best = times[least]
        low, high = float(times[max(least - 1, 0)]), float(times[min(least + 1, times.size - 1)])
        marks = marks[(marks >= low) & (marks <= high)]
        if best in marks:
            # At a corner that is best among its near neighbours, convexity ends the search.
            near = cost_at(np.clip([best - 1e3 * span, best, best + 1e3 * span], block.low, block.high))
            if near[1] <= near[0] and near[1] <= near[2]:
                return float(best)
        times = np.sort(np.concatenate([marks, np.linspace(low, high, SAMPLES)]))
    cost = cost_at(times)
    return float(times[np.argmax(cost <= cost.min() + SLACK)])
