"""A context is a value: readings by signal and time."""

import pytest

from fuzzytime.context import Context, Reading, Signal
from fuzzytime.errors import FuzzytimeError

PAN = Signal(name="pan_temp", unit="degC", low=0, high=350)
TIMER = Signal(name="timer", event=True)
SIGNALS = {"pan_temp": PAN, "timer": TIMER}


def test_a_mapping_gives_readings_now_or_over_time() -> None:
    context = Context.of({"pan_temp": [(-60, 120), (0, "150 degC")], "timer": None})
    assert context.readings == (
        Reading("pan_temp", -60, 120.0),
        Reading("pan_temp", 0, 150.0, "degC"),
        Reading("timer", 0.0),
    )


def test_a_later_reading_at_the_same_time_stands() -> None:
    context = Context.of({"pan_temp": 20.0}).with_reading(Reading("pan_temp", 0.0, 180.0))
    assert context.of_signal("pan_temp") == (Reading("pan_temp", 0.0, 180.0),)


def test_shifting_moves_the_origin() -> None:
    context = Context.of({"pan_temp": [(-60, 120)]})
    assert context.shifted(300).readings[0].at == 240
    assert context.shifted(300).shifted(-300) == context


def test_merging_lets_the_other_s_readings_stand() -> None:
    merged = Context.of({"pan_temp": 20.0}).merged(Context.of({"pan_temp": 180.0, "timer": None}))
    assert merged == Context.of({"pan_temp": 180.0, "timer": None})


def test_the_empty_context_has_no_readings() -> None:
    assert Context.empty.readings == ()
    assert Context.empty == Context()


def test_readings_are_admitted_in_the_signal_s_unit() -> None:
    admitted = Context.of({"pan_temp": "356 degF"}).admitted(SIGNALS)
    assert admitted.readings[0].value == pytest.approx(180)
    assert admitted.readings[0].unit == "degC"


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"pan_tmp": 180.0}, "unknown signal 'pan_tmp' \\(did you mean 'pan_temp'\\?\\)"),
        ({"pan_temp": 900.0}, "'pan_temp' must lie between 0 and 350 degC, got 900"),
        ({"pan_temp": "3 min"}, "a value in 'min' cannot be converted to 'degC'"),
        ({"pan_temp": None}, "a reading of 'pan_temp' must have a value"),
        ({"timer": 3.0}, "the event 'timer' must have no value, got 3"),
    ],
)
def test_what_a_signal_cannot_have_is_refused(values: dict[str, float | str | None], message: str) -> None:
    with pytest.raises(FuzzytimeError, match=message):
        Context.of(values).admitted(SIGNALS)


@pytest.mark.parametrize("reading", [("x", float("nan"), 1.0), ("x", 1e11, 1.0), ("x", 0.0, float("inf"))])
def test_readings_are_finite(reading: tuple[str, float, float]) -> None:
    with pytest.raises(FuzzytimeError, match=r"must be finite|must lie within"):
        Reading(*reading)


def test_a_limit_in_another_unit_is_inside_its_range() -> None:
    assert PAN.admitted(662.0, "degF") == 350.0


def test_what_is_derived_of_readings_is_derived_once() -> None:
    context = Context.of({"pan_temp": 180.0})
    assert [context.derived("count", lambda: len(context.readings)) for _ in range(2)] == [1, 1]
    assert context.derived("count", lambda: 7) == 1
    assert context == Context.of({"pan_temp": 180.0})


def test_admitted_readings_are_admitted_as_they_are() -> None:
    celsius, fahrenheit = Signal(name="pan_temp", unit="degC"), Signal(name="pan_temp", unit="degF")
    admitted = Context.of({"pan_temp": "356 degF"}).admitted({"pan_temp": celsius})
    assert admitted.admitted({"pan_temp": celsius}) is admitted
    assert admitted.admitted({"pan_temp": fahrenheit}).readings[0].value == pytest.approx(356.0)
