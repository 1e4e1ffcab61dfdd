"""Calendars that people have are read as the times that are taken."""

import json
from datetime import datetime
from pathlib import Path

import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.times import instant_after, parse_zone
from fuzzytime_cli.inputs.calendar import read_calendar
from terminal.running import ran

NOW = datetime(2026, 3, 28, 22, 50, tzinfo=parse_zone("Europe/Berlin"))
"""Three hours and ten minutes before the clocks go forward."""


def taken(folder: Path, *events: str) -> list[str]:
    """Read events; give each busy time as start, end and what, on the clock of the zone."""
    blocks = "".join(f"BEGIN:VEVENT\n{event}\nEND:VEVENT\n" for event in events)
    path = folder / "busy.ics"
    path.write_text(f"BEGIN:VCALENDAR\nVERSION:2.0\n{blocks}END:VCALENDAR\n")
    return [
        f"{instant_after(NOW, busy.start):%d. %H:%M}-{instant_after(NOW, busy.end):%d. %H:%M} {busy.what}"
        for busy in read_calendar(path, NOW).busy
    ]


def test_an_event_across_the_change_of_clocks_ends_when_it_says(tmp_path: Path) -> None:
    at_night = (
        "DTSTART;TZID=Europe/Berlin:20260329T013000\nDTEND;TZID=Europe/Berlin:20260329T033000\nSUMMARY:Bake"
    )
    assert taken(tmp_path, at_night) == ["29. 01:30-29. 03:30 Bake"]
    (busy,) = read_calendar(tmp_path / "busy.ics", NOW).busy
    assert busy.end - busy.start == 3600.0


def test_a_repeating_event_keeps_its_hour_when_the_clocks_change(tmp_path: Path) -> None:
    daily = "DTSTART;TZID=Europe/Berlin:20200101T070000\nDURATION:PT30M\nRRULE:FREQ=DAILY\nSUMMARY:Run"
    found = taken(tmp_path, daily)
    assert len(found) == 14
    assert found[:2] == ["29. 07:00-29. 07:30 Run", "30. 07:00-30. 07:30 Run"]


def test_occurrences_that_were_deleted_or_moved_take_no_time_and_added_ones_do(tmp_path: Path) -> None:
    zone = ";TZID=Europe/Berlin"
    series = (
        f"UID:run@here\nDTSTART{zone}:20260301T070000\nDURATION:PT30M\nRRULE:FREQ=DAILY;UNTIL=20260402T235900Z\n"
        f"EXDATE{zone}:20260330T070000,20260331T070000\nRDATE{zone}:20260405T090000\nSUMMARY:Run"
    )
    moved = (
        f"UID:run@here\nRECURRENCE-ID{zone}:20260401T070000\nDTSTART{zone}:20260401T180000\n"
        "DURATION:PT30M\nSUMMARY:Run late"
    )
    cancelled = (
        f"UID:run@here\nRECURRENCE-ID{zone}:20260402T070000\nDTSTART{zone}:20260402T070000\nDURATION:PT30M\n"
        "STATUS:CANCELLED"
    )
    other = f"UID:swim@here\nDTSTART{zone}:20260401T070000\nDURATION:PT30M\nSUMMARY:Swim"
    assert taken(tmp_path, series, moved, cancelled, other) == [
        "29. 07:00-29. 07:30 Run",
        "01. 07:00-01. 07:30 Swim",
        "01. 18:00-01. 18:30 Run late",
        "05. 09:00-05. 09:30 Run",
    ]


def test_a_calendar_is_read_as_far_as_is_planned(tmp_path: Path) -> None:
    assert taken(tmp_path, "DTSTART:20260425T100000Z\nDURATION:PT1H\nSUMMARY:Fair") == []
    (fair,) = read_calendar(tmp_path / "busy.ics", NOW, 30 * 86400.0).busy
    assert fair.what == "Fair"


@pytest.mark.model
def test_what_lies_beyond_two_weeks_is_taken_where_a_plan_reaches_there(tmp_path: Path) -> None:
    taken(tmp_path, "DTSTART:20260422T080000Z\nDURATION:PT8H\nSUMMARY:Fair")
    task = tmp_path / "task.yaml"
    task.write_text(
        "now: 2026-03-28T22:50\nzone: Europe/Berlin\nhorizon: 30 d\nbusy: busy.ics\n"
        "instructions: [Call mum on April 22 at noon]\n"
    )
    assert "taken by Fair" in ran("plan", str(task), folder=tmp_path).out


def test_a_day_is_taken_whole_and_a_time_without_a_zone_is_one_here(tmp_path: Path) -> None:
    assert taken(
        tmp_path, "DTSTART;VALUE=DATE:20260330\nSUMMARY:Away", "DTSTART:20260329T100000\nDURATION:PT1H"
    ) == ["29. 10:00-29. 11:00 ", "30. 00:00-31. 00:00 Away"]


@pytest.mark.parametrize(
    "event",
    [
        "DTSTART:20260329T100000Z\nDURATION:PT1H\nSTATUS:CANCELLED",
        "DTSTART:20260329T100000Z\nDURATION:PT1H\nTRANSP:TRANSPARENT",
        "DTSTART:20260328T100000Z\nDURATION:PT1H",
        "DTSTART:20270328T100000Z\nDURATION:PT1H",
    ],
    ids=["cancelled", "transparent", "over", "far away"],
)
def test_what_takes_no_time_of_the_next_two_weeks_is_left_out(event: str, tmp_path: Path) -> None:
    assert taken(tmp_path, event) == []
    assert read_calendar(tmp_path / "busy.ics", NOW).unread == ()


@pytest.mark.parametrize(
    ("event", "said", "count"),
    [
        ("SUMMARY:Fair", "event 'Fair' takes no time: it has no DTSTART", 0),
        (
            "DTSTART:2026-03-29 10:00\nDURATION:PT1H",
            "an event without a name takes no time: its DTSTART cannot be read",
            0,
        ),
        (
            "DTSTART:20260329T100000Z\nDTEND:later\nSUMMARY:Fair",
            "event 'Fair' takes no time: its DTEND cannot be read",
            0,
        ),
        (
            "DTSTART:20260329T100000Z\nDURATION:PT1H\nRRULE:FREQ=OFTEN\nSUMMARY:Fair",
            "event 'Fair' takes no time: its RRULE cannot be read",
            0,
        ),
        (
            "DTSTART:20260329T100000Z\nDURATION:PT1H\nEXDATE:never\nSUMMARY:Fair",
            "the EXDATE of event 'Fair' cannot be read, and does not count",
            1,
        ),
    ],
)
def test_an_event_whose_times_cannot_be_read_is_told(
    event: str, said: str, count: int, tmp_path: Path
) -> None:
    assert len(taken(tmp_path, event)) == count
    assert read_calendar(tmp_path / "busy.ics", NOW).unread == (f"busy.ics: {said}",)


def test_of_many_events_that_cannot_be_read_five_are_named(tmp_path: Path) -> None:
    taken(tmp_path, *[f"SUMMARY:Fair {number}" for number in range(12)])
    unread = read_calendar(tmp_path / "busy.ics", NOW).unread
    assert (len(unread), unread[-1]) == (6, "busy.ics: 7 more events cannot be read as they are")


def test_a_plan_says_which_events_it_does_not_know_the_time_of(tmp_path: Path) -> None:
    taken(tmp_path, "SUMMARY:Fair")
    task = tmp_path / "task.yaml"
    task.write_text("now: 2026-03-28T09:00\nbusy: busy.ics\ninstructions: [Call mum soon]\n")
    done = ran("plan", str(task), "--format", "json", folder=tmp_path)
    said = "busy.ics: event 'Fair' takes no time: it has no DTSTART"
    assert (done.code, said in done.err) == (0, True)
    assert [said, "unreadable"] in [
        [problem["message"], problem["kind"]] for problem in json.loads(done.out)["problems"]
    ]
    assert ran("plan", str(task), "--strict", folder=tmp_path).code == 65


def test_times_that_tell_only_that_somebody_is_busy_are_taken(tmp_path: Path) -> None:
    path = tmp_path / "busy.ics"
    path.write_text(
        "BEGIN:VCALENDAR\nVERSION:2.0\nBEGIN:VFREEBUSY\n"
        "FREEBUSY;FBTYPE=BUSY:20260329T080000Z/PT3H,20260330T080000Z/20260330T090000Z\n"
        "FREEBUSY;FBTYPE=FREE:20260331T080000Z/PT3H\nEND:VFREEBUSY\nEND:VCALENDAR\n"
    )
    assert [busy.end - busy.start for busy in read_calendar(path, NOW).busy] == [3 * 3600.0, 3600.0]


def test_what_repeats_every_few_seconds_for_a_lifetime_is_read_at_once(tmp_path: Path) -> None:
    taken(tmp_path, "DTSTART:19700101T000000Z\nDURATION:PT7S\nRRULE:FREQ=SECONDLY;INTERVAL=7\nSUMMARY:Tick")
    found = read_calendar(tmp_path / "busy.ics", NOW).busy
    since = (NOW - datetime.fromisoformat("1970-01-01T00:00Z")).total_seconds() % 7
    assert (found[0].start, found[0].end, len(found)) == (-since, 7 - since, 500)
    (said,) = read_calendar(tmp_path / "busy.ics", NOW).unread
    assert "its first 500 times count" in said


@pytest.mark.parametrize(
    ("rule", "message"),
    [
        ("FREQ=DAILY;INTERVAL=0", "interval of at least 1, got 0"),
        ("FREQ=SECONDLY;BYMONTH=2;BYMONTHDAY=31", "daily or less often"),
        ("FREQ=MINUTELY;COUNT=99999999", "daily or less often"),
    ],
)
def test_what_would_be_looked_for_without_end_is_refused(rule: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(FuzzytimeError, match=rf"busy\.ics: .*{message}"):
        taken(tmp_path, f"DTSTART:20260101T000000Z\nDURATION:PT2S\nRRULE:{rule}")


@pytest.mark.parametrize("start", ["DTSTART;TZID=Europe/:20260329T100000", "DTSTART;VALUE=DATE,:20260329"])
def test_a_calendar_that_its_library_cannot_read_is_refused(start: str, tmp_path: Path) -> None:
    with pytest.raises(FuzzytimeError, match=r"busy\.ics must be an iCalendar file of at most 4 MB$"):
        taken(tmp_path, f"{start}\nDURATION:PT1H")


def test_what_is_no_calendar_is_refused_by_name(tmp_path: Path) -> None:
    (tmp_path / "mine.ics").write_bytes(b"\x00\xff")
    with pytest.raises(FuzzytimeError, match=r"mine\.ics must be an iCalendar file"):
        read_calendar(tmp_path / "mine.ics", NOW)
    with pytest.raises(FuzzytimeError, match="must be readable"):
        read_calendar(tmp_path / "missing.ics", NOW)


@pytest.mark.parametrize(
    ("start", "until", "count"),
    [
        (";VALUE=DATE:20260329", "20260331", 3),
        (";TZID=Europe/Berlin:20260329T150000", "20260331", 3),
        (";TZID=Europe/Berlin:20260329T150000", "20260331T150000", 3),
        (";TZID=Europe/Berlin:20260329T150000", "20260331T145959", 2),
        (":20260329T150000", "20260331T150000", 3),
        (":20260329T150000", "20260331T130000Z", 3),
        (":20260329T150000", "20260331T125959Z", 2),
    ],
)
def test_a_series_ends_with_its_last_day_or_time_as_programs_write_them(
    start: str, until: str, count: int, tmp_path: Path
) -> None:
    assert len(taken(tmp_path, f"DTSTART{start}\nRRULE:FREQ=DAILY;UNTIL={until}\nSUMMARY:Run")) == count
    assert read_calendar(tmp_path / "busy.ics", NOW).unread == ()


@pytest.mark.parametrize(
    ("event", "said", "found"),
    [
        (
            "DTSTART;TZID=Mars/Olympus:20260329T100000\nDURATION:PT1H\nSUMMARY:Fair",
            "event 'Fair' is taken as a time here: its zone 'Mars/Olympus' is not known",
            ["29. 10:00-29. 11:00 Fair"],
        ),
        (
            "DTSTART:20260329T100000\nDTEND:20260329T090000\nSUMMARY:Fair",
            "event 'Fair' takes no time: it ends before it starts",
            ["29. 10:00-29. 10:00 Fair"],
        ),
    ],
)
def test_an_event_whose_times_are_odd_is_told(
    event: str, said: str, found: list[str], tmp_path: Path
) -> None:
    assert taken(tmp_path, event) == found
    assert read_calendar(tmp_path / "busy.ics", NOW).unread == (f"busy.ics: {said}",)


def test_calendars_one_behind_the_other_in_a_file_are_all_read(tmp_path: Path) -> None:
    taken(tmp_path, "DTSTART:20260329T100000\nDURATION:PT1H\nSUMMARY:Fair")
    path = tmp_path / "busy.ics"
    path.write_text(path.read_text() + path.read_text().replace("Fair", "Choir"))
    assert [busy.what for busy in read_calendar(path, NOW).busy] == ["Fair", "Choir"]


def test_a_file_without_a_calendar_says_so(tmp_path: Path) -> None:
    (tmp_path / "empty.ics").write_text("")
    with pytest.raises(FuzzytimeError, match=r"empty\.ics must be an iCalendar file .* holds no calendar$"):
        read_calendar(tmp_path / "empty.ics", NOW)
