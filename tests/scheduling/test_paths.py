"""Cheapest paths, and the starts that schedules below a cost use, beside all that there are."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.paths import Arcs, Paths, ways_to_end
from fuzzytime.scheduling.exact.backward import used_below
from fuzzytime.scheduling.exact.labels import Labels
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.grid import Ints

Visit = tuple[int, int]


@dataclass(frozen=True)
class Case:
    """A few starts of a few jobs."""

    arcs: Arcs
    durations: Ints
    prices: Floats
    slots: int


@st.composite
def cases(draw: st.DrawFn) -> Case:
    """Draw up to three jobs with starts in up to ten slots."""
    count = draw(st.integers(1, 3))
    durations = np.array(draw(st.lists(st.integers(1, 3), min_size=count, max_size=count)))
    costs = st.integers(-12, -1).map(lambda eighths: eighths / 8)
    starts = [draw(st.dictionaries(st.integers(0, 7), costs, max_size=4)) for _ in range(count)]
    rows = [(job, start, cost) for job, row in enumerate(starts) for start, cost in sorted(row.items())]
    job, start = np.array([row[0] for row in rows], int), np.array([row[1] for row in rows], int)
    gain = np.array([row[2] for row in rows], float)
    prices = np.array(draw(st.lists(st.integers(0, 12), min_size=count, max_size=count))) / 8
    return Case(Arcs(job, start, start + durations[job], gain), durations, prices, 10)


def routes(case: Case, slot: int = 0, last: int = -1) -> Iterator[tuple[tuple[Visit, ...], float]]:
    """Give all ways from a slot on that do no job twice in succession, and what they cost."""
    yield (), 0.0
    for job, start, end, gain in zip(*(column.tolist() for column in case.arcs), strict=True):
        if start >= slot and job != last:
            for rest, cost in routes(case, end, job):
                yield ((job, start), *rest), gain + case.prices[job] + cost


@pytest.mark.parametrize("narrow", [0, 1_000], ids=["narrow blocks", "wide blocks"])
@given(case=cases())
def test_the_cheapest_path_is_the_cheapest_of_all(narrow: int, case: Case) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("fuzzytime.scheduling.bound.paths.NARROW", narrow)
        paths = Paths(case.arcs, case.durations, case.slots)
    least = min(cost for _, cost in routes(case))
    assert float(paths.run(case.prices).cost[-1]) == pytest.approx(least, abs=1e-12)
    found = tuple(reversed(paths.path()))
    costs = dict(routes(case))
    assert costs[found] == pytest.approx(least, abs=1e-12)


@given(cases(), st.integers(0, 10))
def test_the_cheapest_way_to_the_end_without_a_job_in_front_is_that_of_all(case: Case, slot: int) -> None:
    ways = ways_to_end(case.arcs, case.durations, case.slots, case.prices)
    for job in range(case.durations.size):
        others = [cost for route, cost in routes(case, slot) if not route or route[0][0] != job]
        found = float(ways.without(np.array([slot]), np.array([job]))[0])
        assert found == pytest.approx(min(others), abs=1e-12)


@given(cases(), st.integers(-20, 8))
def test_labels_keep_just_the_starts_of_schedules_below_a_cost(case: Case, eighths: int) -> None:
    threshold = eighths / 8 + 1 / 16
    once = [
        (route, cost - sum(case.prices[job] for job, _ in route))
        for route, cost in routes(case)
        if len({job for job, _ in route}) == len(route)
    ]
    expected = {visit for route, cost in once if cost < threshold for visit in route}
    base = -float(case.prices.sum())
    program = Labels(case.arcs, case.durations, case.slots, case.prices, base, [[]] * case.durations.size)
    found = program.run(threshold, Stopwatch(Limits()), 1_000_000)
    assert found.exact
    least = min(cost for _, cost in once)
    assert found.cost == (pytest.approx(least, abs=1e-9) if least < threshold else np.inf)
    kept = used_below(program, threshold)
    assert set(zip(kept.job.tolist(), kept.start.tolist(), strict=True)) == expected
