"""Wall clocks: zones, the nights when clocks change, policies, the ends of the calendar."""

from dataclasses import replace
from datetime import UTC, datetime, time, timedelta
from zoneinfo import ZoneInfo, available_timezones

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import Policy, find_times
from fuzzytime.language.finding import shipped_lexicon
from fuzzytime.language.instruction import RemarkKind
from fuzzytime.language.policy import DateOrder, Midnight, SameWeekday
from fuzzytime.requirement import TimeRequirement
from fuzzytime.times import instant_after

BERLIN = ZoneInfo("Europe/Berlin")
WEDNESDAY = datetime(2026, 3, 4, 9)  # noqa: DTZ001
DECADES = st.datetimes(datetime(1990, 1, 1), datetime(2037, 12, 31))  # noqa: DTZ001


def only(text: str, now: datetime, policy: Policy | None = None) -> TimeRequirement:
    lexicon = shipped_lexicon()
    if policy is not None:
        lexicon = replace(lexicon, policy=policy)
    return find_times(text, now, lexicon).requirements[0]


def at(text: str, now: datetime, policy: Policy | None = None) -> datetime:
    seconds = only(text, now, policy).earliest
    assert seconds is not None
    return instant_after(now, seconds)


def test_a_clock_time_is_that_of_our_zone_across_the_change_of_clocks() -> None:
    evening = datetime(2026, 3, 28, 20, tzinfo=BERLIN)
    assert at("at 7 am", evening) == datetime(2026, 3, 29, 7, tzinfo=BERLIN)
    assert only("at 7 am", evening).earliest == 10 * 3600


def test_hours_from_now_are_elapsed_and_days_are_of_the_wall_clock() -> None:
    evening = datetime(2026, 3, 28, 20, tzinfo=BERLIN)
    assert only("in 24 hours", evening).t_spec == 86400
    assert only("in a day", evening).t_spec == 23 * 3600
    assert at("in a day and two hours", evening) == datetime(2026, 3, 29, 22, tzinfo=BERLIN)


def test_a_time_that_is_skipped_is_as_long_after_the_change() -> None:
    night = datetime(2026, 3, 29, 1, tzinfo=BERLIN)
    assert only("at 2:30 am", night).t_spec == 5400
    remarks = find_times("at 2:30 am", night).remarks
    assert [remark.kind for remark in remarks] == [RemarkKind.POLICY]
    assert "does not exist on that day, as clocks change: 03:30 is taken" in remarks[0].message
    assert find_times("at 3:30 am", night).remarks == ()


def test_a_time_that_comes_twice_is_the_first_and_then_the_second() -> None:
    before = datetime(2026, 10, 25, 1, tzinfo=BERLIN)
    between = datetime(2026, 10, 25, 2, 45, tzinfo=BERLIN)
    assert only("at 2:30 am", before).t_spec == 5400
    assert only("at 2:50 am", between).t_spec == 300


def test_a_time_of_another_zone_is_converted() -> None:
    noon = datetime(2026, 3, 4, 12, tzinfo=BERLIN)
    assert at("at 3 pm GMT", noon) == datetime(2026, 3, 4, 15, tzinfo=UTC)
    assert at("3pm PST", noon) == datetime(2026, 3, 4, 23, tzinfo=UTC)
    assert at("at 9 am eastern time", noon) == datetime(2026, 3, 4, 14, tzinfo=UTC)
    assert at("from 15:00 to 16:00 UTC", noon) == datetime(2026, 3, 4, 15, tzinfo=UTC)


def test_a_zone_is_not_used_where_ours_is_unknown_and_that_is_said() -> None:
    found = find_times("at 3 pm GMT", WEDNESDAY)
    assert found.requirements[0].t_spec == 6 * 3600
    assert [remark.kind for remark in found.remarks] == [RemarkKind.POLICY]


@pytest.mark.parametrize(("said", "hour"), [(7, 18), (17, 18), (19, 6), (23, 6)])
def test_at_six_is_the_next_plausible_six(said: int, hour: int) -> None:
    awake = replace(Policy(), plausible_from=time(6))
    found = at("at six", WEDNESDAY.replace(hour=said), awake)
    assert found.hour == hour


@pytest.mark.parametrize(
    ("text", "day", "hour"), [("until ten", 4, 22), ("by eleven", 4, 23), ("by six", 5, 18)]
)
def test_a_deadline_that_can_be_kept_today_is_meant(text: str, day: int, hour: int) -> None:
    evening = datetime(2026, 3, 4, 20, 10)  # noqa: DTZ001
    latest = only(text, evening).latest
    assert latest is not None
    assert instant_after(evening, latest) == datetime(2026, 3, day, hour)  # noqa: DTZ001


def test_hours_that_are_plausible_are_a_policy() -> None:
    early = replace(Policy(), plausible_from=time(3), plausible_to=time(12))
    assert at("at six", WEDNESDAY).hour == 18
    assert at("at six", WEDNESDAY, early).hour == 6


def test_a_weekday_on_that_day_is_a_policy() -> None:
    assert at("on wednesday", WEDNESDAY, Policy(same_weekday=SameWeekday.TODAY)).day == 4
    assert at("on wednesday", WEDNESDAY, Policy(same_weekday=SameWeekday.NEXT)).day == 11
    assert at("on wednesday at 8 am", WEDNESDAY, Policy(same_weekday=SameWeekday.TODAY)).day == 11


def test_which_midnight_of_a_day_is_meant_is_a_policy() -> None:
    begins, ends = Policy(midnight=Midnight.START), Policy(midnight=Midnight.END)
    assert at("at midnight on friday", WEDNESDAY, ends).day == 7
    assert at("at midnight on friday", WEDNESDAY, begins).day == 6
    assert at("at midnight on christmas eve", WEDNESDAY, begins).day == 25


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("at midnight on friday", True),
        ("from midnight on friday to noon on saturday", True),
        ("every friday at midnight", True),
        ("at midnight tonight", False),
        ("at midnight today", False),
        ("on friday night at midnight", False),
        ("at midnight on new year's eve", False),
        ("at ten to midnight on friday", False),
        ("every day at midnight", False),
    ],
)
def test_a_midnight_that_may_be_either_of_a_day_is_said(text: str, said: bool) -> None:  # noqa: FBT001
    noted = [remark.message for remark in find_times(text, WEDNESDAY).remarks]
    assert any("where that day is over" in message for message in noted) is said


def test_the_order_of_day_and_month_is_a_policy() -> None:
    assert at("on 4/5", WEDNESDAY, Policy(date_order=DateOrder.MONTH_DAY)).date().isoformat() == "2026-04-05"
    assert at("on 4/5", WEDNESDAY, Policy(date_order=DateOrder.DAY_MONTH)).date().isoformat() == "2026-05-04"
    assert at("on 25/12", WEDNESDAY).date().isoformat() == "2026-12-25"


def test_the_first_day_of_the_week_is_a_policy() -> None:
    sunday = Policy(week_starts=6, weekend_from=4)
    assert at("next week", WEDNESDAY, sunday).day == 8
    assert at("this weekend", WEDNESDAY, sunday).day == 6


@pytest.mark.parametrize(
    ("text", "said", "over"),
    [("before dinner", 18, 20), ("before the evening", 19, 22), ("before lunch", 12, 13)],
)
def test_before_a_part_of_the_day_that_has_begun_is_before_its_end(text: str, said: int, over: int) -> None:
    now = WEDNESDAY.replace(hour=said, minute=1)
    found = find_times(text, now)
    assert instant_after(now, found.requirements[0].latest or 0.0) == now.replace(hour=over, minute=0)
    assert [remark.kind for remark in found.remarks] == [RemarkKind.POLICY]


def test_before_a_part_of_the_day_to_come_is_before_its_start() -> None:
    found = find_times("before dinner", WEDNESDAY.replace(hour=17))
    assert found.requirements[0].latest == 3600
    assert found.remarks == ()


def test_questions_are_asked_unless_the_policy_forbids() -> None:
    lexicon = replace(shipped_lexicon(), policy=Policy(ask=False))
    assert find_times("at six", WEDNESDAY, lexicon).questions == ()
    assert find_times("at six", WEDNESDAY).questions != ()
    assert find_times("at six pm", WEDNESDAY).questions == ()
    assert find_times("no later than eleven hundred hours", WEDNESDAY).questions == ()


@pytest.mark.parametrize(
    "text", ["on the 30th of february", "tomorrow", "in 9000 years", "at noon on 31.12.9999"]
)
def test_a_day_that_is_none_is_said_and_not_guessed(text: str) -> None:
    last = datetime(9999, 12, 31, 23)  # noqa: DTZ001
    found = find_times(text, last)
    assert found.requirements == ()
    assert [remark.kind for remark in found.remarks] == [RemarkKind.NOT_UNDERSTOOD]


def test_nothing_is_before_the_first_year() -> None:
    first = datetime(1, 1, 2)  # noqa: DTZ001
    text = "5291-2379-66946134616-as soon as possible-4-921-the preceding-mid morning-midnight-3-58"
    assert all(
        part.earliest is None or part.earliest > -86401 for part in find_times(text, first).requirements
    )


@given(st.sampled_from(sorted(available_timezones())), DECADES)
def test_the_next_noon_is_noon_within_a_day_in_every_zone(zone: str, moment: datetime) -> None:
    now = moment.replace(microsecond=0, tzinfo=ZoneInfo(zone))
    found = at("at noon", now)
    # A zone may skip its noon, or repeat an hour.
    assert (found.hour, found.minute) == (12, 0) or found.utcoffset() != now.utcoffset()
    assert timedelta(0) <= found.astimezone(UTC) - now.astimezone(UTC) <= timedelta(hours=25)


@given(
    st.sampled_from(["in the morning", "tonight", "next week", "on friday", "every day at nine", "by noon"])
)
def test_a_zone_changes_no_bound_away_from_changes_of_clocks(text: str) -> None:
    naive, aware = only(text, WEDNESDAY), only(text, WEDNESDAY.replace(tzinfo=UTC))
    assert (naive.earliest, naive.latest, naive.constraint) == (
        aware.earliest,
        aware.latest,
        aware.constraint,
    )
