"""Why each skill starts when it does, in words."""

from dataclasses import replace
from datetime import datetime

import pytest

from fuzzytime.interpreter import DirectWish, Interpreter, Plan, Request, plan
from fuzzytime.satisfaction import ALWAYS, NEVER, Either, Rectangle, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.scheduling import Limits, Status
from fuzzytime.skills import Busy
from fuzzytime_cli.formats.reasons import clash_sentence, explaining, loss_lines, why_sentences

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone
WISH = Triangle(60, 180, 300)


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


def wish(name: str, function: SatisfactionFunction, **given: object) -> DirectWish:
    return replace(DirectWish(given=NOW, name=name, satisfaction=function, hands_on=60.0), **given)  # type: ignore[arg-type]


def planned(interpreter: Interpreter, *wishes: DirectWish, busy: tuple[Busy, ...] = ()) -> Plan:
    return plan(Request(now=NOW, wishes=wishes, busy=busy), interpreter)


def test_a_line_names_who_wants_the_same_minutes(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("toast the bread", WISH, priority=3.0), wish("flip the pancakes", WISH))
    lines = dict(loss_lines(made))
    assert lines[1].startswith("flip the pancakes: lost 0.")
    assert lines[1].endswith("to toast the bread, which wants the same minutes")


def test_out_of_time_it_is_said_that_nobody_looked(interpreter: Interpreter) -> None:
    made = planned(interpreter, *(wish(f"flip {number}", WISH) for number in range(4)))
    *lines, last = loss_lines(made, seconds=0.0)
    assert all(" to " not in line for _, line in lines)
    assert last == (
        None,
        f"to whom {len(lines)} of these lost was not looked for: time was over (explain tells)",
    )


def test_explaining_takes_a_share_of_the_time() -> None:
    assert [explaining(Limits(seconds=seconds)) for seconds in (0.5, 5.0, 60.0)] == [0.1, 1.0, 1.0]


def test_two_skills_of_one_name_are_told_apart(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("flip", WISH, priority=3.0), wish("flip", WISH))
    # Whoever shows the line says of which it is: "s2 flip: lost …".
    assert dict(loss_lines(made))[1].startswith("flip: lost")
    assert dict(loss_lines(made))[1].endswith("to flip (s1), which wants the same minutes")


def test_who_is_fully_satisfied_needs_no_line(interpreter: Interpreter) -> None:
    assert loss_lines(planned(interpreter, wish("wash", ALWAYS), wish("flip", WISH))) == []


def test_a_line_names_the_appointment(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("flip", WISH), busy=(Busy(120, 270, "call"),))
    assert loss_lines(made) == [
        (0, "flip: 0.25 is the most it can have: its best time is taken by call (09:02:00 to 09:04:30)")
    ]


def test_a_line_says_that_the_best_time_is_over(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("flip", WISH.shifted(-240)))
    assert loss_lines(made) == [(0, "flip: 0.50 is the most it can have: its best time is over")]


def test_a_line_names_what_must_come_first(interpreter: Interpreter) -> None:
    boil = wish("boil", Rectangle(240, 300), identifier="b")
    made = planned(interpreter, boil, wish("peel", Trapezoid(0, 60, 120, 900), after=("b",)))
    assert dict(loss_lines(made))[1].endswith("to boil, which must come first")


def test_a_rejected_skill_says_what_it_could_have_had(interpreter: Interpreter) -> None:
    spike = Rectangle(180, 180)
    made = planned(interpreter, wish("toast", spike, priority=2.0), wish("flip", spike), wish("fry", NEVER))
    lines = dict(loss_lines(made))
    assert lines[1] == (
        "flip: rejected: alone it could have 1.00, which it lost to toast, which wants the same minutes"
    )
    assert lines[2] == "fry: rejected: its satisfaction is 0 at every time"


def test_sentences_say_what_was_asked_who_took_it_and_what_a_minute_costs(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("toast", WISH, priority=3.0), wish("flip", WISH))
    asked, got, instead, minutes = why_sentences(made, 1)
    assert asked == (
        "Its satisfaction was given as a curve: alone it would be fully satisfied by a start at 09:03."
    )
    assert "to toast, which wants the same minutes" in got
    assert instead == (
        "Started at 09:03 it would have 1.00, but toast would fall from 1.00 to 0.50; "
        "toast came with a higher priority; the whole would be no better."
    )
    assert minutes.startswith("A minute earlier it would have ")
    assert "a minute later it would have " in minutes
    assert minutes.endswith("No schedule satisfies better: proved.")


def test_sentences_say_that_more_time_may_find_better_where_nothing_is_proved(
    interpreter: Interpreter,
) -> None:
    made = planned(interpreter, wish("toast", WISH, priority=3.0), wish("flip", WISH))
    bounded = replace(made.schedule.certificate, status=Status.BOUNDED, gap=0.125)
    made = replace(made, schedule=replace(made.schedule, certificate=bounded))
    assert why_sentences(made, 1)[-1].endswith(
        "The average is within 12.50% of the best possible: more time (--time-limit) may find better."
    )


def test_sentences_say_what_the_whole_would_lose(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("toast", Triangle(120, 180, 240)), wish("flip", WISH))
    instead = why_sentences(made, 1)[2]
    assert instead.startswith("Started at 09:03 it would have 1.00, but toast would fall from 1.00 to ")
    assert " and the whole from 0.5 to 0." in instead


def test_the_whole_is_not_told_apart_from_a_single_skill(interpreter: Interpreter) -> None:
    assert why_sentences(planned(interpreter, wish("flip", WISH)), 0)[-1] == (
        "A minute earlier it would have 0.50; a minute later it would have 0.50. "
        "No schedule satisfies better: proved."
    )


def test_a_minute_for_which_nobody_is_free_is_said_to_be_taken(interpreter: Interpreter) -> None:
    made = planned(interpreter, wish("flip", WISH), busy=(Busy(240, 600, "call"),))
    assert "a minute later is not free" in why_sentences(made, 0)[-1]


def clash_of(interpreter: Interpreter, *wishes: DirectWish) -> str:
    return clash_sentence(plan(Request(now=NOW, wishes=wishes), interpreter, threshold=0))


def test_a_clash_is_named(interpreter: Interpreter) -> None:
    then, room = Rectangle(180, 180), Rectangle(0, 90)
    assert clash_of(interpreter, wish("stir", ALWAYS), wish("toast", then), wish("flip", then)) == (
        "no schedule satisfies everyone: toast and flip exclude each other"
    )
    assert clash_of(interpreter, wish("toast", then), wish("fry", NEVER)).endswith(
        "everyone: fry cannot be satisfied at all"
    )
    assert clash_of(interpreter, wish("stir", room), wish("fry", room), wish("mix", room)).endswith(
        "stir, fry and mix cannot all be had, though any 2 of them can"
    )


def test_each_of_several_times_is_named(interpreter: Interpreter) -> None:
    either = Either([Rectangle(60, 120), Rectangle(600, 660)])
    made = planned(interpreter, wish("flip the pancakes", either))
    (asked, *_) = why_sentences(made, 0)
    assert "by any start from 09:01 to 09:02, or by any start from 09:10 to 09:11" in asked
