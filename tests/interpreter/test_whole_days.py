"""What stands in whole days that people write: states, lengths, parts of what goes on, lines out of order."""

from datetime import datetime

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model

EIGHT = datetime(2026, 3, 4, 8)  # noqa: DTZ001 - of no zone


def _times(*lines: str) -> dict[str, tuple[float, float]]:
    """Give from when to when each is, in hours of the day."""
    made = told(lines, now=EIGHT)
    return {
        one.identifier: (8 + start / 3600, 8 + (start + one.skill.time_until_done) / 3600)
        for one, start, no in zip(made.skills, made.schedule.start_times, made.schedule.rejected, strict=True)
        if not no
    }


@pytest.mark.parametrize("when", ["between ten and eleven", "from ten to eleven"])
@pytest.mark.parametrize("state", ["closed", "shut", "open", "locked"])
def test_a_state_lasts_as_long_as_is_said(state: str, when: str) -> None:
    assert _times(f"the shop is {state} {when}") == {"s1": (10, 11)}


@pytest.mark.parametrize(
    "line", ["school finishes at quarter past three", "practice finishes at quarter past 3"]
)
def test_what_is_over_at_a_time_is_a_moment(line: str) -> None:
    assert _times(line) == {"s1": (15.25, 15.25)}


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("leave by two", 13.75),
        ("wake me up by noon", 11.75),
        ("the kids must be in bed by eight", 19.75),
        ("be back within two hours", 9.75),
        ("the guests arrive by six", 17.75),
        ("wash the car by two", 8),
        ("get up-to-date forms by two", 8),
        ("leave by friday", 8),
    ],
)
def test_nobody_leaves_or_is_woken_hours_before_it_is_time(line: str, start: float) -> None:
    assert _times(line)["s1"][0] == start


def test_when_something_is_and_by_when_it_must_be_done() -> None:
    assert _times("staff meeting at 3.30, should be done by half four")["s1"][0] == 15.5


def test_a_break_in_it_is_not_how_long_it_takes() -> None:
    assert _times("revise from 9 to 11 with a ten minute break in the middle") == {"s1": (9, 11)}
    start, end = _times("start with a ten minute walk at nine")["s1"]
    assert 60 * (end - start) == pytest.approx(10)


def test_a_length_that_is_said_of_work_keeps_hands_all_that_time() -> None:
    made = told(["paint the door for three hours", "boil the eggs for eight minutes"], now=EIGHT)
    assert [one.skill.duration for one in made.skills] == [10800, 60]


def test_the_last_part_of_what_is_told_to_end() -> None:
    made = told(
        ["write up the notes in the last half hour of the shift", "the shift ends at 7 pm"], now=EIGHT
    )
    assert starts(made) == {"s1": "18:30", "s2": "19:00"}


def test_a_time_and_an_event_are_two_times() -> None:
    made = told(["send the films to the lab at noon and at wrap", "wrap is at six"], now=EIGHT)
    assert starts(made) == {"s1": "12:00", "s1.2": "18:00", "s2": "18:00"}
    assert not any("not used" in note for note in notes(made))


@pytest.mark.parametrize(
    ("lines", "start"),
    [
        (("remind Sam 10 minutes before lunch", "lunch is at twelve"), "11:50"),
        (("mark the paper after lunch", "eat lunch at half past one"), "14:00"),
        (("clean up after dinner", "dinner from 19:30 to 20:45"), "20:45"),
        (("clean up after dinner", "buy bread for dinner"), "20:00"),
        (("mark the paper after lunch", "lunch tomorrow is at three"), "13:00"),
    ],
)
def test_when_a_meal_is_may_be_told_later(lines: tuple[str, ...], start: str) -> None:
    assert starts(told(lines, now=EIGHT))["s1"] == start


def test_what_goes_on_is_meant_and_not_what_is_done_with_it() -> None:
    lines = ("the window is from 11 to 12", "announce the window now", "check the page during the window")
    assert _times(*lines)["s3"][0] >= 11


@pytest.mark.parametrize(
    ("line", "hours"),
    [
        ("clean the garage tomorrow from two to four", (38, 40)),
        ("write the essay tonight 7 til 9", (19, 21)),
        ("study tomorrow seven to nine", (31, 33)),
        ("clean the garage tomorrow between two and four", None),
        ("mow the lawn anytime 3 to 5", None),
        ("lunch between 12 and 1.30", (12, 13.5)),
        ("lunch tomorrow noon to two", (36, 38)),
        ("lunch somewhere between 12 and 1.30", None),
        ("coffee sometime between ten and twelve", None),
    ],
)
def test_two_ends_behind_their_day_say_how_long(line: str, hours: tuple[float, float] | None) -> None:
    lasting = next(iter(_times(line).values()))
    assert lasting == hours if hours else lasting[1] - lasting[0] <= 1


def test_a_listed_weekday_that_is_today_follows_the_one_before_it() -> None:
    made = told(["Rehearse on tuesday and wednesday"])
    assert [f"{made.instant(time):%a %d}" for time in made.schedule.start_times] == ["Tue 10", "Wed 11"]
    made = told(["Rehearse on wednesday and thursday"])
    assert [f"{made.instant(time):%a %d}" for time in made.schedule.start_times] == ["Wed 04", "Thu 05"]
