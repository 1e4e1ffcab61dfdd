"""Feasts fall on the days on which they were kept, and their calendars are calendars."""

from datetime import date, timedelta
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language.finding import shipped_lexicon
from fuzzytime.language.meaning.calendars.easter import easter, orthodox_easter
from fuzzytime.language.meaning.calendars.hebrew import gregorian, is_leap, month_lengths, new_year
from fuzzytime.language.meaning.feasts import Feast


@cache
def feasts() -> dict[str, Feast]:
    entries = (entry for found in shipped_lexicon().entries.values() for entry in found)
    return {e.value.name: e.value for e in entries if isinstance(e.value, Feast)}


def kept_on(days: str) -> list[date]:
    return [date.fromisoformat(day) for day in days.split()]


@pytest.mark.parametrize(
    ("year", "month", "day"),
    [(1954, 4, 18), (1981, 4, 19), (2000, 4, 23), (2008, 3, 23), (2011, 4, 24), (2026, 4, 5), (2038, 4, 25)],
)
def test_easter_is_that_of_published_tables(year: int, month: int, day: int) -> None:
    assert easter(year) == date(year, month, day)


@given(st.integers(1583, 4099))
def test_easter_is_a_sunday_between_its_bounds(year: int) -> None:
    found = easter(year)
    assert found.weekday() == 6
    assert date(year, 3, 22) <= found <= date(year, 4, 25)


@given(st.integers(1583, 4099))
def test_orthodox_easter_is_a_sunday_that_is_never_before_the_western(year: int) -> None:
    assert orthodox_easter(year).weekday() == 6
    assert orthodox_easter(year) >= easter(year)


KEPT = [
    ("orthodox easter", "2000-04-30 2010-04-04 2013-05-05 2016-05-01 2019-04-28 2020-04-19 2021-05-02"),
    ("orthodox easter", "2022-04-24 2023-04-16 2024-05-05 2025-04-20 2026-04-12 2027-05-02"),
    ("clean monday", "2024-03-18 2025-03-03 2026-02-23"),
    ("orthodox christmas", "2026-01-07"),
    ("rosh hashanah", "2019-09-30 2020-09-19 2021-09-07 2022-09-26 2023-09-16 2024-10-03 2025-09-23"),
    ("rosh hashanah", "2026-09-12"),
    ("yom kippur", "2023-09-25 2024-10-12 2025-10-02 2026-09-21"),
    ("sukkot", "2024-10-17 2025-10-07 2026-09-26"),
    ("simchat torah", "2023-10-08 2024-10-25 2025-10-15"),
    ("hanukkah", "2022-12-19 2023-12-08 2024-12-26 2025-12-15 2026-12-05"),
    ("tu bishvat", "2024-01-25 2025-02-13 2026-02-02"),
    ("purim", "2022-03-17 2023-03-07 2024-03-24 2025-03-14 2026-03-03"),
    ("passover", "2022-04-16 2023-04-06 2024-04-23 2025-04-13 2026-04-02 2027-04-22"),
    ("lag baomer", "2024-05-26 2025-05-16 2026-05-05"),
    ("shavuot", "2024-06-12 2025-06-02 2026-05-22"),
    ("tisha b'av", "2022-08-07 2023-07-27 2024-08-13 2025-08-03 2026-07-23"),
    ("yom hashoah", "2021-04-08 2023-04-18 2024-05-06 2025-04-24 2026-04-14"),
    ("yom haatzmaut", "2021-04-15 2022-05-05 2023-04-26 2024-05-14 2025-05-01 2026-04-22"),
    ("fast of esther", "2024-03-21 2025-03-13 2026-03-02"),
]


@pytest.mark.parametrize(("name", "days"), KEPT)
def test_a_feast_is_on_the_day_on_which_it_was_kept(name: str, days: str) -> None:
    kept = kept_on(days)
    assert [feasts()[name].of_year(day.year)[0].first for day in kept] == kept


@given(st.integers(1, 9000))
def test_a_hebrew_year_is_of_one_of_six_lengths_and_begins_on_one_of_four_weekdays(year: int) -> None:
    length = new_year(year + 1) - new_year(year)
    assert length - 30 * is_leap(year) in {353, 354, 355}
    assert sum(month_lengths(year)) == length
    assert set(month_lengths(year)) <= {29, 30}
    assert new_year(year) % 7 not in {0, 3, 5}


@given(st.integers(4000, 7000))
def test_the_days_of_a_hebrew_year_are_all_of_its_days(year: int) -> None:
    months = [*range(7, 13), *range(1, 7)]
    firsts = [gregorian(year, month, 1) for month in months]
    assert firsts == sorted(set(firsts))
    assert gregorian(year, 6, 29) + timedelta(days=1) == gregorian(year + 1, 7, 1)


def test_a_feast_of_several_days_ends_where_another_begins() -> None:
    assert [days.end for days in feasts()["lent"].of_year(2026)] == [date(2026, 4, 5)]
