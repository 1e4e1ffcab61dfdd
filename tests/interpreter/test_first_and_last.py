"""What is to be done first of all, or last, lies so among all that is asked for."""

import pytest

from interpreter.telling import notes, order, told


@pytest.mark.parametrize(
    "asked", ["polish the glasses last", "polish the glasses last, please", "leave the kitchen till last"]
)
def test_what_is_last_comes_after_all_else(asked: str) -> None:
    made = told([asked, "mop the floor", "call the bakery at noon", "sort the cutlery"])
    assert order(made)[-1] == "s1"
    assert notes(made) == []


@pytest.mark.parametrize("asked", ["sort the cutlery first", "Before anything else, sort the cutlery"])
def test_what_is_first_comes_before_all_else(asked: str) -> None:
    made = told(["mop the floor soon", "polish the glasses", asked])
    assert order(made)[0] == "s3"


def test_only_what_was_named_is_first() -> None:
    made = told(["wash the glasses first, then the plates", "mop the floor"])
    assert order(made)[0] == "s1"
    assert [one.operation.order for one in made.skills if one.operation is not None] == ["first", None, None]


def test_times_say_their_order_themselves() -> None:
    made = told(["call the bakery last at ten am", "call the office at noon"])
    assert order(made) == ["s1", "s2"]


def test_what_happens_and_what_repeats_is_no_part_of_the_order() -> None:
    made = told(["the film is at 9 pm", "feed the cat every two hours until six pm", "iron the shirts last"])
    assert order(made)[0] == "s3"


@pytest.mark.parametrize("line", ["make it last", "keep the mugs out till last", "call at last"])
def test_other_words_of_the_same_form_say_no_order(line: str) -> None:
    assert [one.operation.order for one in told([line]).skills if one.operation is not None] == [None]
