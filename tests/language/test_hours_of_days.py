"""Lines of a day: which half of it a clock time without am or pm is in, by what is said in front of it."""

from datetime import datetime, timedelta

import pytest

from fuzzytime.language import Language
from fuzzytime.language.meaning.recurrences.recurrence import EvenRecurrence
from fuzzytime.requirement import TimeRequirement

pytestmark = pytest.mark.model


SHIFT = (
    "leave at quarter to seven|handover at half seven|first round at eight|obs at ten|break at midnight|"
    "turn Mr Khan at two|bloods at four|second round at six|write up the notes by quarter past seven"
)
"""A night at work, said at five in the afternoon."""


def _last(now: datetime, *lines: str) -> list[TimeRequirement]:
    """Give the times of the last line."""
    reading = Language.shipped().read_all([(line, now) for line in lines])[-1]
    return [part for one in reading.instructions for part in one.requirements]


def _at(now: datetime, part: TimeRequirement) -> str:
    """Give where a time begins, or is over."""
    seconds = part.latest if part.earliest is None else part.earliest
    if isinstance(part.recurrence, EvenRecurrence):
        seconds = part.recurrence.first
    return f"{now + timedelta(seconds=seconds or 0.0):%a %H:%M}"


@pytest.mark.parametrize(
    ("hour", "lines", "wanted"),
    [
        # A deadline at the end of the day is not what the next line follows.
        (7, "dinner at five|bins out before bed|ring mum after eight", "Wed 20:00"),
        (7, "school run at 8:15|lunch at half twelve|bins out before bed|bath at seven", "Wed 19:00"),
        # What is done again and again is so through the day.
        (6, "meeting at 11|leave by half five|feed the cells every two hours starting at nine", "Wed 09:00"),
        (8, "count at ten|lunch at one|read the meter every half hour starting at two", "Wed 14:00"),
        # Lights are out in the evening; who works at night is in bed in the morning.
        (
            6,
            "call Jane at 2|tablet at 7pm|no coffee after three|lights out by half ten",
            "Wed 22:30",
        ),
        (17, f"{SHIFT}|in bed by half eight", "Thu 08:30"),
        # What goes on overnight is no clue.
        (8, "call at 2|deploy after 5|back up the laptop overnight|gym at 6ish", "Wed 18:00"),
        # Hours that are spelled out make a list of times, too.
        (8, "train at half eight|call at quarter past nine|send it by two|budget review 2.30", "Wed 14:30"),
        (9, "lunch at half twelve|call at two|tea at half three|lab 4 til 6", "Wed 16:00"),
    ],
)
def test_the_half_of_the_day_is_that_of_the_lines(hour: int, lines: str, wanted: str) -> None:
    now = datetime(2026, 3, 4, hour)  # noqa: DTZ001 - a moment of no zone; a Wednesday
    assert _at(now, _last(now, *lines.split("|"))[0]) == wanted


def test_each_of_two_times_has_a_bound_of_its_own() -> None:
    now = datetime(2026, 3, 4, 6, 30)  # noqa: DTZ001
    found = _last(now, "breakfast around 7", "walk the dog twice, once before noon and once after 4")
    assert [_at(now, part) for part in found] == ["Wed 12:00", "Wed 16:00"]
