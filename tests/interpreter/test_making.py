"""From sentences to skills: what the words say of start and finish, and repetitions."""

from datetime import datetime
from itertools import pairwise

import pytest

from fuzzytime.interpreter import Interpreted, Interpreter, Request, SpokenWish
from fuzzytime.times import HOUR, MINUTE
from interpreter.telling import told

NOW = datetime(2026, 3, 4, 7)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


def skills(interpreter: Interpreter, text: str, elapsed: float | None = None) -> tuple[Interpreted, ...]:
    wish = SpokenWish(text=text, given=NOW, elapsed=elapsed)
    return interpreter.interpret(Request(now=NOW, wishes=(wish,), horizon=24 * HOUR)).skills


@pytest.mark.parametrize(
    ("text", "latest"),
    [
        ("Cook the rice by 6 pm", 11 * HOUR - 20 * MINUTE),
        ("Have the rice ready by 6 pm", 11 * HOUR - 20 * MINUTE),
        ("Start cooking the rice by 6 pm", 11 * HOUR),
        ("Begin to cook the rice by 6 pm", 11 * HOUR),
        ("Cook the rice before 6 pm", 11 * HOUR),
    ],
)
def test_by_a_time_is_done_by_then_unless_the_words_say_start(
    interpreter: Interpreter, text: str, latest: float
) -> None:
    (skill,) = skills(interpreter, text, elapsed=20 * MINUTE)
    assert skill.skill.satisfaction.best.high == latest
    assert all(part.reference.value == "start" for part in skill.requirements) == ("ready" not in text)


def test_occurrences_of_a_dense_series_do_not_reach_into_each_other(interpreter: Interpreter) -> None:
    functions = [made.skill.satisfaction for made in skills(interpreter, "Stir the soup every 20 minutes")]
    supports = [function.support for function in functions]
    assert len(supports) > 50
    assert all(one.high < other.low for one, other in pairwise(supports))


def test_what_happens_by_itself_needs_nobody_s_hands(interpreter: Interpreter) -> None:
    (arriving,) = skills(interpreter, "the guests arrive at six")
    assert arriving.skill.name == "the guests arrive"
    assert (arriving.skill.duration, arriving.skill.time_until_done) == (0, 0)


@pytest.mark.parametrize(
    ("text", "start"),
    [
        ("Put the bread in the oven at eight, ten minutes later set the table", HOUR + 10 * MINUTE),
        (
            "Ten minutes before you serve the soup, warm the plates. Serve the soup at noon",
            5 * HOUR - 10 * MINUTE,
        ),
    ],
)
def test_an_exact_distance_names_a_start(interpreter: Interpreter, text: str, start: float) -> None:
    tied = next(made.skill for made in skills(interpreter, text) if made.requirements[0].anchor is not None)
    assert tied.preferred == start


def test_a_distance_from_what_has_no_time_is_kept_wherever_that_is(interpreter: Interpreter) -> None:
    mixing, kneading = skills(interpreter, "Mix the dough. Ten minutes later, knead it")
    assert mixing.skill.preferred is kneading.skill.preferred is None
    times = told(["Chop the onions", "Mix the dough. Ten minutes later, knead it"]).schedule.start_times
    assert times[2] - times[1] == mixing.skill.time_until_done + 10 * MINUTE


def test_what_nothing_tells_of_has_not_happened_yet(interpreter: Interpreter) -> None:
    (before,) = skills(interpreter, "Let the loaves cool for 20 minutes before the picnic")
    assert before.skill.satisfaction(0.0) == 1.0
    assert before.reason == ""
    (until,) = skills(interpreter, "Wait in the hall until Maria has signed")
    assert until.skill.satisfaction(0.0) == 1.0
    (after,) = skills(interpreter, "Wash the blanket after the picnic")
    assert after.reason


def test_a_state_is_waited_for_by_readings_or_else_by_what_brings_it_about(interpreter: Interpreter) -> None:
    text = "Warm up the printer. As soon as it is warm, print the bracket"
    request = Request(now=NOW, wishes=(SpokenWish(text=text, given=NOW),), horizon=HOUR)
    made = interpreter.interpret(request)
    assert [(order.first, order.second) for order in made.precedences] == [(0, 1)]
    assert made.skills[1].reason == ""


def test_a_length_told_afterwards_is_that_of_the_instruction(interpreter: Interpreter) -> None:
    text = "Put the loaves in the oven. They need 40 minutes. Take them out when they are done"
    loaves, out = skills(interpreter, text)
    assert (loaves.skill.duration, loaves.skill.elapsed) == (MINUTE, 40 * MINUTE)
    assert not loaves.duration.assumed
    assert out.follows == (loaves.identifier,)
    (machine,) = skills(interpreter, "The dryer starts at nine. It takes two hours")
    assert (machine.skill.duration, machine.skill.elapsed) == (0, 2 * HOUR)
    (cleaning,) = skills(interpreter, "Clean the kitchen. It takes two hours")
    assert (cleaning.skill.duration, cleaning.skill.elapsed) == (2 * HOUR, 2 * HOUR)
    (given,) = skills(interpreter, "Clean the kitchen. It takes two hours", elapsed=HOUR)
    assert given.skill.elapsed == HOUR


@pytest.mark.parametrize("text", ["I have a dentist appointment from 10 to 11", "The fair is from 10 to 11"])
def test_what_happens_has_its_start_and_its_length(interpreter: Interpreter, text: str) -> None:
    (made,) = skills(interpreter, text)
    assert (made.skill.preferred, made.skill.duration, made.skill.elapsed) == (3 * HOUR, 0, HOUR)


def test_what_is_wished_within_a_time_of_another_follows_it_no_later(interpreter: Interpreter) -> None:
    text = "Call the pharmacy at nine. Pick up the pills within an hour of calling"
    made = interpreter.interpret(Request(now=NOW, wishes=(SpokenWish(text=text, given=NOW),)))
    (order,) = made.precedences
    assert (order.minimum_lag, order.maximum_lag) == (0, HOUR)


@pytest.mark.parametrize(
    ("text", "times"),
    [
        ("Rub cream on her feet in the evening for three days", 3),
        ("Give him antibiotics in the morning and at night for two days", 4),
        ("Take the antibiotics three times a day with food for two days", 6),
        ("Give him one spoonful at night for three nights", 3),
        ("Call mum every day for three days", 3),
        ("Water the pots for three mornings", 3),
    ],
)
def test_what_is_done_for_so_many_days_is_done_as_often_on_each_and_no_longer(text: str, times: int) -> None:
    made = told([text], now=datetime(2026, 3, 4, 9))  # noqa: DTZ001
    assert len(made.skills) == times
    assert all(one.skill.duration < HOUR for one in made.skills)


def test_what_is_done_beside_meals_and_at_another_time_of_the_day_is_done_at_both() -> None:
    made = told(["Check her blood pressure before breakfast and at bedtime"], now=datetime(2026, 3, 4, 5))  # noqa: DTZ001
    first, second = (made.instant(time).hour for time in made.schedule.start_times)
    assert (first < 7, second) == (True, 22)
    assert list(made.schedule.satisfactions) == [1, 1]
