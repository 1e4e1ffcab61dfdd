"""Series of days are in order, and agree with calendars known from elsewhere."""

from collections.abc import Iterator
from datetime import date, timedelta
from itertools import islice, pairwise, takewhile

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Days, Fields, Today, Weekend, moved
from fuzzytime.language.meaning.calendars.east_asian import OnEastAsianDate
from fuzzytime.language.meaning.calendars.easter import FromEaster
from fuzzytime.language.meaning.calendars.hebrew import OnHebrewDate
from fuzzytime.language.meaning.calendars.islamic import OnIslamicDate
from fuzzytime.language.meaning.calendars.observance import OnWeekday
from fuzzytime.language.meaning.days.nested import Nth, Share, WeekOf, Within
from fuzzytime.language.meaning.days.relations import Away
from fuzzytime.language.meaning.days.side_by_side import narrowed
from fuzzytime.language.meaning.feasts import Feast, Season
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import Unit

DAYS = st.dates(date(1900, 1, 1), date(2100, 1, 1))
SERIES: list[Calendar] = [
    *(Cycle(unit) for unit in (Unit.DAY, Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR)),
    Cycle(Unit.WEEK, 2),
    Cycle(Unit.YEAR, 10),
    Fields(weekday=3),
    Fields(day=31),
    Fields(month=2, day=29),
    Fields(month=5),
    Fields(day=13, weekday=4),
    Weekend(),
    Weekend(working=True),
    Feast("easter", FromEaster()),
    Feast("thanksgiving", OnWeekday(4, 3, 11)),
    Feast("last monday of may", OnWeekday(-1, 0, 5)),
    Feast("ramadan", OnIslamicDate(9, 1), until=Feast("eid al-fitr", OnIslamicDate(10, 1))),
    Feast("chinese new year", OnEastAsianDate(1, 1)),
    Feast("passover", OnHebrewDate(1, 15), lasts=8),
    Feast("lent", FromEaster(-46), until=Feast("easter", FromEaster())),
    Season("winter", (12, 21), (3, 20)),
    Nth(1, Fields(weekday=0), Cycle(Unit.MONTH)),
    Nth(-1, Cycle(Unit.WEEK), Cycle(Unit.MONTH)),
    Within(Fields(weekday=2), Cycle(Unit.MONTH)),
    Away(3, Unit.DAY, Feast("easter", FromEaster())),
    Share(0.5, 1, Cycle(Unit.MONTH)),
    WeekOf(Fields(month=10, day=7)),
]


@pytest.mark.parametrize("series", SERIES, ids=repr)
@given(day=DAYS)
def test_upcoming_periods_ascend_and_are_not_over(series: Calendar, day: date) -> None:
    found = list(islice(series.upcoming(Today(day, Policy()), day), 4))
    assert all(days.first < days.end for days in found)
    assert all(first.first < second.first for first, second in pairwise(found))
    assert isinstance(series, (Away, WeekOf)) or all(days.end > day for days in found)


@pytest.mark.parametrize("series", SERIES, ids=repr)
@given(day=DAYS)
def test_past_periods_descend_and_have_begun(series: Calendar, day: date) -> None:
    found = list(islice(series.past(Today(day, Policy()), day), 4))
    assert all(first.first > second.first for first, second in pairwise(found))
    assert isinstance(series, (Away, WeekOf)) or all(days.first < day for days in found)


@given(DAYS)
def test_the_nth_week_of_a_year_is_that_of_iso_8601(day: date) -> None:
    year, week, _ = day.isocalendar()
    whole = Nth(week, Cycle(Unit.WEEK), Fields(year=year))
    (found,) = whole.upcoming(Today(day, Policy()), day)
    assert found.first <= day < found.end


@given(
    DAYS, st.sampled_from([Unit.DAY, Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR]), st.integers(-40, 40)
)
def test_moving_is_in_order(day: date, unit: Unit, count: int) -> None:
    assert (moved(day, unit, count) >= day) == (count >= 0)
    assert moved(day, unit, count + 1) > moved(day, unit, count) - timedelta(days=1)


def test_the_last_day_stands_for_a_day_that_a_month_lacks() -> None:
    assert moved(date(2026, 1, 31), Unit.MONTH, 1) == date(2026, 2, 28)
    assert moved(date(2024, 2, 29), Unit.YEAR, 1) == date(2025, 2, 28)


def test_two_expressions_side_by_side_are_one_where_they_go_together() -> None:
    assert narrowed(Fields(weekday=1), Fields(day=19)) == Fields(day=19, weekday=1)
    assert narrowed(Fields(month=3), Fields(month=4)) is None
    assert narrowed(Cycle(Unit.WEEK), Fields(weekday=1)) == Within(Fields(weekday=1), Cycle(Unit.WEEK))


@pytest.mark.parametrize("series", SERIES, ids=repr)
@given(day=DAYS, length=st.integers(1, 900))
def test_periods_between_two_days_are_the_upcoming_ones_up_to_the_second(
    series: Calendar, day: date, length: int
) -> None:
    today, end = Today(day, Policy()), day + timedelta(days=length)
    expected = takewhile(lambda days: days.first < end, series.upcoming(today, day))
    assert list(series.between(today, day, end)) == list(expected)


class _Counted(Cycle):
    """Every day, with a note of how many were asked for."""

    asked = 0

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        for days in super().upcoming(today, since):
            type(self).asked += 1
            yield days


def test_series_inside_each_other_that_never_meet_are_given_up_soon() -> None:
    today = Today(date(2026, 3, 4), Policy())
    for innermost in (Fields(month=2, day=30), Fields(month=10)):
        _Counted.asked = 0
        never: Calendar = Within(_Counted(Unit.DAY), innermost)
        for month in (3, 5, 7, 9):
            never = Within(never, Fields(month=month))
        assert next(never.upcoming(today, today.day), None) is None
        assert _Counted.asked < 10_000
