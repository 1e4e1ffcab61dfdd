"""Values with units, and their conversion."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.context.units import UNITS, convert, parse_quantity
from fuzzytime.errors import FuzzytimeError


@pytest.mark.parametrize(
    ("value", "source", "target", "expected"),
    [
        (356, "degF", "degC", 180),
        (32, "°F", "°C", 0),
        (0, "degC", "K", 273.15),
        (20, "min", "s", 1200),
        (2, "bar", "psi", 29.0075),
        (50, "%", "1", 0.5),
        (3000, "rpm", "Hz", 50),
        (5, "tasks", "tasks", 5),
    ],
)
def test_values_convert(value: float, source: str, target: str, expected: float) -> None:
    assert convert(value, source, target) == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize(("source", "target"), [("degC", "s"), ("tasks", "parts"), ("degC", "nonsense")])
def test_what_does_not_measure_the_same_is_refused(source: str, target: str) -> None:
    with pytest.raises(FuzzytimeError, match="cannot be converted"):
        convert(1, source, target)


@given(st.sampled_from(sorted(UNITS)), st.sampled_from(sorted(UNITS)), st.floats(-1e6, 1e6))
def test_conversion_there_and_back_changes_nothing(source: str, target: str, value: float) -> None:
    if UNITS[source].dimension == UNITS[target].dimension:
        assert convert(convert(value, source, target), target, source) == pytest.approx(
            value, rel=1e-9, abs=1e-6
        )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("180", (180.0, None)),
        ("-3.5e2 degC", (-350.0, "degC")),
        ("356degF", (356.0, "degF")),
        ("5 °C", (5.0, "°C")),
        ("90 %", (90.0, "%")),
        ("1h30", (5400.0, "s")),
        ("1 min 30 s", (90.0, "s")),
        ("\u22125 degC", (-5.0, "degC")),
        ("2 mm/h", (2.0, "mm/h")),
    ],
)
def test_quantities_are_read(text: str, expected: tuple[float, str | None]) -> None:
    assert parse_quantity(text) == expected


@pytest.mark.parametrize("text", ["", "hot", "degC 180", "1e999", "nan", "inf degC", "180 " + "x" * 60])
def test_what_is_no_quantity_is_refused(text: str) -> None:
    with pytest.raises(FuzzytimeError):
        parse_quantity(text)
