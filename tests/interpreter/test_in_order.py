"""Steps in the order said."""

from collections.abc import Sequence
from itertools import count

import pytest

from fuzzytime.language import Language
from fuzzytime.scheduling import Limits, Schedule, Solver, solve
from fuzzytime.skills import FuzzyTask
from interpreter.telling import notes, order, starts, told

pytestmark = pytest.mark.model

RECIPE = ["chop the onions", "fry them for five minutes", "add the rice", "serve it"]


def test_steps_follow_one_another_where_asked() -> None:
    assert starts(told(RECIPE, in_order=True)) == {"s1": "07:00", "s2": "07:03", "s3": "07:08", "s4": "07:08"}


def test_plain_lines_are_free() -> None:
    assert not told(["chop the onions", "wash the rice", "set the table"]).interpretation.order


def test_what_leaves_its_thing_out_follows_behind_a_comma() -> None:
    assert order(told(["boil the potatoes for 15 minutes, drain, then mash them"])) == ["s1", "s1.2", "s1.3"]
    assert not told(["boil the rice, chop the onion, wash the pan"]).interpretation.order


@pytest.mark.parametrize(
    "text",
    [
        "Take off at 9:30, circle for ten minutes, land",
        "Undock at 9:30, drive to shelf 4, scan it, come back",
        "Melt the butter, add the flour, pour in the milk, whisk",
        "At 9:30 start the pump; stop it after 90 seconds; report",
    ],
)
def test_a_sentence_of_several_steps_is_a_procedure(text: str) -> None:
    made = told([text])
    names = [f"s1.{place}" if place > 1 else "s1" for place in range(1, len(made.schedule.skills) + 1)]
    assert order(made) == names


def test_chores_of_one_sentence_wait_for_no_other() -> None:
    made = told(["call mum at six pm, wash the car, buy milk"])
    assert order(made)[-1] == "s1"


def test_a_numbered_list_says_that_its_order_holds() -> None:
    lines = [f"{number}. {line}" for number, line in enumerate(RECIPE, 1)]
    assert order(told([*lines, "water the plants"]))[:4] == ["s1", "s2", "s3", "s4"]


@pytest.mark.parametrize("mark", ["2.", "2)", "(2)", "Step 2:", "step two -", "- 2."])
def test_marks_of_lists_are_no_part_of_what_is_to_be_done(mark: str) -> None:
    reading = Language.shipped().read(f"{mark} slice the bread")
    assert [one.operation.name for one in reading.instructions if one.operation] == ["slice the bread"]
    assert (reading.step, reading.remarks) == (2, ())


@pytest.mark.parametrize("text", ["Turn to page 3. Read it", "call at 6. Then rest", "slice it in 2) three"])
def test_numbers_inside_a_text_are_no_marks(text: str) -> None:
    assert Language.shipped().read(text).step is None


def test_a_list_may_stand_in_one_line() -> None:
    made = told(["1. chop the onions 2. fry them 3. serve them"])
    assert [one.skill.name for one in made.skills] == [
        "chop the onions",
        "fry the onions",
        "serve the onions",
    ]
    assert len(made.interpretation.order) == 2


def test_a_list_that_counts_from_the_beginning_is_a_new_one() -> None:
    made = told(["1. chop the onions", "2. fry them", "1. sweep the yard", "2. oil the gate"])
    assert [(entry.first, entry.second) for entry in made.interpretation.order] == [(0, 1), (2, 3)]


def test_a_step_with_a_time_keeps_it_and_the_next_follows() -> None:
    made = told(["fetch the crate", "charge the robot at 9 am", "sweep the hall"], in_order=True)
    assert starts(made)["s2"] == "09:00"
    assert starts(made)["s3"] > "09:00"


def test_times_that_are_said_say_their_order() -> None:
    made = told(["call mum at 9 am", "write the letter", "call dad at 8 am"], in_order=True)
    assert (starts(made)["s1"], starts(made)["s3"]) == ("09:00", "08:00")
    assert any("order is not kept" in note for note in notes(made))


def test_what_waits_for_nobody_does_not_hold_up_the_next_step() -> None:
    made = told(["preheat the oven", "sweep the floor", "bake the bread"], in_order=True)
    assert starts(made)["s2"] == "07:00"
    assert starts(made)["s3"] >= "07:12"


def test_words_for_another_order_count() -> None:
    made = told(
        ["boil the potatoes for 20 minutes", "meanwhile chop the parsley", "drain the potatoes"],
        in_order=True,
    )
    assert starts(made)["s2"] < "07:20"
    assert starts(made)["s3"] == "07:20"


def test_a_step_before_a_later_one_stays_where_it_stands() -> None:
    lines = [
        "roast the lamb for an hour",
        "let the lamb rest for ten minutes before you carve it",
        "carve the lamb",
    ]
    assert starts(told(lines, in_order=True)) == {"s1": "07:00", "s2": "08:00", "s3": "08:10"}


def test_now_says_no_more_than_then_in_a_list() -> None:
    made = told(["1. boil the eggs for ten minutes", "2. now peel them"])
    assert starts(made)["s2"] == "07:10"


def test_what_follows_a_step_that_cannot_be_done_goes_on_without_it() -> None:
    made = told(["chop the onions", "fry them when the pan is hot", "set the table"], in_order=True)
    assert starts(made) == {"s1": "07:00", "s3": "07:03"}
    assert "fry the onions waits: what was said after it goes on without it" in notes(made)


def test_what_words_tie_to_a_step_that_cannot_be_done_falls_with_it() -> None:
    made = told(["fry the fish when the pan is hot", "then serve it", "set the table"], in_order=True)
    assert list(starts(made)) == ["s3"]


def test_repetitions_hold_up_nothing() -> None:
    made = told(["simmer the soup for an hour", "stir it every ten minutes", "serve the soup"], in_order=True)
    assert "08:00" <= starts(made)["s3"] < "08:05"


def test_a_recipe_is_searched_until_nothing_is_better_and_no_longer() -> None:
    lines = ["preheat the oven", "mix flour, eggs and sugar for five minutes", "meanwhile, grease the tin"]
    lines += ["bake the cake for 40 minutes", "watch it for 20 minutes"]
    asked = count()
    limits = Limits(seconds=1e6, clock=lambda: float(next(asked)) * 1e3)
    made = told(lines, in_order=True, limits=limits)
    assert made.schedule.satisfaction == pytest.approx(1.0)
    assert next(asked) < 500


def test_what_is_planned_again_without_a_step_shares_the_time(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[float] = []

    def noted(
        task: FuzzyTask, *, solver: Solver | None, threshold: float, limits: Limits, hints: Sequence[float]
    ) -> Schedule:
        given.append(limits.seconds)
        return solve(task, solver=solver, threshold=threshold, limits=limits, hints=hints)

    monkeypatch.setattr("fuzzytime.interpreter.planner.solve", noted)
    asked = count()
    limits = Limits(seconds=1e6, clock=lambda: float(next(asked)))
    lines = ["charge the robot for 40 minutes at half past seven pm", "bring the crate to the truck"]
    told([*lines, "send a report at 6 pm"], in_order=True, limits=limits)
    assert len(given) > 1
    assert all(seconds < limits.seconds for seconds in given)


def test_a_search_that_runs_out_leaves_time_to_plan_without_a_step(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[float] = []
    passed = 0.0

    def slow(
        task: FuzzyTask, *, solver: Solver | None, threshold: float, limits: Limits, hints: Sequence[float]
    ) -> Schedule:
        nonlocal passed
        given.append(limits.seconds)
        found = solve(task, solver=solver, threshold=threshold, hints=hints)
        passed += limits.seconds
        return found

    monkeypatch.setattr("fuzzytime.interpreter.planner.solve", slow)
    lines = ["charge the robot for 40 minutes at half past seven pm", "bring the crate to the truck"]
    told([*lines, "send a report at 6 pm"], in_order=True, limits=Limits(seconds=100, clock=lambda: passed))
    assert given == pytest.approx([60, 40])
    given.clear()
    told(["call mum", "send a report at 6 pm"], limits=Limits(seconds=100, clock=lambda: passed))
    assert given == [100]


def test_what_is_done_with_it_follows_what_was_asked_of_it() -> None:
    lines = ["wipe the table", "assemble the lasagne at 9 am", "bake it for 35 minutes", "it has to rest"]
    at = starts(told(lines))
    assert at["s1"] == "07:00"
    assert at["s2"] < at["s3"] < at["s4"]


def test_its_own_time_says_when_something_is_done_with_it() -> None:
    at = starts(told(["serve the soup at noon", "heat it at 11 am", "before that, salt it"]))
    assert at["s3"] < at["s2"] == "11:00"


@pytest.mark.parametrize(
    "text",
    [
        "open the door, let the cat in, close it",
        "start the pump, log the pressure, stop it",
        "put the pan on the hob, chop an onion and take it off the heat",
    ],
)
def test_what_is_said_between_what_is_done_and_undone_is_between(text: str) -> None:
    assert order(told([text])) == ["s1", "s1.2", "s1.3"]


def test_what_has_a_time_of_its_own_is_between_too() -> None:
    at = starts(told(["turn on the oven, call mum at noon, turn it off"]))
    assert at["s1"] < at["s1.2"] == "12:00" < at["s1.3"]


def test_a_distance_counts_from_what_is_undone() -> None:
    at = starts(told(["put the cake in, whip the cream and take it out after 30 minutes"]))
    assert at == {"s1": "07:00", "s1.2": "07:01", "s1.3": "07:31"}


@pytest.mark.parametrize("heading", ["Tomorrow:", "Saturday morning:"])
def test_steps_below_a_day_are_done_in_order(heading: str) -> None:
    at = starts(told([heading, "1. wash the car", "2. wax it", "3. dry the towels"]))
    assert at["s2"] < at["s3"] < at["s4"]
