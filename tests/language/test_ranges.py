"""Stretches of time: none ends before it begins, and what is said in two ways is said to be so."""

from datetime import datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import find_times
from fuzzytime.language.instruction import RemarkKind

WEDNESDAY = datetime(2026, 3, 4, 9)  # noqa: DTZ001
DECADES = st.datetimes(datetime(1990, 1, 1), datetime(2037, 12, 31))  # noqa: DTZ001
MINUTES = DECADES.map(lambda moment: moment.replace(second=0, microsecond=0))
SAID = st.one_of(
    MINUTES.map("{:%Y-%m-%d %H:%M}".format),
    MINUTES.map("{:%B %d %Y}".format),
    MINUTES.map("{:%B %d}".format),
    MINUTES.map("{:%B}".format),
    MINUTES.map("{:%A %H:%M}".format),
    MINUTES.map("{:%A}".format),
    MINUTES.map("{:%A %d}".format),
    MINUTES.map("{:%d %b}".format),
    MINUTES.map("{:%H:%M}".format),
    MINUTES.map("{:%I %p}".format),
    st.sampled_from(["now", "today", "tomorrow", "yesterday", "next week", "last friday", "this evening"]),
    st.sampled_from(["noon tomorrow", "easter", "the end of march", "the start of april", "next month"]),
)
JOINTS = st.sampled_from(
    ["from {} to {}", "between {} and {}", "{} - {}", "{} until {}", "since {} until {}"]
)


@given(JOINTS, SAID, SAID, MINUTES)
def test_no_stretch_ends_before_it_begins(joint: str, first: str, last: str, now: datetime) -> None:
    for requirement in find_times(joint.format(first, last), now).requirements:
        if requirement.earliest is not None and requirement.latest is not None:
            assert requirement.earliest <= requirement.latest


@given(MINUTES, st.integers(2, 400), MINUTES)
def test_typed_days_are_those_from_the_first_to_the_last(first: datetime, days: int, now: datetime) -> None:
    last = first + timedelta(days=days)
    found = find_times(f"from {first:%Y-%m-%d} to {last:%B %d, %Y}", now).requirements[0]
    assert found.earliest is not None
    assert found.latest is not None
    assert found.latest - found.earliest == (days + 1) * 86400


@pytest.mark.parametrize(
    "text",
    [
        "from tomorrow to today",
        "from next month to this month",
        "between now and yesterday",
        "from this evening until now",
        "from march 20 to march 10",
        "from 3/20 to 3/10",
        "2026-03-20 to 2026-03-10",
        "2026-03-30/2026-03-28",
        "from the end of april to the start of april",
        "in 44 BC",
        "two mondays later",
        "every monday until yesterday",
        "twice a year in march",
    ],
)
def test_what_names_no_time_is_pointed_at(text: str) -> None:
    found = find_times(text, WEDNESDAY)
    assert found.requirements == ()
    assert [remark.kind for remark in found.remarks] == [RemarkKind.NOT_UNDERSTOOD]


@pytest.mark.parametrize(
    ("text", "taken"),
    [
        ("Fri, Jul 16", "2026-07-16, which is a Thursday"),
        ("this friday-jun-15", "2026-06-15, which is a Monday"),
        ("may/22(tue)-11:30 am", "2026-05-22, which is a Friday"),
        ("tomorrow, march 7", "2026-03-07, not 2026-03-05"),
        ("in three days on friday", "2026-03-06, not 2026-03-07"),
        ("tues the 4th 7pm", "2026-08-04: none is nearer"),
        ("on 4/5", "5 April, not 4 May"),
        ("on 11/3/2027", "3 November, not 11 March"),
    ],
)
def test_days_that_do_not_agree_are_told(text: str, taken: str) -> None:
    (remark,) = find_times(text, WEDNESDAY).remarks
    assert remark.kind is RemarkKind.POLICY
    assert remark.message == f"{text!r} is taken as {taken}"


@pytest.mark.parametrize(
    "text",
    [
        "fri, jul 17",
        "on 11.3.2027",
        "on 14/3",
        "this friday (mar 6)",
        "tomorrow, march 5",
        "tuesday the 21st",
        "early in the day on friday",
    ],
)
def test_days_that_agree_need_no_telling(text: str) -> None:
    assert find_times(text, WEDNESDAY).remarks == ()


def test_a_date_is_that_of_its_weekday_where_it_has_just_passed() -> None:
    later = datetime(2018, 6, 20)  # noqa: DTZ001
    for text in ("this friday-jun-15", "this friday (jun-15)"):
        found = find_times(text, later).requirements[0]
        assert found.earliest == (datetime(2018, 6, 15) - later).total_seconds()  # noqa: DTZ001


def test_the_first_of_two_hours_is_in_the_half_of_the_day_of_the_last() -> None:
    found = find_times("every 10 minutes from 10 to 11 pm", WEDNESDAY)
    assert found.found[0].recurrence is not None
    assert found.found[0].recurrence.occurrences(86400)[0] == 13 * 3600
    assert found.remarks == ()
