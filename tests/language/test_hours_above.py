"""Hours on a line above, "Night shift Friday 21:00-07:00": where the times of the lines below are."""

from datetime import datetime

import pytest

from fuzzytime.language import Language, RemarkKind
from fuzzytime.requirement import TimeRequirement
from fuzzytime.times import instant_after

pytestmark = pytest.mark.model

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a moment of no zone; a Wednesday


def _below(*lines: str) -> list[tuple[TimeRequirement, ...]]:
    """Give the times of the lines below the first, all said at one moment."""
    readings = Language.shipped().read_all([(line, NOW) for line in lines])
    return [part.requirements for reading in readings[1:] for part in reading.instructions]


def _at(seconds: float | None) -> str:
    return "" if seconds is None else f"{instant_after(NOW, seconds):%d %H:%M}"


NIGHT = "Night shift Friday 21:00-07:00"
NIGHT_WORK = ("break at 2", "wipe the benches by 5:30", "handover at 6:45")


@pytest.mark.parametrize(
    ("above", "line", "wanted"),
    [
        ("Friday 9-12:", "tidy the shed at 10", "06 10:00"),
        ("Friday 21:00-07:00:", "rest at 2", "07 02:00"),
        ("Friday 21:00-07:00:", "rest at ten", "06 22:00"),
        ("Night shift Friday 21:00-07:00:", "rest between 1 and 3", "07 01:00"),
        ("Market Friday 8-16:", "pack up at 3", "06 15:00"),
        # What cannot be in them is when it would be without them.
        ("Friday 9-12:", "call Bob at 4 pm", "04 16:00"),
    ],
)
def test_a_clock_time_is_in_the_hours_above(above: str, line: str, wanted: str) -> None:
    ((time,),) = _below(above, line)
    assert _at(time.earliest) == wanted


def test_a_shift_on_the_first_line_holds_for_those_below() -> None:
    rest, wipe, handover = _below(NIGHT, *NIGHT_WORK)
    assert [_at(part.earliest) for part in (*rest, *handover)] == ["07 02:00", "07 06:45"]
    assert [_at(part.latest) for part in wipe] == ["07 07:00", "07 05:30"]


def test_a_shift_is_told_and_heads_the_lines_below() -> None:
    shift, *_ = Language.shipped().read_all([(line, NOW) for line in (NIGHT, *NIGHT_WORK)])
    assert [one.operation is not None and one.operation.stated for one in shift.instructions] == [True]
    assert [one.kind for one in shift.remarks] == [RemarkKind.POLICY]


def test_hours_that_name_nothing_that_goes_on_are_a_title_only() -> None:
    title, *_ = Language.shipped().read_all([("Kitchen 17:00-23:00:", NOW), ("doors at 6", NOW)])
    assert title.instructions == ()


@pytest.mark.parametrize(
    "lines",
    [
        (NIGHT, "lunch at 1 pm", "call Ann at 4 pm", "gym at 6 pm"),
        ("Mow the lawn 9-12", "tea at 10", "call Ann at 11", "rest at 11:30"),
        (NIGHT, "handover at 6:45"),
        ("boiler man between 8 and 12", "gym at 9", "lunch at 1 pm", "call Ann at 9:30", "rest at 2"),
    ],
)
def test_hours_that_the_lines_below_do_not_fit_are_no_title(lines: tuple[str, ...]) -> None:
    first, *_ = Language.shipped().read_all([(line, NOW) for line in lines])
    assert not any("lines below it" in remark.message for remark in first.remarks)


def test_what_is_done_by_an_interval_is_bounded_by_the_hours_above() -> None:
    ((turns,),) = _below("Friday 21:00-07:00:", "check the tanks every two hours")
    assert turns.recurrence is not None
    hours = [_at(time) for time in turns.recurrence.occurrences(14 * 86400)]
    assert hours == ["06 21:00", "06 23:00", "07 01:00", "07 03:00", "07 05:00", "07 07:00"]


def test_the_night_of_a_shift_is_its_own() -> None:
    ((turns,),) = _below("Friday 21:00-07:00:", "turn Ann every three hours through the night")
    assert turns.recurrence is not None
    assert _at(turns.recurrence.occurrences(14 * 86400)[0]).startswith("06 2")


@pytest.mark.parametrize(
    "title", ["Brew day, Friday", "Friday: shoot day 4", "Friday, camp day 2", "Kitchen - Friday"]
)
def test_a_day_apart_from_its_name_is_a_title_of_many_lines(title: str) -> None:
    lines = ("fill the kettle at 7:30", "rest at noon", "mop the floor", "call Bob", "tea at 4", "wash up")
    assert [_at(part.earliest)[:2] for (part,) in _below(title, *lines)] == ["06"] * len(lines)


def test_the_end_of_the_day_is_that_of_the_hours_above() -> None:
    ((_, due),) = _below("Friday 9-17:", "finish the report by EOD")
    assert _at(due.latest) == "07 00:00"


def test_hours_that_name_a_day_are_not_of_the_day_above() -> None:
    *_, (mow,) = _below("Thursday:", "call Ann", "Friday 9-12:", "mow the lawn")
    assert _at(mow.earliest) == "06 09:00"


@pytest.mark.parametrize(
    "title",
    [
        "Night shift Friday",
        "Nights Fri",
        "Nights Fri - Ward 7",
        "Night shift Friday, on 10pm off 6am",
    ],
)
def test_a_title_names_the_night_of_those_who_work_in_it(title: str) -> None:
    lines = ("handover 10", "first break 12.30", "walk the corridors at 2.15 and 4", "tea 5.45")
    times = [_at(part.earliest) for requirements in _below(title, *lines) for part in requirements]
    assert times == ["06 22:00", "07 00:30", "07 02:15", "07 04:00", "07 05:45"]


@pytest.mark.parametrize("title", ["Night shift", "Night staff, Rosewood", "Nights - ward 4"])
def test_a_shift_at_night_without_a_day_is_tonight(title: str) -> None:
    lines = ("handover 10", "first break 12.30", "stock count 3.15", "tea 5.45")
    times = [_at(part.earliest) for requirements in _below(title, *lines) for part in requirements]
    assert times == ["04 22:00", "05 00:30", "05 03:15", "05 05:45"]


def test_the_night_of_an_event_is_no_shift() -> None:
    times = _below("Quiz night Friday", "set up 5", "doors 6.30", "food 7.15", "home 9.30")
    assert [_at(part.earliest) for (part,) in times] == ["06 17:00", "06 18:30", "06 19:15", "06 21:30"]
