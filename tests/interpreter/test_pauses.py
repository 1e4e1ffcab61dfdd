"""Who waits does so between what comes before and what comes next."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "lines",
    [
        ["Open the gate, wait ten minutes, close the shutter"],
        ["Open the gate. Wait ten minutes. Close the shutter"],
        ["Open the gate", "Wait ten minutes", "Close the shutter"],
        ["Open the gate, wait ten minutes and close the shutter"],
    ],
)
def test_a_pause_is_where_it_was_said(lines: list[str]) -> None:
    made = told([*lines, "Mop the hall at 9 am"])
    gate, pause, shutter = made.schedule.skills[:3]
    assert (pause.start, pause.duration) == (gate.end, 600)
    assert shutter.start == pause.end
    assert notes(made) == []


def test_who_waits_does_so_while_it_heats() -> None:
    made = told(["Heat the oven, wait three minutes, weigh the flour"])
    oven, pause, _ = made.schedule.skills
    assert oven.done > pause.start == oven.end


def test_a_pause_is_no_correction() -> None:
    made = told(["Open the gate at 8 am, wait three minutes, close the shutter"])
    assert starts(made) == {"s1": "08:00", "s1.2": "08:00", "s1.3": "08:03"}


def test_who_waits_until_a_time_is_there_then() -> None:
    made = told(["Wait until 8 am, then lock the door"])
    assert [made.schedule.skills[0].done, made.schedule.skills[1].start] == [3600, 3600]


@pytest.mark.parametrize("text", ["Let it run until 10 am, then switch it off", "Mop until 10 am, then rest"])
def test_what_comes_then_waits_until_the_other_is_over(text: str) -> None:
    made = told([text])
    assert starts(made)["s1.2"] == "10:00"


@pytest.mark.parametrize(
    "text",
    [
        "Play jazz until 10 am",
        "Keep the soup warm until 10 am",
        "Mow till 10 am",
        "Bake the cake until 10 am",
    ],
)
def test_what_is_done_until_a_time_goes_on_until_then(text: str) -> None:
    made = told([text, "Call mum at 9 am"])
    first, call = made.schedule.skills
    assert (first.start, first.done, call.start) == (0, 3 * 3600, 2 * 3600)


@pytest.mark.parametrize("text", ["Post the letter until 10 am", "Finish the report until 10 am"])
def test_what_is_done_at_one_moment_is_done_by_then(text: str) -> None:
    assert told([text]).schedule.skills[0].done < 3 * 3600


def test_a_step_behind_it_waits_in_a_list_too() -> None:
    made = told(["Charge the mower", "Mow until 10 am", "Dock"], in_order=True)
    assert made.schedule.skills[2].start == 3 * 3600


def test_what_is_waited_for_is_no_pause() -> None:
    made = told(["Mop the hall", "Weigh the flour"])
    assert made.schedule.task.precedences == ()
