"""Lines that lean on each other are steps in order; chores, of which one or two do, are none."""

from collections.abc import Sequence

import pytest

from interpreter.telling import listed, order, starts, told

pytestmark = pytest.mark.model

SOUP = ["Rinse the lentils", "Put them in a pan with the stock", "Meanwhile dice two carrots"]
SOUP += ["Add them to the pan", "Simmer for 25 minutes", "Toast the cumin for a minute", "Grind it", "Serve"]

DRESSER = ["Unpack the parts", "Lay the sides on the carpet", "Screw the runners onto the sides"]
DRESSER += [
    "Fit the dowels into the base",
    "Attach the sides to it",
    "Nail it down",
    "Then push the drawers in",
]

PROTOCOL = ["Thaw the samples for 20 minutes", "Label twelve tubes in the meantime", "Vortex the samples"]
PROTOCOL += ["Incubate at 56 degrees for an hour", "Spin them down", "Load the columns", "Elute"]

DIGEST = ["Thaw the enzyme on ice for 5 minutes", "Add it to the tubes and shake for 2 minutes"]
DIGEST += [
    "Heat the block to 37 degrees",
    "Put the tubes in the block for 30 minutes",
    "Spin the tubes for a minute",
]

CURD = [
    "Warm the Milk: Pour it into the pan and heat for 10 minutes",
    "Set the Curd: Add the rennet and leave for an hour",
]
CURD += ["Cut the Curd: Slice it into cubes"]


@pytest.mark.parametrize("lines", [SOUP, DRESSER, PROTOCOL])
def test_lines_that_lean_on_those_above_are_steps(lines: Sequence[str]) -> None:
    made = listed(lines)
    assert order(made) == [f"s{number}" for number in range(1, len(lines) + 1)]
    assert len(made.interpretation.order) >= len(lines) - 2


@pytest.mark.parametrize(
    "lines",
    [
        ["Wash the car", "Dry it", "Call mum", "Buy stamps", "Feed the dog", "Then walk it"],
        ["Put the bins out", "Mow the lawn", "Run the dishwasher", "Empty it", "Iron the shirts", "Clean up"],
        ["Thaw the gels first thing", "Load them by ten", "Lunch at noon", "Run them from one", "Image them"],
    ],
)
def test_a_list_of_chores_or_of_times_is_none(lines: Sequence[str]) -> None:
    assert len(listed(lines).interpretation.order) < len(lines) - 2


def test_lines_that_each_say_how_long_are_steps() -> None:
    made = listed(["bike 10 min", "plank 3 x 1 min with 30 s rest", "cool down ten", "stretch 5"])
    assert starts(made) == {"s1": "07:00", "s2": "07:10", "s3": "07:14", "s4": "07:24"}


def test_what_goes_on_meanwhile_is_waited_for_by_what_is_done_with_it_or_comes_last() -> None:
    lines = ["Brown the mince for five minutes", "Meanwhile boil the rice for 30 minutes", "Add the stock"]
    lines += ["Simmer for 10 minutes", "Stir it", "Serve"]
    made = starts(listed(lines))
    assert made["s2"] == "07:05"
    assert made["s3"] < "07:10"
    assert made["s6"] == "07:35"


def test_what_was_to_go_on_beside_what_keeps_the_hands_is_never_lost() -> None:
    made = told(
        ["Fry the onions for 8 minutes", "Meanwhile boil the potatoes for 15 minutes", "Wash the pan"]
    )
    assert starts(made) == {"s1": "07:00", "s2": "07:08", "s3": "07:11"}
    busy = ["Fry the onions at noon for 8 minutes", "Meanwhile boil the eggs"]
    assert "s2" in starts(told([*busy, "I have a meeting from 12:08 to 12:30"]))


def test_lines_of_which_half_say_how_long_are_steps_where_half_go_on_with_a_thing_above() -> None:
    made = starts(listed(DIGEST))
    assert (made["s2"], made["s3"], made["s4"], made["s5"]) == ("07:05", "07:07", "07:12", "07:42")


def test_steps_with_titles_are_done_in_turn() -> None:
    made = starts(listed(CURD))
    assert (made["s1"], made["s2.2"], made["s3"]) == ("07:00", "07:10", "08:10")
