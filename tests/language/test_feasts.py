"""Feasts fall on the days on which they were kept, and their calendars are calendars."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date, timedelta
from functools import cache
from itertools import islice, pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language.finding import shipped_lexicon
from fuzzytime.language.meaning.calendar import Days, Today
from fuzzytime.language.meaning.calendars.astronomy import moon, new_moon, new_moon_near, sun, sun_reaches
from fuzzytime.language.meaning.calendars.east_asian import CHINA, KOREA, VIETNAM, month_starts
from fuzzytime.language.meaning.calendars.easter import easter, orthodox_easter
from fuzzytime.language.meaning.calendars.hebrew import gregorian, is_leap, month_lengths, new_year
from fuzzytime.language.meaning.calendars.hindu import months_of
from fuzzytime.language.meaning.calendars.islamic import month_start
from fuzzytime.language.meaning.calendars.observance import OnDate
from fuzzytime.language.meaning.feasts import Feast, OfYear
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.policy import Policy

TODAY = Today(date(2026, 3, 4), Policy())


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
    ("ramadan", "2021-04-13 2022-04-02 2023-03-23 2024-03-11 2025-03-01 2026-02-18 2027-02-08"),
    ("eid al-fitr", "2013-08-08 2014-07-28 2015-07-17 2016-07-06 2017-06-25 2018-06-15 2019-06-04"),
    ("eid al-fitr", "2020-05-24 2021-05-13 2022-05-02 2023-04-21 2024-04-10 2025-03-30 2026-03-20"),
    ("eid al-adha", "2017-09-01 2018-08-21 2019-08-11 2020-07-31 2021-07-20 2022-07-09 2023-06-28"),
    ("eid al-adha", "2024-06-16 2025-06-06 2026-05-27"),
    ("islamic new year", "2019-08-31 2020-08-20 2021-08-09 2022-07-30 2023-07-19 2024-07-07 2025-06-26"),
    ("islamic new year", "2026-06-16"),
    ("jumu'atul-wida", "2024-04-05 2025-03-28 2026-03-13"),
    ("chinese new year", "1985-02-20 2007-02-18 2015-02-19 2016-02-08 2017-01-28 2018-02-16 2019-02-05"),
    ("chinese new year", "2020-01-25 2021-02-12 2022-02-01 2023-01-22 2024-02-10 2025-01-29 2026-02-17"),
    ("chinese new year", "2027-02-06 2028-01-26 2029-02-13 2030-02-03 2033-01-31 2034-02-19"),
    ("vietnamese new year", "1985-01-21 2007-02-17 2026-02-17 2030-02-02"),
    ("dragon boat festival", "2020-06-25 2022-06-03 2023-06-22 2024-06-10 2025-05-31 2026-06-19"),
    ("qixi", "2020-08-25 2023-08-22 2024-08-10 2025-08-29 2026-08-19"),
    ("mid-autumn festival", "2017-10-04 2020-10-01 2021-09-21 2022-09-10 2023-09-29 2024-09-17"),
    ("mid-autumn festival", "2025-10-06 2026-09-25 2033-09-08"),
    ("double ninth festival", "2023-10-23 2024-10-11 2025-10-29 2026-10-18"),
    ("laba festival", "2024-01-18 2025-01-07 2026-01-26"),
    ("qingming", "2019-04-05 2020-04-04 2023-04-05 2024-04-04 2025-04-04 2026-04-05"),
    ("dongzhi", "2023-12-22 2024-12-21 2025-12-21 2026-12-22"),
    ("vesak", "2023-06-02 2024-05-22 2025-05-12 2026-05-31"),
    ("nowruz", "2020-03-20 2021-03-21 2023-03-21 2024-03-20 2025-03-21 2026-03-21"),
    ("yalda night", "2023-12-21 2024-12-20 2025-12-21"),
    ("diwali", "2013-11-03 2014-10-23 2015-11-11 2016-10-30 2017-10-19 2018-11-07 2019-10-27 2020-11-14"),
    ("diwali", "2021-11-04 2022-10-24 2023-11-12 2024-10-31 2025-10-20 2026-11-08"),
    ("dhanteras", "2019-10-25 2020-11-13 2021-11-02 2022-10-22 2023-11-10 2024-10-29 2025-10-18"),
    ("naraka chaturdashi", "2021-11-04 2022-10-24 2023-11-12 2024-10-31 2025-10-20"),
    ("govardhan puja", "2021-11-05 2022-10-26 2023-11-14 2024-11-02 2025-10-22"),
    ("bhai dooj", "2019-10-29 2020-11-16 2021-11-06 2023-11-15 2024-11-03 2025-10-23"),
    ("holi", "2015-03-06 2016-03-24 2017-03-13 2018-03-02 2019-03-21 2020-03-10 2021-03-29 2022-03-18"),
    ("holi", "2023-03-08 2024-03-25 2025-03-14 2026-03-04"),
    ("dussehra", "2015-10-22 2016-10-11 2017-09-30 2018-10-19 2020-10-25 2021-10-15 2022-10-05"),
    ("dussehra", "2023-10-24 2024-10-12 2025-10-02"),
    ("navaratri", "2018-10-10 2019-09-29 2020-10-17 2021-10-07 2022-09-26 2023-10-15 2024-10-03"),
    ("navaratri", "2025-09-22"),
    ("durga puja", "2023-10-20 2024-10-09 2025-09-28"),
    ("raksha bandhan", "2017-08-07 2018-08-26 2019-08-15 2020-08-03 2021-08-22 2022-08-11 2023-08-30"),
    ("raksha bandhan", "2024-08-19 2025-08-09"),
    ("janmashtami", "2020-08-12 2021-08-30 2022-08-19 2023-09-07 2024-08-26 2025-08-16"),
    ("ganesh chaturthi", "2017-08-25 2018-09-13 2019-09-02 2020-08-22 2021-09-10 2022-08-31 2023-09-19"),
    ("ganesh chaturthi", "2024-09-07 2025-08-27"),
    ("rama navami", "2018-03-25 2019-04-13 2020-04-02 2021-04-21 2022-04-10 2023-03-30 2024-04-17"),
    ("ugadi", "2018-03-18 2019-04-06 2020-03-25 2021-04-13 2022-04-02 2023-03-22 2024-04-09 2025-03-30"),
    ("basant panchami", "2021-02-16 2022-02-05 2023-01-26 2024-02-14 2025-02-02"),
    ("maha shivaratri", "2018-02-13 2019-03-04 2020-02-21 2021-03-11 2022-03-01 2023-02-18 2024-03-08"),
    ("maha shivaratri", "2025-02-26"),
    ("karva chauth", "2020-11-04 2021-10-24 2022-10-13 2023-11-01 2024-10-20 2025-10-10"),
    ("chhath puja", "2021-11-10 2022-10-30 2023-11-19 2024-11-07 2025-10-27"),
    ("buddha purnima", "2021-05-26 2022-05-16 2023-05-05 2024-05-23 2025-05-12"),
    ("mahavir jayanti", "2021-04-25 2022-04-14 2023-04-04 2024-04-21 2025-04-10"),
    ("guru nanak jayanti", "2020-11-30 2021-11-19 2022-11-08 2023-11-27 2024-11-15 2025-11-05"),
    ("makar sankranti", "2019-01-15 2020-01-15 2021-01-14 2022-01-14 2023-01-15 2024-01-15 2025-01-14"),
    ("vaisakhi", "2022-04-14 2023-04-14 2024-04-13"),
    ("puthandu", "2021-04-14 2022-04-14 2023-04-14 2024-04-14 2025-04-14"),
    ("onam", "2018-08-25 2019-09-11 2020-08-31 2021-08-21 2022-09-08 2023-08-29 2024-09-15 2025-09-05"),
    ("guru ravidas jayanti", "2018-01-31 2019-02-19 2020-02-09 2023-02-05 2024-02-24 2025-02-12"),
    ("valmiki jayanti", "2018-10-24 2019-10-13 2022-10-09 2023-10-28 2024-10-17"),
    ("guru gobind singh jayanti", "2014-01-07 2017-01-05 2019-01-13 2020-01-02 2022-01-09 2025-01-06"),
    ("nag panchami", "2023-08-21 2024-08-09 2025-07-29"),
    ("boss's day", "2015-10-16 2016-10-17 2021-10-15 2026-10-16"),
    ("victoria day", "2023-05-22 2024-05-20 2025-05-19 2026-05-18"),
    ("administrative professionals' day", "2023-04-26 2024-04-24 2025-04-23 2026-04-22"),
    ("election day", "2022-11-08 2024-11-05 2026-11-03"),
    ("advent", "2023-12-03 2024-12-01 2025-11-30 2026-11-29"),
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


@pytest.mark.parametrize(("place", "angle"), [(moon, 133.16727), (sun, 22.33957)])
def test_the_sun_and_the_moon_stand_where_they_are_printed_to_stand(
    place: Callable[[float], float], angle: float
) -> None:
    # Meeus, example 47.a; the sun's from the same formulas of a higher order.
    assert place(date(1992, 4, 12).toordinal() - 59 / 86_400) == pytest.approx(angle, abs=0.002)


def test_a_new_moon_and_a_solstice_are_when_they_are_printed_to_be() -> None:
    # Meeus, examples 49.a and 27.a, there in even time.
    minute = 1 / 1440
    february = date(1977, 2, 18).toordinal() + (3 + 36.9 / 60) / 24
    assert new_moon(new_moon_near(february)) == pytest.approx(february, abs=minute)
    june = date(1962, 6, 21).toordinal() + (21 + 24.2 / 60) / 24
    assert sun_reaches(90, 1962) == pytest.approx(june, abs=minute)


YEARS = st.integers(1901, 2198)


@given(st.integers(-1200, 2400))
def test_an_islamic_month_has_29_or_30_days(number: int) -> None:
    assert month_start(number + 1) - month_start(number) in {29, 30}


@given(YEARS)
def test_eid_follows_ramadan_wherever_it_falls_in_the_year(year: int) -> None:
    for ramadan in feasts()["ramadan"].of_year(year):
        assert (ramadan.end - ramadan.first).days in {29, 30}
        ends = {days.first for near in (year, year + 1) for days in feasts()["eid al-fitr"].of_year(near)}
        assert ramadan.end in ends


def test_an_islamic_feast_may_come_twice_in_a_year() -> None:
    assert [f"{days.first}" for days in feasts()["ramadan"].of_year(2030)] == ["2030-01-05", "2030-12-26"]
    today = Today(date(2030, 1, 20), Policy())
    coming = islice(feasts()["ramadan"].upcoming(today, today.day), 3)
    assert [days.first.isoformat() for days in coming] == ["2030-01-05", "2030-12-26", "2031-12-15"]
    past = islice(feasts()["ramadan"].past(today, date(2031, 1, 1)), 2)
    assert [days.first.isoformat() for days in past] == ["2030-12-26", "2030-01-05"]


def test_eid_is_either_of_two() -> None:
    assert [f"{days.first}" for days in feasts()["eid"].of_year(2026)] == ["2026-03-20", "2026-05-27"]


@given(YEARS, st.sampled_from([CHINA, KOREA, VIETNAM]))
def test_a_lunisolar_year_has_twelve_months_and_a_thirteenth_where_it_leaps(year: int, hours: int) -> None:
    starts = [*month_starts(year, hours).values(), month_starts(year + 1, hours)[11]]
    lengths = [last - first for first, last in pairwise(starts)]
    assert list(month_starts(year, hours)) == [11, 12, *range(1, 11)]
    assert sum(lengths) in {353, 354, 355, 383, 384, 385}
    # With a leap month behind it, a month is named over both.
    assert sorted(length in {29, 30} for length in lengths)[1:] == [True] * 11
    assert date(year, 1, 20) < date.fromordinal(month_starts(year, hours)[1]) < date(year, 2, 22)


def test_the_leap_months_of_china_are_those_that_are_printed() -> None:
    for year, month in [(2020, 4), (2023, 2), (2025, 6), (2028, 5), (2031, 3), (2034, 11)]:
        starts = month_starts(year, CHINA)
        following = [*starts.values(), month_starts(year + 1, CHINA)[11]]
        lengths = dict(zip(starts, (last - first for first, last in pairwise(following)), strict=True))
        assert lengths[month] > 30


@given(YEARS)
def test_diwali_is_between_october_and_november_and_navaratri_is_before_it(year: int) -> None:
    (diwali,) = feasts()["diwali"].of_year(year)
    assert date(year, 10, 13) <= diwali.first <= date(year, 11, 19)
    (navaratri,) = feasts()["navaratri"].of_year(year)
    assert 7 <= (navaratri.end - navaratri.first).days <= 10
    assert 18 <= (diwali.first - navaratri.end).days <= 21


@given(st.integers(-1200, 2400))
def test_a_month_of_the_moon_has_one_name_unless_the_sun_enters_no_sign_or_two(number: int) -> None:
    months = [months_of(number + more) for more in range(13)]
    assert [len(names) for names in months].count(1) >= 10
    named = [name for names in months for name in names]
    assert all(second == first % 12 + 1 for first, second in pairwise(named))


@given(YEARS)
def test_a_feast_comes_every_year_or_where_the_moon_rules_alone_in_the_end(year: int) -> None:
    for name, feast in feasts().items():
        found = [*feast.of_year(year), *feast.of_year(year + 1)]
        assert found, name
        assert all(first.first < second.first for first, second in pairwise(found)), name


def test_a_year_for_which_no_moon_is_computed_is_refused() -> None:
    with pytest.raises(UngroundedError, match="known for the years 1900 to 2199, not for 2300"):
        next(OfYear(feasts()["ramadan"], 2300).upcoming(TODAY, TODAY.day))


def test_a_feast_has_its_days_in_the_first_and_the_last_year_in_which_it_is_known() -> None:
    for name, feast in feasts().items():
        for year in (feast.years[0], feast.years[-1]):
            assert all(days.first < days.end for days in feast.of_year(year)), name


def test_a_feast_is_known_where_the_one_that_it_lasts_until_is_known() -> None:
    feast = Feast("winter feast", OnDate(12, 1), until=feasts()["orthodox christmas"])
    assert feast.of_year(2026) == (Days(date(2026, 12, 1), date(2027, 1, 7)),)
    assert replace(feast, until=feasts()["diwali"]).years == range(1900, 2200)


def test_a_feast_of_several_days_ends_where_another_begins() -> None:
    assert [days.end for days in feasts()["lent"].of_year(2026)] == [date(2026, 4, 5)]
