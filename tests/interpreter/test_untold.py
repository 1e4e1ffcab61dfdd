"""What nobody tells: what waits for it is withheld, and no other signal is taken for it."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "line",
    [
        "if error rate > 2% for five minutes, roll back",
        "roll back if the error rate >2%",
        "when the battery of the truck is below 20 percent, call Tom",
        "if level = 3, call Tom",
        "call the doctor if bed 3's sats drop below 90",
        "call Tom when the oven door is hot",
    ],
)
def test_a_condition_that_nothing_tells_is_waited_for(line: str) -> None:
    assert not starts(told([line]))


def test_a_thing_named_beside_another_is_not_what_is_read() -> None:
    assert any("bed 3's sats" in note for note in notes(told(["call Ann if bed 3's sats drop below 90"])))
    assert any(
        "of bed_temp" in note for note in notes(told(["call Ann if the bed temperature drops below 40"]))
    )


def test_whose_thing_it_is_that_something_is_done_with_counts() -> None:
    swap = "swap the battery of Kestrel"
    assert "s2" not in starts(told([swap, "when Beta's battery drops below 20 percent, send it to the dock"]))
    assert "s2" in starts(told(["paint Tom's door", "once Tom's door is dry, sand it"]))


def test_what_waits_for_what_is_not_planned_is_withheld() -> None:
    lines = ["vacuum takes roughly 40 min", "don't restart the server until vacuum is done", "wash up"]
    made = told([*lines, "ring Tom five minutes before the vacuum", "ring Ann before the vacuum"])
    assert set(starts(made)) == {"s3", "s5"}
    assert "refers to 'the vacuum', which is not planned: taken as not held up by it" in notes(made)


def test_what_is_done_already_is_waited_for_no_longer() -> None:
    assert "s2" in starts(told(["I have fed the dog", "after feeding the dog, walk him"]))


@pytest.mark.parametrize("here", ["once the parts are here", "when the parts are there"])
def test_what_was_said_to_come_is_here_then(here: str) -> None:
    made = told(["the parts arrive at eleven", f"{here}, ring Mr Doyle"])
    assert starts(made)["s2"] == "11:00"


def test_a_condition_said_twice_beside_a_time_withholds_what_waits_for_both() -> None:
    said = "when the pan is very hot add some oil, at five, I. when the pan is very hot add some oil, at"
    assert not starts(told([said]))
