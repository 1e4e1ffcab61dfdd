"""Clocks are right where they are odd: changes of clocks, leap days, dates that are left out, any zone."""

import json
from datetime import UTC, datetime, timedelta
from pathlib import Path
from zoneinfo import available_timezones

import pytest

from fuzzytime.times import instant_after, parse_instant, parse_zone, seconds_between
from fuzzytime_cli.inputs.surroundings import moment_of
from terminal.running import ran
from terminal.talking import NINE, talk_of


@pytest.mark.parametrize(
    ("said", "now", "zone", "start", "seconds"),
    [
        # In the night of 29 March 2026 there is no half past two in Berlin.
        ("at 2:30 am", "2026-03-28T23:30", "Europe/Berlin", "2026-03-29T03:30:00+02:00", 3 * 3600),
        (
            "in exactly three hours",
            "2026-03-29T00:30",
            "Europe/Berlin",
            "2026-03-29T04:30:00+02:00",
            3 * 3600,
        ),
        # On 25 October 2026 it comes twice: the first is taken.
        ("at 2:30 am", "2026-10-24T23:30", "Europe/Berlin", "2026-10-25T02:30:00+02:00", 3 * 3600),
        ("at 3:30 am", "2026-10-24T23:30", "Europe/Berlin", "2026-10-25T03:30:00+01:00", 5 * 3600),
        # Lord Howe moves its clocks by half an hour; Samoa left out 30 December 2011.
        ("at 2:15 am", "2026-10-03T22:00", "Australia/Lord_Howe", "2026-10-04T02:45:00+11:00", 4.25 * 3600),
        ("tomorrow at 9 am", "2011-12-29T20:00", "Pacific/Apia", "2011-12-31T09:00:00+14:00", 13 * 3600),
        ("tomorrow at 9 am", "2028-02-28T20:00", "Europe/Berlin", "2028-02-29T09:00:00+01:00", 13 * 3600),
        ("tomorrow at 9 am", "2026-02-28T20:00", "Europe/Berlin", "2026-03-01T09:00:00+01:00", 13 * 3600),
        ("in exactly 24 hours", "2028-02-28T20:00", "Europe/Berlin", "2028-02-29T20:00:00+01:00", 86400),
        ("in exactly two hours", "2026-12-31T23:00", "Asia/Kathmandu", "2027-01-01T01:00:00+05:45", 7200),
    ],
)
def test_a_start_is_when_it_was_said(
    said: str, now: str, zone: str, start: str, seconds: float, tmp_path: Path
) -> None:
    arguments = ("-i", f"Bake the bread {said}", "--now", now, "--zone", zone, "--format", "json")
    (skill,) = json.loads(ran("plan", *arguments, folder=tmp_path).out)["skills"]
    assert (skill["start"], skill["start_s"]) == (start, pytest.approx(seconds))


def test_words_are_of_the_zone_that_is_asked_for_whatever_now_is_given_in(tmp_path: Path) -> None:
    arguments = ("-i", "Call mum at noon", "--now", "2026-03-04T00:00Z", "--zone", "Asia/Tokyo")
    (skill,) = json.loads(ran("plan", *arguments, "--format", "json", folder=tmp_path).out)["skills"]
    assert skill["start"] == "2026-03-04T12:00:00+09:00"


@pytest.mark.parametrize(("date", "hours"), [("2026-03-28", 4), ("2026-10-24", 6), ("2026-06-01", 5)])
def test_a_night_is_taken_as_long_as_it_is_when_clocks_change(date: str, hours: float) -> None:
    now = parse_instant(f"{date}T20:00", parse_zone("Europe/Berlin"))
    evening = moment_of("23:00", now)
    assert moment_of("04:00", now, since=evening) - evening == hours * 3600


def test_time_passes_as_in_utc_in_every_zone_in_every_hour_of_a_change() -> None:
    steps = (1.0, 60.0, 3600.0, 5400.0, 86_400.0, -7200.0)
    zones = sorted(available_timezones())
    assert len(zones) > 400
    for name in zones:
        zone = parse_zone(name)
        year = [datetime(2026, 1, 1, tzinfo=UTC) + timedelta(hours=6 * count) for count in range(4 * 365)]
        offsets = [moment.astimezone(zone).utcoffset() for moment in year]
        changes = [year[at] for at in range(len(year) - 1) if offsets[at] != offsets[at + 1]]
        for begin in (changes or year[:1])[:2]:
            for half_hours in range(13):
                now = (begin + timedelta(minutes=30 * half_hours)).astimezone(zone)
                for seconds in steps:
                    later = instant_after(now, seconds)
                    assert (later.astimezone(UTC) - now.astimezone(UTC)).total_seconds() == seconds, name
                    assert seconds_between(now, later) == seconds, name
                    assert parse_instant(later.isoformat(), zone).astimezone(UTC) == later.astimezone(UTC)


def test_a_clock_that_goes_back_starts_nothing_twice_and_loses_nothing() -> None:
    talk = talk_of("Feed the cat now")
    assert "start now: feed the cat" in talk.wait(seconds=1)
    talk.say("Call mum in exactly ten minutes")
    started = talk.turns.conversation.store.started("test")
    talk.now = NINE - timedelta(hours=1)
    assert "feed the cat" not in talk.wait(seconds=1)
    assert "start now" not in talk.say(":list")
    assert talk.turns.conversation.store.started("test") == started
    assert talk.entries == ["Feed the cat now", "Call mum in exactly ten minutes"]
    assert abs(talk.start("s2") - (NINE + timedelta(minutes=10))) < timedelta(minutes=2)
