"""A day said once holds for the clock times that are said apart from it."""

from datetime import datetime

import pytest

from fuzzytime.language import Language
from fuzzytime.requirement import Recurrence
from fuzzytime.times import instant_after

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001


def occurrences(text: str, instruction: int = 0) -> list[str]:
    """Give when a repetition in a text comes next, twice: day and hour."""
    recurrence: Recurrence | None = Language.shipped().read(text, now=NOW).instructions[instruction].repeats
    assert recurrence is not None
    starts = recurrence.occurrences(14 * 86400)[:2]
    return [f"{instant_after(NOW, seconds):%d %H}" for seconds in starts]


@pytest.mark.parametrize(
    ("text", "instruction", "wanted"),
    [
        ("on weekdays open the blinds at 7", 0, ["05 07", "06 07"]),
        ("every evening lock the door at ten", 0, ["04 22", "05 22"]),
        ("every day, feed the cat at eight and walk the dog at ten", 1, ["04 10", "05 10"]),
        ("every friday, vacuum the hall and empty the bins", 1, ["06 00", "13 00"]),
        ("every monday sweep the yard after 6 pm", 0, ["09 18", "16 18"]),
    ],
)
def test_a_repetition_has_the_time_of_day_that_is_said_apart(
    text: str, instruction: int, wanted: list[str]
) -> None:
    assert occurrences(text, instruction) == wanted


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("next week, call Bob on Tuesday", "10 00"),
        ("on friday keep the shop open from 9 to 5", "06 09"),
        ("tomorrow stretch ten minutes before noon", "05 11"),
        ("tomorrow clean up after 6 pm", "05 18"),
        ("tonight call mum at nine", "04 21"),
    ],
)
def test_a_time_lies_on_the_day_that_is_said_apart(text: str, wanted: str) -> None:
    (instruction,) = Language.shipped().read(text, now=NOW).instructions
    earliest = instruction.requirements[-1].earliest
    assert earliest is not None
    assert f"{instant_after(NOW, earliest):%d %H}" == wanted


@pytest.mark.parametrize(
    ("text", "left_out"),
    [
        ("feed the cat every day at nine except sundays", {6}),
        ("feed the cat every day at nine apart from sunday", {6}),
        ("feed the cat every day at nine (not on sundays)", {6}),
        ("feed the cat every day at nine (except saturdays and sundays)", {5, 6}),
        ("apart from sundays, feed the cat every day at nine", {6}),
        ("feed the cat every day at nine, never on weekends", {5, 6}),
    ],
)
def test_weekdays_are_left_out_in_every_week(text: str, left_out: set[int]) -> None:
    (instruction,) = Language.shipped().read(text, now=NOW).instructions
    assert instruction.repeats is not None
    assert len(instruction.requirements) == 1, "nothing else is said of its time"
    days = [instant_after(NOW, seconds) for seconds in instruction.repeats.occurrences(70 * 86400)]
    assert {day.weekday() for day in days} == set(range(7)) - left_out
    assert {day.hour for day in days} == {9}


def test_a_day_ends_with_its_sentence() -> None:
    reading = Language.shipped().read("Tomorrow wash the car at 9. Feed the cat at 6.", now=NOW)
    assert reading.instructions[1].requirements[0].t_spec == 9 * 3600


@pytest.mark.parametrize(
    ("text", "day"),
    [
        ("call Bob on friday and print the music the day after", "07"),
        ("call Bob on friday and print the music that day", "06"),
        ("the party is on the 21st. Bake the cake the day before", "20"),
        ("fly on sunday and pack the day before", "07"),
        ("print the music the day after", "05"),
    ],
)
def test_days_count_from_the_day_that_was_said(text: str, day: str) -> None:
    last = Language.shipped().read(text, now=NOW).instructions[-1].requirements[-1]
    assert last.earliest is not None
    assert f"{instant_after(NOW, last.earliest):%d}" == day


def test_that_day_needs_a_day() -> None:
    reading = Language.shipped().read("call Bob and send the music that day", now=NOW)
    assert any("which day" in remark.message for remark in reading.remarks)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("check the pump on friday every 20 minutes until noon", "06 07"),
        ("check the pump every 20 minutes on friday until noon", "06 07"),
        ("on friday check the pump every 20 minutes until noon", "06 07"),
        ("tomorrow check the pump every hour from ten", "05 10"),
        ("check the pump tomorrow every hour from ten until two", "05 10"),
        ("on friday night check the pump every hour from 11 pm until 6 am", "06 23"),
        ("tomorrow afternoon check the pump every hour", "05 12"),
        ("tomorrow call Ann and check the pump every hour until noon", "05 07"),
    ],
)
def test_what_is_done_by_an_interval_is_on_the_day_that_is_said(text: str, wanted: str) -> None:
    instruction = 1 if "call" in text else 0
    assert occurrences(text, instruction)[0] == wanted


def test_an_interval_on_a_day_ends_with_its_bound() -> None:
    text = "tomorrow check the pump every hour from ten until two"
    repeats = Language.shipped().read(text, now=NOW).instructions[0].repeats
    assert repeats is not None
    hours = [f"{instant_after(NOW, seconds):%H}" for seconds in repeats.occurrences(14 * 86400)]
    assert hours == ["10", "11", "12", "13", "14"]


def test_a_choice_for_a_bound_is_said_of_the_words_that_say_it() -> None:
    reading = Language.shipped().read("tomorrow check the pump every hour from nine", now=NOW)
    assert [remark.message.partition(" is ")[0] for remark in reading.remarks] == ["'every hour from nine'"]


def test_an_interval_that_goes_on_today_has_turns_to_come() -> None:
    repeats = Language.shipped().read("check the pump every hour today", now=NOW).instructions[0].repeats
    assert repeats is not None
    assert [start for start, _ in repeats.coming(2)] == [0.0, 3600.0]


@pytest.mark.parametrize(
    ("text", "first", "last"),
    [
        ("tonight check the pump every two hours until two", "04 20", "05 02"),
        ("check the pump every two hours tonight until two", "04 20", "05 02"),
        ("on friday night check the pump every hour until 11", "06 20", "06 23"),
        ("tomorrow evening check the pump every hour until one", "05 18", "06 01"),
        ("tomorrow morning check the pump every hour until two", "05 08", "05 14"),
        ("tomorrow afternoon check the pump every hour from two until six", "05 14", "05 18"),
    ],
)
def test_an_interval_in_a_part_of_a_day_is_over_at_the_hour_behind_it(
    text: str, first: str, last: str
) -> None:
    reading = Language.shipped().read(text, now=NOW)
    repeats = reading.instructions[0].repeats
    assert repeats is not None
    turns = [f"{instant_after(NOW, seconds):%d %H}" for seconds in repeats.occurrences(14 * 86400)]
    assert (turns[0], turns[-1]) == (first, last)
    assert not any(f"{last[3:]}:00:" in remark.message for remark in reading.remarks)


@pytest.mark.parametrize(
    "text", ["check the pump every six hours on friday", "on friday check it every six hours"]
)
def test_an_interval_on_a_day_is_over_with_it(text: str) -> None:
    repeats = Language.shipped().read(text, now=NOW).instructions[0].repeats
    assert repeats is not None
    assert [f"{instant_after(NOW, t):%d %H}" for t in repeats.occurrences(14 * 86400)] == [
        "06 00",
        "06 06",
        "06 12",
        "06 18",
    ]


@pytest.mark.parametrize(
    "text",
    [
        "on friday finish the report by EOD",
        "finish the report on friday by the end of the day",
        "friday: finish the report by end of day",
    ],
)
def test_the_end_of_the_day_is_that_of_the_day_that_is_said(text: str) -> None:
    reading = Language.shipped().read(text, now=NOW)
    ((_, due),) = (one.requirements for one in reading.instructions)
    assert due.latest is not None
    assert f"{instant_after(NOW, due.latest):%d %H}" == "07 00"
    assert not any("another time" in remark.message for remark in reading.remarks)


def test_the_first_of_two_times_of_a_day_is_before_the_second() -> None:
    text = "tomorrow milk the cows at 5 and again at 4:30 in the afternoon"
    parts = [part for one in Language.shipped().read(text, now=NOW).instructions for part in one.requirements]
    hours = [f"{instant_after(NOW, part.t_spec):%d %H:%M}" for part in parts if part.t_spec is not None]
    assert hours == ["05 05:00", "05 16:30"]
