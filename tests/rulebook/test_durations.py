"""How long operations take, where nobody says it."""

import pytest

from fuzzytime.english import singular_forms
from fuzzytime.rulebook import Rulebook
from fuzzytime.times import MINUTE

RULEBOOK = Rulebook.shipped()


def test_the_cook_is_free_while_eggs_boil() -> None:
    row = RULEBOOK.duration_of("boil", "the eggs")
    assert row.hands_on < row.elapsed
    assert row.assumed
    assert row.known


@pytest.mark.parametrize(
    ("verb", "thing", "like"),
    [
        ("boil", "two large eggs", "egg"),
        ("boil", "Eggs", "egg"),
        ("cook", "the tomato soup", "soup"),
        ("wash", "the dirty dishes", "dish"),
        ("empty", "the washing machine", "washing machine"),
        ("make", "a cup of coffee", "coffee"),
        ("clean", "the lid of the pan", "pan"),
        ("clean", "the pan in the kitchen", "pan"),
    ],
)
def test_an_object_s_last_words_choose_the_row(verb: str, thing: str, like: str | None) -> None:
    assert RULEBOOK.duration_of(verb, thing) == RULEBOOK.tables.durations.rows[verb, like]


def test_a_phrasal_verb_has_its_own_row() -> None:
    assert RULEBOOK.duration_of("turn on", "the light").hands_on == 15
    assert RULEBOOK.duration_of("turn_on", "the light").hands_on == 15
    assert RULEBOOK.duration_of("boil over", None) == RULEBOOK.duration_of("boil", None)


def test_an_unknown_operation_takes_five_minutes_and_says_that_it_is_unknown() -> None:
    row = RULEBOOK.duration_of("defenestrate", "the printer")
    assert (row.hands_on, row.elapsed) == (5 * MINUTE, 5 * MINUTE)
    assert not row.known
    assert row.source.startswith("rules/durations.yaml:")
    assert RULEBOOK.duration_of(None, None) == row


@pytest.mark.parametrize(
    ("verb", "thing", "minutes", "begun"),
    [
        ("put", "the loaves", 40, True),
        ("put", "the loaves", 2, False),
        ("clean", "the kitchen", 240, False),
        ("defenestrate", "the printer", 240, False),
    ],
)
def test_what_is_begun_by_a_touch_and_told_to_take_long_goes_on_by_itself(
    verb: str, thing: str, minutes: int, *, begun: bool
) -> None:
    row = RULEBOOK.duration_of(verb, thing)
    assert (RULEBOOK.left_alone(row, minutes * MINUTE) is not None) is begun


@pytest.mark.parametrize(
    ("verb", "minutes", "hands_on"),
    [("put", 60, 1.0), ("turn on", 60, 0.25), ("put", 2, None), ("turn", 60, None), ("stir", 60, None)],
)
def test_what_is_put_somewhere_for_a_time_is_left_alone(
    verb: str, minutes: int, hands_on: float | None
) -> None:
    row = RULEBOOK.duration_of(verb, "the lamp")
    left = RULEBOOK.left_alone(row, minutes * MINUTE, verb)
    assert left == (None if hands_on is None else hands_on * MINUTE)


def test_all_rows_are_plausible() -> None:
    rows = RULEBOOK.tables.durations.rows
    assert len(rows) > 400
    assert all(0 <= row.hands_on <= row.elapsed for row in rows.values())
    assert all(row.elapsed > 0 for row in rows.values())


@pytest.mark.parametrize(
    ("plural", "singular"),
    [("knives", "knife"), ("loaves", "loaf"), ("boxes", "box"), ("tomatoes", "tomato"), ("plates", "plate")],
)
def test_plurals_find_their_singular(plural: str, singular: str) -> None:
    assert singular in singular_forms(plural)
