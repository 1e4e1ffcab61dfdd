"""What is done again and again is one event in a calendar, with a rule that goes on as the words do."""

import json
from datetime import datetime, timedelta
from pathlib import Path

import icalendar
import pytest
from dateutil.rrule import rrulestr

from fuzzytime.times import parse_zone
from fuzzytime_cli.formats.rules_of_series import rule_of
from fuzzytime_cli.inputs.calendar import read_calendar
from terminal.running import ran

NOW = "2026-03-04T09:00"
"""A Wednesday."""


def events(tmp_path: Path, *wishes: str, zone: str = "", now: str = NOW) -> list[icalendar.Component]:
    said = [part for wish in wishes for part in ("-i", wish)]
    where = ("--zone", zone) if zone else ()
    done = ran("plan", *said, "--format", "ics", "--now", now, *where, folder=tmp_path)
    assert done.code == 0, done.err
    (tmp_path / "plan.ics").write_text(done.out)
    return icalendar.Calendar.from_ical(done.out).walk("VEVENT")


def rule(event: icalendar.Component) -> str:
    """Give a rule as it is written."""
    text = event["RRULE"].to_ical()
    assert isinstance(text, bytes)
    return text.decode()


def times(event: icalendar.Component, most: int = 6) -> list[str]:
    """Give the first starts of an event on its wall clock, as a reader that is not ours has them."""
    start = event.decoded("DTSTART")
    series = rrulestr(rule(event), dtstart=start)
    return [f"{time:%a %d %b %H:%M}" for time, _ in zip(series, range(most), strict=False)]


@pytest.mark.parametrize(
    ("wish", "said", "first"),
    [
        ("Call mum every day at nine", "FREQ=DAILY", "Wed 04 Mar 09:00"),
        ("Bins out every other monday at 9", "FREQ=WEEKLY;INTERVAL=2;BYDAY=MO", "Mon 09 Mar 09:00"),
        ("Swim every weekday at seven am", "FREQ=WEEKLY;BYDAY=MO,TU,WE,TH,FR", "Thu 05 Mar 07:00"),
        ("Exercise on mondays and thursdays at six pm", "FREQ=WEEKLY;BYDAY=MO,TH", "Thu 05 Mar 18:00"),
        ("Call Bob every last friday of the month at noon", "FREQ=MONTHLY;BYDAY=-1FR", "Fri 27 Mar 12:00"),
        ("Phone Ann every year on 3 may at noon", "FREQ=YEARLY;BYMONTHDAY=3;BYMONTH=5", "Sun 03 May 12:00"),
    ],
)
def test_a_repetition_without_an_end_is_one_event_with_a_rule(
    wish: str, said: str, first: str, tmp_path: Path
) -> None:
    (event,) = events(tmp_path, wish)
    assert (rule(event), times(event)[0]) == (said, first)
    assert event.decoded("DTSTART").tzinfo is None


def test_one_with_an_end_comes_so_often_as_the_plan_has_it(tmp_path: Path) -> None:
    (event,) = events(tmp_path, "Bins out every monday at 9 until may")
    assert rule(event) == "FREQ=WEEKLY;COUNT=12;BYDAY=MO"
    assert times(event, 20)[-1] == "Mon 25 May 09:00"


def test_what_was_asked_for_at_once_stands_before_a_series_and_is_not_doubled(tmp_path: Path) -> None:
    first, rest = events(tmp_path, "Water the herbs every two days", now="2026-03-04T11:44")
    assert ("RRULE" in first, f"{first.decoded('DTSTART'):%a %H:%M}") == (False, "Wed 11:44")
    assert times(rest, 3) == ["Fri 06 Mar 09:00", "Sun 08 Mar 09:00", "Tue 10 Mar 09:00"]
    assert first["UID"] != rest["UID"]


def test_what_is_done_every_day_is_done_by_day_whenever_it_was_said(tmp_path: Path) -> None:
    _, rest = events(tmp_path, "Feed the cat every day until sunday", now="2026-03-04T22:30")
    assert times(rest, 9) == [f"{day} Mar 09:00" for day in ("Thu 05", "Fri 06", "Sat 07", "Sun 08")]


def test_each_time_of_a_day_is_a_series(tmp_path: Path) -> None:
    morning, evening = events(tmp_path, "Take the pill every day at nine and at five pm")
    assert (times(morning, 2)[1], times(evening, 2)[1]) == ("Thu 05 Mar 09:00", "Thu 05 Mar 17:00")


def test_an_occurrence_that_the_plan_moved_says_which_it_was(tmp_path: Path) -> None:
    found = events(tmp_path, "Call mum every day at ten", "Meet Bob tomorrow at 9:55 for an hour")
    (series,) = (event for event in found if "RRULE" in event)
    (moved,) = (event for event in found if "RECURRENCE-ID" in event)
    assert moved["UID"] == series["UID"]
    assert moved["RECURRENCE-ID"].to_ical() == b"20260305T100000"
    assert moved["DTSTART"].to_ical() == b"20260305T095000"


def test_an_occurrence_that_is_rejected_is_left_out_of_the_series(tmp_path: Path) -> None:
    found = events(tmp_path, "Call mum every day at ten sharp", "Meet Bob tomorrow from 9:00 to 11:00")
    (series,) = (event for event in found if "RRULE" in event)
    assert series["EXDATE"].to_ical() == b"20260305T100000"


def test_a_series_keeps_its_hour_when_the_clocks_change(tmp_path: Path) -> None:
    (event,) = events(tmp_path, "Call mum every day at nine", zone="Europe/Berlin")
    assert event["DTSTART"].params["TZID"] == "Europe/Berlin"
    later = datetime(2026, 3, 29, 8, tzinfo=parse_zone("Europe/Berlin"))
    assert read_calendar(tmp_path / "plan.ics", later).busy[0].start == 3600.0


def test_a_series_by_an_offset_from_utc_is_on_the_days_of_utc(tmp_path: Path) -> None:
    said = ("-i", "Call Bob every monday at half past midnight", "--format", "ics")
    done = ran("plan", *said, "--now", f"{NOW}+02:00", folder=tmp_path)
    (event,) = icalendar.Calendar.from_ical(done.out).walk("VEVENT")
    assert event["DTSTART"].to_ical() == b"20260309T223000Z"
    assert rule(event) == "FREQ=WEEKLY;BYDAY=MO"


@pytest.mark.parametrize(
    "wish",
    [
        "Check the wires every half hour",  # ends when people go to bed
        "Stretch every hour from nine to five",
        "Call Bob every monday except this monday",
    ],
)
def test_what_no_rule_gives_stays_single_events(wish: str, tmp_path: Path) -> None:
    assert not any("RRULE" in event for event in events(tmp_path, wish))


def test_times_without_a_rule_have_none() -> None:
    day = datetime.fromisoformat(NOW)
    assert rule_of([day + timedelta(days=days) for days in (0, 1, 3, 4, 8)]) is None
    assert rule_of([day, day + timedelta(hours=25)]) is None


def test_the_table_says_what_goes_on_behind_its_last_row(tmp_path: Path) -> None:
    endless = ran("plan", "-i", "Water the herbs every two days", "--now", NOW, folder=tmp_path).out
    assert "…                    and so on, every two days\n" in endless
    ending = ran("plan", "-i", "Water the herbs every two days until sunday", "--now", NOW, folder=tmp_path)
    assert "and so on" not in ending.out
    until_bed = ran("plan", "-i", "Check the wires every half hour", "--now", NOW, folder=tmp_path).out
    assert "and so on" not in until_bed
    followed = ran(
        "plan", "-i", "Every day feed the cat, then walk the dog", "--now", NOW, folder=tmp_path
    ).out
    assert followed.count("and so on") == 1


def test_json_and_a_page_say_that_it_repeats(tmp_path: Path) -> None:
    def written(kind: str, wish: str) -> str:
        return ran("plan", "-i", wish, "--format", kind, "--now", NOW, folder=tmp_path).out

    (first, *_) = json.loads(written("json", "Water the herbs every two days"))["skills"]
    assert first["requirement"]["repeats"] == {"interval_s": 172800.0, "endless": True}
    (first, *_) = json.loads(written("json", "Call mum every day at six until friday"))["skills"]
    assert first["requirement"]["repeats"] == {"interval_s": 86400.0, "endless": False}
    (once,) = json.loads(written("json", "Call mum at six"))["skills"]
    assert "repeats" not in once["requirement"]
    assert "water the herbs: and so on, every two days" in written("html", "Water the herbs every two days")


def test_how_long_the_turns_of_a_repetition_take_is_told_once(tmp_path: Path) -> None:
    out = ran(
        "plan", "-i", "Water the herbs every day", "-i", "Call mum at six", "--now", NOW, folder=tmp_path
    ).out
    assert "durations assumed: s1 to s1.3 8 min, s2 10 min" in out
