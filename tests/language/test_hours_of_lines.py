"""Lines of a plan that together are a list of times: which numbers are hours, and of which day."""

from datetime import datetime

import pytest

from fuzzytime.language import Language
from fuzzytime.times import instant_after

pytestmark = pytest.mark.model

NOW = datetime(2026, 3, 4, 7)  # noqa: DTZ001 - a moment of no zone; a Wednesday
EVENING = NOW.replace(hour=20)

FEW = 5
"""Lines of a list."""


def _told(*lines: str) -> list[tuple[str, str]]:
    """Give what is done, and when it begins."""
    readings = Language.shipped().read_all([(line, NOW) for line in lines])
    return [
        (one.operation.name, f"{instant_after(NOW, part.earliest):%H:%M}")
        for reading in readings
        for one in reading.instructions
        for part in one.requirements
        if one.operation is not None and part.earliest is not None
    ]


def test_bullets_and_dashes_beside_hours_are_no_words() -> None:
    lines = ("- 7.30 wake Ann", "- 8 - wash the floor", "- 9.45 - Line check", "- tea 5.30", "- Supper 8")
    assert _told(*lines) == [
        ("wake Ann", "07:30"),
        ("wash the floor", "08:00"),
        ("line check", "09:45"),
        ("tea", "17:30"),
        ("Supper", "20:00"),
    ]


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("10.30 fire walk", ("fire walk", "10:30")),
        ("9.45 Line check", ("line check", "09:45")),
        ("10.15 stage build", ("stage build", "10:15")),
        ("11 - coffee", ("coffee", "11:00")),
        ("12 lunch", ("lunch", "12:00")),
        ("8 up", ("be up", "08:00")),
        ("dentist 1.20, don't be late", ("dentist", "13:20")),
        ("handover to days 2", ("handover to days", "14:00")),
        ("hand over to nights 7.45", ("hand over to nights", "07:45")),
        ("oven on 10.15", ("oven must be on", "10:15")),
        ("heating on 7.30", ("heating must be on", "07:30")),
        ("van in 8, two men", ("van in", "08:00")),
        ("10 - 12 Margaret on stall", ("Margaret on stall", "10:00")),
        ("12 - 1 lunch", ("lunch", "12:00")),
        ("boil 12 - 1", ("boil", "12:00")),
        ("1-2 stock take", ("stock take", "13:00")),
        ("room 2 - 14:30", ("room 2", "14:30")),
        ("5.30 chicken in, 1 hr 20", ("put in chicken", "17:30")),
        ("cake 8.15 (lights off!)", ("cake", "08:15")),
        ("8.10 Choir: mvts 1, 4 & 9", ("choir mvts 1, 4 & 9", "08:10")),
        ("8.10 ovens on (deck 1 + 2)", ("ovens on (deck 1 + 2)", "08:10")),
        ("8:10 second half", ("second half", "08:10")),
        ("cello lesson 4 - 4.30", ("cello lesson", "16:00")),
        ("rinse starter 8.15", ("rinse starter", "08:15")),
        ("lunch w/ Mo 12.45", ("lunch w/ Mo", "12:45")),
        ("tea about 4.15 w/ cake", ("tea w/ cake", "16:15")),
        ("bread in 8, 35 min", ("put in bread", "08:00")),
        ("washing in 4.30", ("washing must be in", "16:30")),
        ("Mrs B 7", ("Mrs B", "07:00")),
        ("call with Oslo 3.30 online", ("call with Oslo", "15:30")),
        ("Mr Singh again 2.15 shopping", ("Mr Singh again shopping", "14:15")),
        ("Mr Singh 8.00 - 30 mins", ("Mr Singh", "08:00")),
        ("beef in 10.45 - 20 min", ("put in beef", "10:45")),
        ("bread, 2.15", ("bread", "14:15")),
        ("heating 2.15", ("heating", "14:15")),
        ("bread - 2.15", ("bread", "14:15")),
        ("Bread: 2.15", ("bread", "14:15")),
        ("choir 1415 upstairs", ("choir upstairs", "14:15")),
        ("lunch 1 in the hall", ("lunch in the hall", "13:00")),
        ("(2.15) van", ("van", "14:15")),
        ("van [2.15]", ("van", "14:15")),
        ("van ... 2.15", ("van", "14:15")),
        ("**2.15** van", ("van", "14:15")),
        ("**Lunch** - 12.30", ("Lunch", "12:30")),
        ("| 2.15 | van |", ("van", "14:15")),
        ("2.15 = van", ("van", "14:15")),
        ("2.15? van", ("van", "14:15")),
        ("2.15,van", ("van", "14:15")),
        ("~2.15 van", ("van", "14:15")),
        ("2.15 (20 min) van", ("van", "14:15")),
        ("2.15 Kitchen: prep veg", ("Kitchen prep veg", "14:15")),
        ("2.15 & 3.15 van", ("van", "15:15")),
        ("van half 2", ("van", "14:30")),
        ("2.15 third sitting", ("third sitting", "14:15")),
        ("lunch 12.30 first sitting", ("lunch sitting", "12:30")),
        ("Evensong 6.00, Psalm 121", ("evensong Psalm 121", "18:00")),
        ("choir 2:15 - Jo & Sam", ("choir Jo & Sam", "14:15")),
        ("film 9pm Blade Runner 2049", ("film Blade Runner 2049", "21:00")),
    ],
)
def test_what_is_beside_an_hour_is_what_happens_then(line: str, wanted: tuple[str, str]) -> None:
    assert wanted in _told("van 9.15", line, "call Ann at 2", "tea 3.10", "wash 4.45")


@pytest.mark.parametrize("line", ["room 3.15", "Radio 3", "version 2.15", "eggs, 2"])
def test_what_is_called_or_counted_by_a_number_has_no_hour(line: str) -> None:
    assert len(_told("van 9.15", line, "call Ann at 2", "tea 3.10", "wash 4.45")) == FEW - 1


def test_what_happens_at_any_minute_makes_a_list_of_times() -> None:
    lines = ("bus 8.02", "train 8.41", "lunch 12.33", "wash 4.17", "room 3.14")
    assert [when for _, when in _told(*lines)] == ["08:02", "08:41", "12:33", "16:17"]
    assert _told("milk 1.29", "bread 1.42", "soap 2.19", "butter 2.48") == []


def test_a_number_of_minutes_from_now_is_no_hour_of_a_line() -> None:
    lines = ("van 9.15", "flip the bacon in 8", "call Ann at 2", "tea 3.10")
    assert ("flip the bacon", "07:08") in _told(*lines)


def test_below_a_title_where_no_line_says_when_a_number_counts() -> None:
    lines = (
        "Gym 9.45",
        "Lunch 12.30",
        "Tea 4",
        "Shopping:",
        "onions 3",
        "milk 2",
        "Calls:",
        "Jo 5.15",
        "Ann 6",
    )
    assert [name for name, _ in _told(*lines)] == ["Gym", "Lunch", "Tea", "Jo", "Ann"]


def test_what_somebody_gets_is_counted_by_a_number_alone() -> None:
    (shopping,) = Language.shipped().read_all([("get mince 500g, onions 3, 2 tins of toms", NOW)])
    lines = ("van 9.15", "get mince 500g, onions 3, 2 tins of toms", "bath 4.30", "tea 6", "film 8.15")
    assert not any(part.earliest for one in shopping.instructions for part in one.requirements)
    assert [when for _, when in _told(*lines)] == ["09:15", "16:30", "18:00", "20:15"]


def test_what_is_between_others_may_be_at_another_hour_than_usual() -> None:
    lines = ("emails 9.15", "gym 9.45", "party 10.30", "lunch 12.30")
    assert [when for _, when in _told(*lines)] == ["09:15", "09:45", "10:30", "12:30"]
    assert [when for _, when in _told(*lines[:-1])] == ["09:15", "09:45", "22:30"]


@pytest.mark.parametrize("title", ["Bakery", "Bakery Wed", "Wednesday:"])
def test_who_writes_a_list_at_night_begins_with_that_night(title: str) -> None:
    now = NOW.replace(hour=2, minute=30)
    lines = (title, "3.00 ovens on", "3.10 mix white tin", "egg wash 5.40", "open 7.15", "home 2")
    readings = Language.shipped().read_all([(line, now) for line in lines])
    parts = [part for reading in readings for one in reading.instructions for part in one.requirements]
    whens = [f"{instant_after(now, part.earliest):%d %H:%M}" for part in parts if part.earliest is not None]
    assert whens == ["04 03:00", "04 03:10", "04 05:40", "04 07:15", "04 14:00"]


def test_most_lines_of_a_list_may_end_in_a_number_alone() -> None:
    shopping = [f"buy thing {letter}" for letter in "abcde"]
    lines = ("van 9.15", "briefing 10.30", "tea 3.10", "wash 5", "supper 6", "news 9", *shopping)
    assert _told(*lines)[3:] == [("wash", "17:00"), ("supper", "18:00"), ("news", "21:00")]


@pytest.mark.parametrize("first", ["0600 log entry", "1745 heating on"])
def test_hours_without_marks_that_lead_most_lines_are_no_years(first: str) -> None:
    lines = (first, "1830 supper", "1945 last orders", "2000 band", "2015-2100 first dance", "raffle")
    assert [when for _, when in _told(*lines)[1:]] == ["18:30", "19:45", "20:00", "20:15"]


DAY = ("stock count at 8", "fire drill 10.15", "photos at 12:15", "coffee 3.15", "count the float")


def test_a_day_of_the_next_day_is_tomorrow() -> None:
    readings = Language.shipped().read_all([(line, EVENING) for line in DAY])
    times = [part for reading in readings for one in reading.instructions for part in one.requirements]
    begins = [instant_after(EVENING, part.earliest) for part in times if part.earliest is not None]
    assert [f"{begin:%d %H:%M}" for begin in begins] == [
        "05 08:00",
        "05 10:15",
        "05 12:15",
        "05 15:15",
        "05 00:00",
    ]
    assert [one.message for one in readings[0].remarks if "tonight" in one.message] != []


@pytest.mark.parametrize(
    "lines", [("film at 9", "bed at 11"), ("Tonight:", *DAY), ("call Ann at 9", "dentist at 3", "bins by 10")]
)
def test_what_is_of_the_evening_stays_in_it(lines: tuple[str, ...]) -> None:
    readings = Language.shipped().read_all([(line, EVENING) for line in lines])
    assert not [one for reading in readings for one in reading.remarks if "tomorrow" in one.message]


@pytest.mark.parametrize("lines", [("open the hall 7.30",), ("Tomorrow:", "open the hall 7.30")])
def test_a_deadline_behind_hours_of_tomorrow_is_on_that_day(lines: tuple[str, ...]) -> None:
    lines = (*lines, "soup on by 10", "specials out 11.40", "stock count 2.15", "coffee 4.20")
    readings = Language.shipped().read_all([(line, EVENING) for line in lines])
    (soup,) = (part for one in readings[-4].instructions for part in one.requirements)
    assert f"{instant_after(EVENING, soup.latest or 0):%d %H:%M}" == "05 10:00"


def test_what_happens_at_any_minute_needs_no_point() -> None:
    assert [when for _, when in _told("bus 8:02", "train 8:41", "lunch 12:33")] == ["08:02", "08:41", "12:33"]


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("2. [11.15] physio", ("physio", "11:15")),
        ("3) 11.15-11.30 lab talk", ("lab talk", "11:15")),
        ("4. 11.15 - taxi", ("taxi", "11:15")),
        ("4. 11.15 (15m) glaze tiles", ("glaze tiles", "11:15")),
        ("- [ ] 11.15: gas man", ("gas man", "11:15")),
        ("11:15 dentist, Sam", ("dentist Sam", "11:15")),
        ("11:15 Year 9 assembly", ("Year 9 assembly", "11:15")),
        ("raffle, 11.15, Kit", ("raffle Kit", "11:15")),
    ],
)
def test_numbers_boxes_and_fields_of_lists_leave_hours_as_they_are(
    line: str, wanted: tuple[str, str]
) -> None:
    assert wanted in _told("1. 9.15 - van", "- [ ] 10.30 wake Ann", line, "- 1.20 lunch", "5) 3.10 tea")


def test_a_number_behind_the_only_entry_of_an_hour_is_its_name() -> None:
    lines = ("9:30 group 1", "10:05 – 10:40 // Activity 2", "11:15 session 3", "12:30 lunch")
    assert [name for name, _ in _told(*lines)] == ["group 1", "Activity 2", "session 3", "lunch"]
    assert ("gym", "18:00") in _told("9.30 vet, gym 6", "11.00 bank", "12.30 lunch")


def test_hours_without_a_mark_may_have_a_colon_apart() -> None:
    lines = (
        "0900 – 0930 : Welcome",
        "0930 - 1015 : Opening talk",
        "1015 – 1030 : Morning tea",
        "1030 : Tour",
    )
    assert _told(*lines) == [
        ("welcome", "09:00"),
        ("Opening talk", "09:30"),
        ("Morning tea", "10:15"),
        ("Tour", "10:30"),
    ]


def test_hours_in_three_digits_are_hours_where_those_of_all_lines_go_up() -> None:
    morning = ("730 swim", "815 feed the twins", "900 band practice", "10 water the beans", "1145 P/U Lena")
    told = _told(*morning, "12 lunch", "130 choir", "645 supper", "800 twins to bed")
    wanted = ["07:30", "08:15", "09:00", "10:00", "11:45", "12:00", "13:30", "18:45", "20:00"]
    assert [when for _, when in told] == wanted
    # They count things where they do not.
    assert not _told("300 bricks", "120 tiles", "450 nails", "200 screws")
