"""Times on lines of their own, which hold for the lines below."""

from datetime import datetime

import pytest

from fuzzytime.language import Language, RemarkKind
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.times import instant_after

pytestmark = pytest.mark.model

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a moment of no zone; a Wednesday
DAY = 86400.0


def _times(*lines: str) -> list[tuple[TimeRequirement, ...]]:
    """Give the times of the instructions of some lines said at one moment."""
    readings = Language.shipped().read_all([(line, NOW) for line in lines])
    return [part.requirements for reading in readings for part in reading.instructions]


def test_a_day_alone_holds_for_the_lines_below_until_the_next() -> None:
    feed, mow, church = _times(
        "Friday", "- feed the cat at 8 am", "- mow the lawn", "Saturday:", "church at 10 am"
    )
    assert [part.earliest for (part,) in (feed, mow, church)] == [
        2 * DAY - 3600,
        2 * DAY - 9 * 3600,
        3 * DAY + 3600,
    ]
    assert mow[0].text == "Friday"


def test_a_day_of_its_own_counts_more_than_that_above() -> None:
    ((call,),) = _times("Friday", "call mum tomorrow")
    assert call.text == "tomorrow"


def test_a_day_that_nothing_follows_is_a_time_alone() -> None:
    ((friday,),) = _times("on friday")
    assert friday.text == "on friday"


def test_a_bound_on_a_day_of_its_own_is_on_that_day() -> None:
    (print_it,) = _times("Saturday:", "print the programmes by noon on friday")
    assert [(part.constraint, part.latest) for part in print_it] == [(Constraint.BEFORE, 2 * DAY + 3 * 3600)]


@pytest.mark.parametrize(
    "title",
    [
        "Concert Saturday 7 March",
        "Saturday plot",
        "Sat 7 March lunch + dinner",
        "Plan for Saturday",
    ],
)
def test_a_first_line_with_a_day_heads_many_hours_whatever_it_names(title: str) -> None:
    hours = ("doors open at 10", "tea at 11.30", "lunch at 1", "bar from 6 pm", "lock up at 10 pm")
    *_, doors, tea, _, _, _ = _times(title, "order the cake by friday", *hours)
    assert [part.earliest for part in doors + tea] == [3 * DAY + 3600, 3 * DAY + 2.5 * 3600]


@pytest.mark.parametrize("title", ["Mow the lawn Saturday", "Call Ann saturday"])
def test_an_order_for_a_day_heads_no_hours(title: str) -> None:
    hours = ("doors open at 10", "tea at 11.30", "lunch at 1", "bar from 6 pm", "lock up at 10 pm")
    assert _times(title, *hours)[1][0].earliest == 3600


@pytest.mark.parametrize("line", ["Shower, pack the night before", "Oil the bike, pack Saturday."])
def test_what_is_asked_for_before_a_day_or_in_a_sentence_heads_no_hours(line: str) -> None:
    hours = ("train at 10", "tea at 11.30", "castle at 1", "boat at 3 pm", "supper at 7 pm")
    *_, train, _, _, _, _ = _times(line, *hours)
    assert train[0].earliest == 3600


def test_what_a_day_above_holds_for_is_said() -> None:
    heading, _ = Language.shipped().read_all([("Friday", NOW), ("mow the lawn", NOW)])
    assert [remark.kind for remark in heading.remarks] == [RemarkKind.POLICY]


def test_bounds_and_lengths_below_a_day_are_on_that_day() -> None:
    load, back, make = _times(
        "Friday:", "load the boxes, about two hours", "return the van by 6 pm", "make the bed in the morning"
    )
    assert [part.earliest for part in load if part.text == "Friday"] == [2 * DAY - 9 * 3600]
    assert [(part.text, part.latest) for part in back] == [("by 6 pm", 2 * DAY + 9 * 3600)]
    assert [part.earliest is not None and part.earliest > DAY for part in back] == [True]
    assert [part.latest for part in make] == [2 * DAY + 3 * 3600]


def test_a_part_of_the_day_is_of_the_day_above_it() -> None:
    vacuum, dentist = _times("Friday:", "Morning:", "vacuum the hall", "dentist at 9")
    assert [(part.text, part.latest) for part in vacuum] == [("Friday, Morning", 2 * DAY + 3 * 3600)]
    assert dentist[0].earliest == 2 * DAY


def test_a_clause_holds_for_the_lines_below_it() -> None:
    _, flowers, bake = _times(
        "The guests come at 6 pm", "Today, before the guests come:", "buy flowers", "- bake a cake"
    )
    for said in (flowers, bake):
        assert [part.constraint for part in said] == [Constraint.BETWEEN, Constraint.BEFORE]
        assert [part.anchor.target for part in said if part.anchor is not None] == [0]


def test_a_length_that_is_told_has_no_day() -> None:
    _, length = _times("Friday:", "bake the bread", "It takes an hour")[:2]
    assert [part.constraint for part in length] == [Constraint.FOR]


@pytest.mark.parametrize("line", ["Pancakes:", "Robot 1:", "Dinner:", "Lunch"])
def test_what_says_no_time_heads_nothing(line: str) -> None:
    *_, eggs = _times(line, "boil the eggs at 8 pm")
    assert [part.text for part in eggs] == ["at 8 pm"]
    assert [part.text for part in _times(line, "boil the eggs")[-1]] == []


def test_a_day_may_head_lines_with_more_words() -> None:
    (mow,) = _times("Friday in the garden:", "mow the lawn")
    assert [part.text for part in mow] == ["Friday in the garden"]


def test_a_title_with_a_day_holds_for_the_hours_below() -> None:
    get_up, dressed, leave = _times(
        "Exam day, tomorrow", "get up at 6:15", "be dressed by seven", "leave at 8"
    )
    assert [part.earliest for part in get_up + leave] == [DAY - 2.75 * 3600, DAY - 3600]
    assert [part.latest for part in dressed] == [DAY - 2 * 3600]


@pytest.mark.parametrize(
    "lines",
    [
        ("Dentist Friday", "call mum at six", "bath at seven", "bed at eight"),
        ("Dinner with Ann on friday", "call mum at six", "walk the dog at seven", "bed at eight"),
        ("Exam day, tomorrow", "wash the car", "call mum", "feed the cat at six"),
        ("Moving day: Friday", "van at 8", "pizza at 7", "call mum on saturday at six"),
        ("call Ann friday", "van at 8", "pizza at 7", "tea at four"),
    ],
)
def test_an_entry_with_a_day_is_no_title(lines: tuple[str, ...]) -> None:
    first = Language.shipped().read_all([(line, NOW) for line in lines])[0]
    assert not any("lines below it" in remark.message for remark in first.remarks)


def test_what_is_due_on_the_day_of_a_heading_is_done_on_it() -> None:
    ((bins,),) = _times("Thursday:", "put the bins out before 7 am")
    assert (bins.constraint, bins.latest) == (Constraint.BETWEEN, DAY - 2 * 3600)
    assert bins.earliest is not None
    assert bins.earliest > 0


@pytest.mark.parametrize(
    "line", ["Saturday, garden:", "Garden, Saturday:", "Saturday 7 March, garden and shed:"]
)
def test_a_title_of_several_words_gives_its_day(line: str) -> None:
    ((mow,),) = _times(line, "- mow at 11")
    assert mow.earliest == 3 * DAY + 2 * 3600


@pytest.mark.parametrize("line", ["Bakery, night shift:", "Morning round, ward 7:", "Robots, line 2:"])
def test_a_title_is_nothing_to_do(line: str) -> None:
    title, below = Language.shipped().read_all([(line, NOW), ("- boil the eggs at 12", NOW)])
    assert title.instructions == ()
    assert [remark.kind for remark in title.remarks] == [RemarkKind.POLICY]
    assert [part.earliest for one in below.instructions for part in one.requirements] == [3 * 3600]


@pytest.mark.parametrize(
    "line", ["Clean:", "Fix the fence, saturday:", "Call mum, then:", "Garden, Saturday"]
)
def test_an_order_or_an_entry_is_no_title(line: str) -> None:
    first, _ = Language.shipped().read_all([(line, NOW), ("- boil the eggs at 12", NOW)])
    assert len(first.instructions) == 1


def test_a_remark_below_a_heading_quotes_its_words() -> None:
    *_, below = Language.shipped().read_all([("Before the guests, at seven:", NOW), ("lay the table", NOW)])
    assert any(remark.message.startswith("'at seven' is taken as 19:00") for remark in below.remarks)


@pytest.mark.parametrize(
    "line", ["Tech rehearsal", "Sports day", "School run", "Stunt day 3", "Day 4 - harbour", "Day 9 of 22"]
)
def test_a_first_line_above_hours_that_only_names_something_is_a_title(line: str) -> None:
    title, *_ = Language.shipped().read_all([(t, NOW) for t in (line, "van at 10", "tea at 11", "out at 12")])
    assert title.instructions == ()
    assert [remark.message for remark in title.remarks] == [
        f"{line!r} is taken as what the lines below it are about"
    ]


@pytest.mark.parametrize("line", ["Call mum", "Feed hens", "Dentist", "Wash the van"])
def test_a_first_line_above_hours_that_may_be_an_entry_is_no_title(line: str) -> None:
    first, *_ = Language.shipped().read_all([(t, NOW) for t in (line, "van at 10", "tea at 11", "out at 12")])
    assert not any("lines below it" in remark.message for remark in first.remarks)


@pytest.mark.parametrize("line", ["Gala, Friday 80 guests", "Friday - kerb pour", "Packing list Friday"])
def test_a_title_gives_its_day_beside_what_it_names(line: str) -> None:
    *_, mow = _times(line, "van at 10", "tea at 11", "out at 12", "mow the lawn")
    assert [part.earliest for part in mow] == [2 * DAY - 9 * 3600]


@pytest.mark.parametrize("line", ["Jumble sale - Sat", "Jumble sale, sat", "Band camp (Sat)"])
def test_the_short_name_of_a_day_in_a_title_is_that_day(line: str) -> None:
    *_, mow = _times(line, "van at 10", "tea at 11", "out at 12", "mow the lawn")
    assert [part.earliest for part in mow] == [3 * DAY - 9 * 3600]


@pytest.mark.parametrize("first", ["Fri 6 - Lisbon", "Fri 6:", "Fri 6", "Fri - Lisbon"])
@pytest.mark.parametrize("second", ["Sat 7 - show day", "Sat - show day", "Sat 7"])
def test_a_line_with_a_day_and_its_date_heads_the_hours_below(first: str, second: str) -> None:
    lines = _times(first, "van at 9", "tea at 11", second, "train at 8", "lunch at 12.30", "wash the van")
    begins = [instant_after(NOW, part.earliest or 0) for (part,) in lines]
    assert [f"{begin:%d %H:%M}" for begin in begins] == [
        "06 09:00",
        "06 11:00",
        "07 08:00",
        "07 12:30",
        "07 00:00",
    ]


@pytest.mark.parametrize("line", ["Fri 9 - dentist", "Fri 6 - dentist", "Fri 6 dentist"])
def test_a_number_behind_a_day_is_its_hour_where_no_hours_are_below(line: str) -> None:
    (time,), *_ = _times(line, "buy milk", "tea at 11")
    assert time.grain is Unit.HOUR


@pytest.mark.parametrize("title", ["FRIDAY MORNING", "Friday morning:"])
def test_hours_behind_the_part_of_a_day_that_heads_them_are_of_its_day(title: str) -> None:
    lines = ("shower 6.45", "call at 10", "lunch 12.30", "school run 3.15", "choir 8")
    friday = [part.earliest for (part,) in _times(title, *lines)]
    assert friday == [2 * DAY + hour * 3600 for hour in (-2.25, 1, 3.5, 6.25, 11)]


def test_an_hour_before_the_part_of_a_day_that_heads_it_is_early() -> None:
    ((up,), (boat,)) = _times("Friday morning", "up at 4.30", "boat at 6")
    assert [up.earliest, boat.earliest] == [2 * DAY - 4.5 * 3600, 2 * DAY - 3 * 3600]


@pytest.mark.parametrize("title", ["jobs for saturday", "saturday jobs", "To-do list, Saturday"])
def test_the_name_of_a_list_heads_lines_without_hours(title: str) -> None:
    clean, told = _times(title, "clean the car", "Jess to do the bathroom")
    assert [part.earliest for (part,) in (clean, told)] == [3 * DAY - 9 * 3600] * 2


def test_a_list_that_is_to_be_made_heads_nothing() -> None:
    assert len(_times("print the rota friday", "clean the car")) == len(("print", "clean"))


def test_dates_of_lines_begin_with_the_day_where_one_surely_does() -> None:
    eyes, scan = _times("9/3 eye clinic 10:20", "17/3 scan 9:30")
    assert [part.grain for part in eyes] == [Unit.DAY, Unit.MINUTE]
    assert [part.earliest for part in (eyes[1], scan[1])] == [5 * DAY + 80 * 60, 13 * DAY + 30 * 60]


def test_an_entry_beside_its_hour_is_named_by_all_of_its_words() -> None:
    lines = ["10:00 Hair + make-up", "12:30 Florist arrives", "6:00 Supper, toasts & cake"]
    readings = Language.shipped().read_all([(line, NOW) for line in [*lines, "Cocktail hour ... 7:30pm"]])
    operations = [one.operation for reading in readings for one in reading.instructions]
    names = [None if operation is None else operation.name for operation in operations]
    assert names == ["Hair + make-up", "Florist arrives", "Supper, toasts & cake", "Cocktail hour"]
    kinds = {remark.kind for reading in readings for remark in reading.remarks}
    assert kinds <= {RemarkKind.POLICY}


@pytest.mark.parametrize("line", ["5pm. Unpack the bags", "5p-unpack the bags", "5:00 pm - Unpack the bags"])
def test_an_hour_in_front_of_a_line_is_of_what_follows(line: str) -> None:
    (reading,) = Language.shipped().read_all([(line, NOW)])
    (unpack,) = reading.instructions
    assert reading.text == line
    assert unpack.operation is not None
    assert unpack.operation.name == "unpack the bags"
    assert [time.t_spec for time in unpack.requirements] == [8 * 3600.0]


def test_a_count_of_all_is_no_hour_of_a_list() -> None:
    lines = ["9.10 - ride the mare", "9.40 - untack, turn out all 3 (two greys, one bay)", "9.50 - sweep up"]
    said = {time.text for times in _times(*lines) for time in times}
    assert said >= {"9.10", "9.40", "9.50"}
    assert "3" not in said


def test_weeks_and_days_of_a_plan_count_from_one_on() -> None:
    swim, bike, run = _times("Week One", "Tuesday: swim", "Thursday: bike", "Week 2:", "Tuesday: run")
    assert [part.earliest for (part,) in (swim, bike, run)] == [n * DAY - 9 * 3600 for n in (6, 8, 13)]
    first, rest, last = _times("Day 1: oil the chain", "Day 2: rest", "Days 3-4: true the wheels")
    assert [part.earliest for (part,) in (rest, last)] == [n * DAY - 9 * 3600 for n in (1, 2)]
    assert first[0].text == "Day 1"


def test_days_of_a_plan_count_from_the_date_of_the_first() -> None:
    _, paint = _times("Day 1 (Friday 6 March): sand the hull", "Day 2: paint it")
    assert paint[0].earliest == 3 * DAY - 9 * 3600


def test_a_week_alone_that_is_over_is_a_title_and_one_to_come_is_a_week() -> None:
    assert _times("Week 3", "jog two laps")[0] == ()
    order, sow = _times("Week 20: order seeds", "Week 21: sow the beans")
    assert (sow[0].earliest or 0) - (order[0].earliest or 0) == 7 * DAY


def test_weekdays_are_in_the_week_of_a_line_above() -> None:
    tuesday, thursday = _times("Next week:", "Tuesday: glaze the pots", "Thursday", "- fire the kiln")
    assert [tuesday[0].earliest, thursday[0].earliest] == [n * DAY - 9 * 3600 for n in (6, 8)]


def test_a_repetition_heads_the_marked_lines_below_it() -> None:
    first, second, third = _times(
        "Once a month", "- bleed the brakes", "Every two years", "- swap the tank", "- flush it"
    )
    assert (first[0].recurrence, second[0].text, third[0].text) != (
        None,
        "Every two years",
        "Every two years",
    )
    assert all(times[0].constraint is Constraint.EVERY for times in (first, second, third))


def test_what_counts_from_an_event_itself_takes_no_distance_from_above() -> None:
    leeks, beans = _times(
        "9 weeks before last frost:", "- sow leeks", "2 weeks after last frost: plant beans"
    )
    assert [len(leeks), len(beans)] == [1, 1]


def test_an_hour_goes_on_with_the_day_that_a_line_above_begins_with() -> None:
    walk, boat, home, tea = _times(
        "Sat - castle at ten", "boat trip 2.30", "Sun 11am: drive home", "tea at 5"
    )
    assert [max(time.earliest or 0 for time in several) for several in (walk, boat, home, tea)] == [
        3 * DAY + 3600,
        3 * DAY + 5.5 * 3600,
        4 * DAY + 2 * 3600,
        4 * DAY + 8 * 3600,
    ]
    # One line with its day is one among others.
    _, tea = _times("Sat - castle at ten", "tea at 5")
    assert [time.earliest for time in tea] == [8 * 3600]
