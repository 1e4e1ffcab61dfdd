"""The lanes of a plan on a terminal."""

import pytest

from fuzzytime.satisfaction import NEVER, Bell, Sampled, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime_cli.formats.timeline import SHADES, Window, shades

DAYS = Window(0.0, 5 * 86400.0, 72)


@pytest.mark.parametrize(
    "narrow",
    [
        Triangle(100_030, 100_060, 100_090),
        Trapezoid(-5, 0, 0, 5),
        Bell(centre=100_060, width=10, slope=2),
        Sampled([431_990, 431_995, 431_999], [0, 1, 0]),
    ],
)
def test_a_wish_narrower_than_a_column_is_seen(narrow: SatisfactionFunction) -> None:
    row = shades(narrow, DAYS)
    assert row.count(SHADES[-1]) == 1
    assert row[DAYS.column(narrow.best.low)] == SHADES[-1]


def test_what_never_satisfies_has_an_empty_lane() -> None:
    assert set(shades(NEVER, DAYS)) == {" "}


def test_a_column_has_the_shade_of_its_best_start() -> None:
    assert "".join(shades(Trapezoid(2, 4, 6, 8), Window(0, 10, 10))) == "  ▒▓▓▓▓▒  "
