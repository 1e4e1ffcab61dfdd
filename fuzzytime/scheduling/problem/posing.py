"""Pose a task as the problem that is solved, worked out once for every solver."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import EMPTY, Interval, SatisfactionFunction
from fuzzytime.scheduling.problem.jobs import Job, Lag, Lane, Problem
from fuzzytime.scheduling.problem.windows import INSIDE, free_of, in_common, strictly_above
from fuzzytime.scheduling.schedule import TINY
from fuzzytime.skills import FuzzySkill, FuzzyTask, Precedence


def problem_of(task: FuzzyTask, threshold: float) -> Problem:
    """Work out a task for the solvers.

    Raises
    ------
    FuzzytimeError
        If the threshold is not in [0, 1).
    """
    if not 0 <= threshold < 1:
        raise FuzzytimeError(f"a threshold must be at least 0 and below 1, got {threshold}")
    floor = threshold or TINY
    lanes = _lanes(task)
    horizon = horizon_of(task, floor)
    bound = {precedence.second for precedence in task.precedences if precedence.maximum_lag < math.inf}
    # In the strict product any schedule without a rejection beats every one with: none may cost as much.
    strict = 1 - math.log(floor) * math.fsum(skill.priority for skill in task.skills)
    jobs: dict[int, Job] = {}
    following: dict[int, list[Precedence]] = {}
    for entry in task.precedences:
        following.setdefault(entry.first, []).append(entry)
    for position in _from_the_last(task):
        skill = task.skills[position]
        mine = [lane if _may_do(lane, skill, task) else None for lane in lanes]
        late = 0.0
        if position not in bound and any(lane is not None and lane.is_free_at_last for lane in mine):
            late = float(skill.satisfaction(math.inf))
        wanted = strictly_above(skill.satisfaction, max(floor, late), horizon)
        if late > floor:
            # What others wait for may have to be done sooner than is best, but not once they are over.
            needed = Interval(-math.inf, _last_needed(skill, following.get(position, ()), jobs))
            in_time = in_common(strictly_above(skill.satisfaction, floor, horizon), [needed])
            wanted = _united(wanted, in_time)
        windows = tuple(() if lane is None else free_of(wanted, lane.busy, skill.duration) for lane in mine)
        worst = -skill.priority * math.log(floor)
        final = -skill.priority * math.log(max(late, floor)) + 0.0
        jobs[position] = Job(
            position,
            skill.satisfaction,
            skill.priority,
            skill.duration,
            skill.time_until_done,
            worst,
            strict if threshold == 0 and late <= floor else final,
            math.inf if late > floor else _over(skill.satisfaction, wanted),
            windows,
        )
    return _bound_by_lags(task, [jobs[position] for position in range(len(jobs))], following, lanes, horizon)


def _from_the_last(task: FuzzyTask) -> list[int]:
    """Give the positions of skills, each behind those that must come after it."""
    leaders: dict[int, list[int]] = {}
    waiting = [0] * len(task.skills)
    for entry in task.precedences:
        leaders.setdefault(entry.second, []).append(entry.first)
        waiting[entry.first] += 1
    last = [position for position, count in enumerate(waiting) if not count]
    for position in last:
        for leader in leaders.get(position, ()):
            waiting[leader] -= 1
            if not waiting[leader]:
                last.append(leader)
    return last


def _last_needed(skill: FuzzySkill, following: Sequence[Precedence], jobs: Mapping[int, Job]) -> float:
    """Give the last start of a skill after which any other that waits for it can still start in a window."""
    lasts = (jobs[entry.second].latest - skill.time_until_done - entry.minimum_lag for entry in following)
    return max(lasts, default=-math.inf)


def _united(spans: Sequence[Interval], others: Sequence[Interval]) -> tuple[Interval, ...]:
    """Give the intervals that cover two rows of intervals, ascending and apart."""
    united: list[Interval] = []
    for span in sorted((*spans, *others), key=lambda span: span.low):
        if united and span.low <= united[-1].high:
            united[-1] = Interval(united[-1].low, max(united[-1].high, span.high))
        else:
            united.append(span)
    return tuple(united)


def _may_do(lane: Lane, skill: FuzzySkill, task: FuzzyTask) -> bool:
    """Tell whether a lane is for a skill: that of nobody for what happens by itself, and for nothing else."""
    if skill.needs_nobody or lane.agents == (task.agents + 1,):
        return skill.needs_nobody and lane.agents == (task.agents + 1,)
    return skill.agent in {None, *lane.agents}


def _lanes(task: FuzzyTask) -> tuple[Lane, ...]:
    """Put agents together who can stand in for each other; one more, nobody, has what happens by itself."""
    named = {skill.agent for skill in task.skills}
    agents: dict[tuple[tuple[tuple[float, float], ...], int | None], list[int]] = {}
    for agent in range(1, task.agents + 1):
        busy = {(entry.start, entry.end) for entry in task.busy if entry.agent in {None, agent}}
        times = tuple(sorted(span for span in busy if span[0] < span[1]))
        agents.setdefault((times, agent if agent in named else None), []).append(agent)
    lanes = [
        Lane(tuple(members), tuple(Interval(low, high) for low, high in times))
        for (times, _), members in agents.items()
    ]
    if any(skill.needs_nobody for skill in task.skills):
        lanes.append(Lane((task.agents + 1,), ()))
    return tuple(lanes)


def horizon_of(task: FuzzyTask, floor: float) -> float:
    """Give a time after which no start is needed.

    After the last kink, or the best times where there is one peak only, and the last appointment every ψ only
    falls, so that idle time can be closed by moving all that follows to an earlier time.
    """
    kinks = [0.0]
    for skill in task.skills:
        function = skill.satisfaction
        rises = (
            (function.best.low, function.best.high)
            if function.log_concave
            else (*function.kinks, *function.crossings(floor)[:1])
        )
        kinks.extend(time for time in rises if math.isfinite(time))
    kinks.extend(entry.end for entry in task.busy if math.isfinite(entry.end))
    lags = [max(map(abs, _finite_lags(entry)), default=0.0) for entry in task.precedences]
    work = [max(skill.duration, skill.time_until_done) for skill in task.skills]
    return max(kinks) + math.fsum(work) + math.fsum(lags)


def _finite_lags(entry: Precedence) -> list[float]:
    """Give the least lag, or the largest where there is no least one, and the wished one, as far as told."""
    bound = entry.minimum_lag if entry.minimum_lag > -math.inf else entry.maximum_lag
    return [lag for lag in (bound, entry.wished_lag or 0.0) if math.isfinite(lag)]


def _over(function: SatisfactionFunction, wanted: tuple[Interval, ...]) -> float:
    """Give a time from which on ψ does not exceed the floor."""
    if not wanted:
        return 0.0
    end = function.support.high
    if end == math.inf:
        return wanted[-1].high + 2 * INSIDE * max(1.0, wanted[-1].high)
    # At a jump ψ keeps its larger value: the next whole second is beyond it.
    return end if float(function(end)) == 0 else math.floor(end) + 1.0


def _bound_by_lags(
    task: FuzzyTask,
    jobs: list[Job],
    following: Mapping[int, Sequence[Precedence]],
    lanes: tuple[Lane, ...],
    horizon: float,
) -> Problem:
    """Narrow windows by what must come before, and set the jobs apart that have none."""
    lags: list[Lag] = []
    for first in reversed(_from_the_last(task)):
        before = jobs[first]
        for entry in following.get(first, ()):
            # No two starts lie farther apart than the horizon.
            low = max(before.elapsed + entry.minimum_lag, -horizon)
            high = before.elapsed + entry.maximum_lag
            lags.append(Lag(first, entry.second, low, high))
            within = Interval(before.earliest + low, before.latest + high) if any(before.windows) else EMPTY
            jobs[entry.second] = _clipped(jobs[entry.second], within)
    everything = Problem(tuple(jobs), lanes, tuple(lags))
    free = _free(task, jobs)
    kept = everything.select([i for i, job in enumerate(jobs) if any(job.windows) and i not in free])
    if lanes[-1].agents == (task.agents + 1,) and not any(job.windows[-1] for job in kept.jobs):
        kept = replace(
            kept, lanes=lanes[:-1], jobs=tuple(replace(job, windows=job.windows[:-1]) for job in kept.jobs)
        )
    apart = tuple(job for job in jobs if not any(job.windows))
    return replace(kept, apart=apart, free=tuple(jobs[index] for index in free))


def _free(task: FuzzyTask, jobs: list[Job]) -> list[int]:
    """Give what happens by itself, and is bound to nothing, or happens at a known moment and after no work.

    What comes after such a moment has no other windows than those that follow it.
    """
    bound = {member for entry in task.precedences for member in (entry.first, entry.second)}
    happening = {
        position
        for position, skill in enumerate(task.skills)
        if skill.needs_nobody
        and any(jobs[position].windows)
        and (position not in bound or jobs[position].earliest == jobs[position].latest)
    }
    while late := {entry.second for entry in task.precedences if entry.first not in happening} & happening:
        happening -= late
    return sorted(happening)


def _clipped(job: Job, within: Interval) -> Job:
    return replace(job, windows=tuple(in_common(lane, [within]) for lane in job.windows))
