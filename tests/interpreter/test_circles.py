"""Orders that close no circle, however many there are."""

from fuzzytime.interpreter.binding.circles import Before


def test_what_would_close_a_circle_is_not_added() -> None:
    before = Before()
    assert before.add(0, 1)
    assert before.add(1, 2)
    assert not before.add(2, 0)
    assert not before.add(3, 3)
    assert before.says(1, 2)
    assert not before.says(2, 0)


def test_a_long_row_asks_each_entry_once() -> None:
    before = Before()
    assert all(before.add(place, place + 1) for place in range(20_000))
    assert not before.add(20_000, 0)
