"""Repetitions give their occurrences in order, and no others."""

from datetime import datetime
from zoneinfo import ZoneInfo

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import find_times
from fuzzytime.language.meaning.recurrences.recurrence import MOST, CalendarRecurrence, EvenRecurrence
from fuzzytime.language.meaning.recurrences.recurrence_on_days import RecurrenceOnDays
from fuzzytime.requirement import Recurrence
from fuzzytime.times import instant_after

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001
DAY = 86400.0


def recurrence(text: str, now: datetime = NOW) -> Recurrence:
    found = find_times(text, now).found[0].recurrence
    assert found is not None
    return found


TEXTS = (
    "every 20 minutes", "every day at nine pm", "on weekdays at 7", "every other friday", "twice a day",
    "every monday and thursday", "the first monday of every month", "every hour until 6 pm", "every morning",
    "every hour on weekdays from nine to five",
)  # fmt: skip


@pytest.mark.parametrize("text", TEXTS)
@given(until=st.floats(0, 90 * DAY))
def test_occurrences_ascend_from_now_to_the_horizon(text: str, until: float) -> None:
    found = recurrence(text).occurrences(until)
    assert list(found) == sorted(set(found))
    assert all(0 <= time <= until for time in found)


@pytest.mark.parametrize("text", TEXTS)
@given(until=st.floats(0, 40 * DAY), more=st.floats(0, 40 * DAY))
def test_a_longer_horizon_only_adds_occurrences(text: str, until: float, more: float) -> None:
    near, far = recurrence(text).occurrences(until), recurrence(text).occurrences(until + more)
    assert far[: len(near)] == near


@pytest.mark.parametrize("text", TEXTS)
def test_the_coming_occurrences_are_the_first(text: str) -> None:
    found = recurrence(text)
    assert isinstance(found, (EvenRecurrence, CalendarRecurrence, RecurrenceOnDays))
    coming = found.coming(3)
    assert found.windows(coming[-1][0])[: len(coming)] == coming


WITHIN = {
    "every morning": (8 * 3600, 12 * 3600),
    "every evening": (18 * 3600, 22 * 3600),
    "every night": (20 * 3600, 24 * 3600),
    "every day from 9 to 5": (9 * 3600, 17 * 3600),
    "every friday": (0, 24 * 3600),
    "every day at noon": (12 * 3600, 12 * 3600),
}


@pytest.mark.parametrize("text", WITHIN)
def test_an_occurrence_that_is_a_stretch_of_time_lasts_as_long(text: str) -> None:
    first, last = recurrence(text).windows(15 * DAY)[1]
    begins, ends = WITHIN[text]
    assert last - first == ends - begins
    assert (9 * 3600 + first) % DAY == begins


def test_twice_a_day_is_once_in_each_half_of_it() -> None:
    assert recurrence("twice a day").windows(DAY - 1) == ((0, DAY / 2), (DAY / 2, DAY))


def test_an_occurrence_ends_with_its_series() -> None:
    assert recurrence("every day until friday").windows(9 * DAY)[-1][1] == 3 * DAY - 9 * 3600


def test_a_time_of_day_is_kept_when_clocks_change() -> None:
    saturday = datetime(2026, 3, 28, 10, tzinfo=ZoneInfo("Europe/Berlin"))
    times = recurrence("every day at nine am", saturday).occurrences(4 * DAY)
    assert {instant_after(saturday, time).hour for time in times} == {9}
    assert times[0] == 22 * 3600


def test_too_many_occurrences_are_not_given() -> None:
    assert len(recurrence("every second").occurrences(1e9)) == MOST


def test_even_spacing_has_an_interval_and_weekdays_have_none() -> None:
    assert recurrence("every two hours").interval == 7200
    assert recurrence("every monday").interval == 7 * DAY
    assert recurrence("on weekdays").interval is None


def test_without_a_clock_only_lengths_can_repeat() -> None:
    assert find_times("every ten minutes", None).found[0].recurrence is not None
    assert find_times("every day at nine", None).found == ()


@pytest.mark.parametrize(
    ("text", "hour", "first", "count"),
    [
        ("every half hour from nine to ten on weekdays", 8, 3600.0, 3),
        ("every half hour from nine to ten on weekdays", 9, 0.0, 3),
        ("twice a day on wednesdays", 13, 0.0, 1),
    ],
)
def test_an_interval_on_some_days_goes_on_where_a_day_has_begun(
    text: str, hour: int, first: float, count: int
) -> None:
    said = find_times(text, NOW.replace(hour=hour)).found[0].recurrence
    assert isinstance(said, RecurrenceOnDays)
    today = said.occurrences((24 - hour) * 3600.0 - 1)
    assert (today[0], len(today)) == (first, count)
    assert said.spaced(60) is said
    assert said.endless
