"""Whatever comes in, and however commands behave, a run ends, and keeps what every run must keep."""

import math
import os

from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.interpreter import DirectWish
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.scheduling import LocalSearch
from fuzzytime_cli.live.events import Done, End, Failed, Finished
from fuzzytime_cli.live.messages import Word
from live.story import SIX, Json, NappingClock, Story, told

RUNS = int(os.environ.get("FUZZYTIME_RUNS", "5"))
"""How many runs each test tries: few in the suite, more when one looks for faults."""

SECONDS = st.integers(0, 900).map(float)


@st.composite
def wishes(draw: st.DrawFn) -> list[DirectWish]:
    count = draw(st.integers(1, 5))
    made = []
    for number in range(count):
        corners = sorted(draw(st.lists(SECONDS, min_size=4, max_size=4)))
        hands_on = draw(st.integers(0, 200))
        after = (
            draw(st.lists(st.sampled_from([f"w{i}" for i in range(number)]), max_size=1)) if number else []
        )
        made.append(
            DirectWish(
                name=f"do {number}",
                satisfaction=Trapezoid(*corners),
                given=SIX,
                identifier=f"w{number}",
                hands_on=float(hands_on),
                elapsed=float(hands_on + draw(st.integers(0, 100))),
                agent=None,
                after=tuple(after),
            )
        )
    return made


@st.composite
def words(draw: st.DrawFn) -> list[Json]:
    lines = []
    for _ in range(draw(st.integers(0, 4))):
        word = draw(st.sampled_from(list(Word)))
        lines.append({word.value: f"w{draw(st.integers(0, 5))}", "at_s": draw(SECONDS)})
    return lines


TAKES = st.dictionaries(
    st.sampled_from([f"w{i}" for i in range(5)]),
    st.one_of(SECONDS, st.tuples(SECONDS, st.just("it broke"))),
)


def keeps_its_promises(story: Story, wished: list[DirectWish]) -> None:
    """Every wish comes to exactly one end; nothing starts before what it waits for is done."""
    finished = story.one(Finished)
    ends = [*finished.done, *finished.failed, *finished.dropped, *finished.rejected]
    assert sorted(ends) == sorted(wish.identifier for wish in wished)
    assert not finished.unfinished
    done = {one.id: one.at for one in story.all(Done)}
    for wish in wished:
        start = story.starts.get(wish.identifier)
        if start is not None:
            assert all(done.get(name, math.inf) <= start for name in wish.after)
            # A second's delay is none.
            assert max(wish.satisfaction([start - 1, start])) > 0
    for identifier in story.starts:
        outcomes = [*story.of(End, identifier), *story.of(Failed, identifier)]
        assert outcomes or identifier in finished.dropped


@settings(max_examples=RUNS)
@given(wishes(), words(), st.integers(1, 2))
def test_a_run_in_time_ends_with_a_fate_for_every_wish(
    wished: list[DirectWish], lines: list[Json], agents: int
) -> None:
    keeps_its_promises(told(wished, lines, agents=agents, solver=LocalSearch()), wished)


@settings(max_examples=RUNS)
@given(wishes(), words(), TAKES, st.integers(1, 2))
def test_a_run_of_commands_that_do_as_they_like_does_too(
    wished: list[DirectWish], lines: list[Json], takes: dict[str, float | tuple[float, str]], agents: int
) -> None:
    story = told(
        wished,
        lines,
        agents=agents,
        takes=takes,
        limit=lambda planned: 3 * planned + 60,
        solver=LocalSearch(),
    )
    keeps_its_promises(story, wished)


@settings(max_examples=RUNS)
@given(wishes(), st.lists(st.tuples(SECONDS, SECONDS), max_size=1))
def test_a_run_on_a_machine_that_sleeps_does_too(
    wished: list[DirectWish], naps: list[tuple[float, float]]
) -> None:
    for begin, length in naps:
        clock = NappingClock(asleep=(begin, begin + length))
        keeps_its_promises(told(wished, clock=clock, solver=LocalSearch()), wished)
