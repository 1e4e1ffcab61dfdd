"""Durations and instants at the edges of the program."""

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.times import (
    format_duration,
    instant_after,
    parse_clock,
    parse_duration,
    parse_instant,
    parse_zone,
    seconds_between,
)

BERLIN = parse_zone("Europe/Berlin")


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("90 s", 90),
        ("4min", 240),
        ("4 minutes", 240),
        ("1h30", 5400),
        ("1 h 30 min", 5400),
        ("0.5 h", 1800),
        ("-2 min", -120),
        ("- 1h 1s", -3601),
        ("0", 0),
        ("2 days", 172800),
        ("250 ms", 0.25),
    ],
)
def test_durations_are_numbers_with_units(text: str, seconds: float) -> None:
    assert parse_duration(text) == seconds


@pytest.mark.parametrize(
    "text", ["", "90", "min", "4 fortnights", "1 s 2 min", "1 min 30", "1:30", "ten s", "--1 s"]
)
def test_what_is_no_duration_is_refused_with_the_text(text: str) -> None:
    with pytest.raises(FuzzytimeError, match="duration"):
        parse_duration(text)


@given(st.integers(-10_000_000, 10_000_000))
def test_printed_durations_are_read_back_to_two_units(seconds: int) -> None:
    printed = format_duration(seconds).replace("−", "-")
    unit = 3600 if abs(seconds) >= 86400 else 60 if abs(seconds) >= 3600 else 1
    assert abs(parse_duration(printed) - seconds) < unit


def test_an_hour_is_an_hour_when_clocks_change() -> None:
    before = parse_instant("2026-03-29T01:30", BERLIN)
    after = instant_after(before, 3600)
    assert after.isoformat() == "2026-03-29T03:30:00+02:00"
    assert seconds_between(before, after) == 3600


def test_a_naive_instant_is_in_the_zone_of_the_other() -> None:
    aware = datetime(2026, 3, 4, 9, tzinfo=BERLIN)
    naive = datetime(2026, 3, 4, 10)  # noqa: DTZ001 - that is the point
    assert seconds_between(aware, naive) == 3600
    assert seconds_between(naive, aware) == -3600


def test_an_instant_is_given_in_the_zone_that_is_asked_for() -> None:
    assert parse_instant("2026-03-04T09:00Z", BERLIN).isoformat() == "2026-03-04T10:00:00+01:00"
    assert parse_instant("2026-03-04T09:00Z").isoformat() == "2026-03-04T09:00:00+00:00"
    with pytest.raises(FuzzytimeError, match="years 1 to 9999"):
        parse_instant("0001-01-01T00:00+14:00", BERLIN)


def test_instants_stay_within_the_calendar() -> None:
    with pytest.raises(FuzzytimeError, match="years 1 to 9999"):
        instant_after(datetime(2026, 1, 1, tzinfo=BERLIN), 1e15)


@pytest.mark.parametrize("text", ["25:00", "9", "noon", "09:60"])
def test_what_is_no_time_of_day_is_refused(text: str) -> None:
    with pytest.raises(FuzzytimeError, match="a time of day must look like 09:30"):
        parse_clock(text)


def test_unknown_zones_and_dates_are_named() -> None:
    with pytest.raises(FuzzytimeError, match="'Mars/Olympus'"):
        parse_zone("Mars/Olympus")
    with pytest.raises(FuzzytimeError, match="'tomorrow'"):
        parse_instant("tomorrow")
