"""What happens, told anew: what is tied to it goes with it, and what cannot is said."""

from collections.abc import Sequence
from datetime import timedelta

import pytest

from fuzzytime.interpreter import Plan, Request, SpokenWish, Started, plan
from fuzzytime.scheduling import Limits
from interpreter.telling import SEVEN, interpreter, listed, notes, starts

pytestmark = pytest.mark.model

STORY = (
    "the guests come at 10 am",
    "serve the soup five minutes after the guests arrive",
    "set the table 20 minutes before the guests come",
    "light the candles before the guests come",
)


def later(
    news: str, *, minutes: float = 1.0, lines: Sequence[str] = STORY, started: Sequence[Started] = ()
) -> Plan:
    """Plan lines, and what is told some minutes later, as seen from then."""
    now = SEVEN + timedelta(minutes=minutes)
    wishes = [SpokenWish(text=line, given=SEVEN) for line in lines]
    request = Request(now=now, wishes=(*wishes, SpokenWish(text=news, given=now)), started=tuple(started))
    return plan(request, interpreter(), limits=Limits())


def begun(identifier: str, minutes: float) -> Started:
    """Give a skill that took a minute, some minutes before now."""
    return Started(identifier=identifier, start=-60 * minutes, end=60 - 60 * minutes, done=60 - 60 * minutes)


@pytest.mark.parametrize(
    ("news", "expected"),
    [
        ("the guests are late, they come at half past ten", {"s1": "10:30", "s2": "10:35", "s3": "10:10"}),
        ("the guests come ten minutes later", {"s1": "10:10", "s2": "10:15", "s3": "09:50"}),
        ("the guests will be 20 minutes early", {"s1": "09:40", "s2": "09:45", "s3": "09:20"}),
        ("they come at 11 am", {"s1": "11:00", "s2": "11:05", "s3": "10:40"}),
    ],
)
def test_what_is_tied_moves_along(news: str, expected: dict[str, str]) -> None:
    made = later(news)
    assert starts(made).items() >= expected.items()
    assert len(made.skills) == len(STORY)


def test_an_open_time_is_the_one_nearest_to_the_old_one() -> None:
    made = later("they come at eight", lines=("the guests come at 7 pm",))
    assert starts(made) == {"s1": "20:00"}


def test_what_is_there_has_happened_now() -> None:
    made = later("the guests are here", minutes=30)
    assert starts(made).items() >= {"s1": "07:30", "s2": "07:35"}.items()
    assert any("set the table: its time passed" in note for note in notes(made))
    assert "light the candles: was to be done before 'the guests come', and has not been" in notes(made)
    assert "s4" in starts(made)


def test_what_is_done_is_not_missed() -> None:
    made = later("the guests are here", minutes=30, started=[begun("s4", 20), begun("s3", 10)])
    assert starts(made) == {"s1": "07:30", "s2": "07:35"}
    assert not any("has not been" in note for note in notes(made))


def test_what_is_tied_to_what_will_not_happen_is_rejected() -> None:
    made = later("the guests aren't coming")
    assert starts(made) == {}
    assert [one.identifier for one in made.skills] == ["s2", "s3", "s4"]
    assert sum("'the guests come', which will not happen" in note for note in notes(made)) == 3


def test_what_comes_after_all_is_planned_again() -> None:
    lines = (*STORY, "the guests aren't coming")
    assert starts(later("they come at 11 am", lines=lines)).items() >= {"s1": "11:00", "s2": "11:05"}.items()


def test_what_was_taken_to_have_happened_is_another() -> None:
    made = later("the guests come at half past ten", minutes=182, started=[begun("s1", 2), begun("s3", 22)])
    assert starts(made).items() >= {"s5": "10:30", "s2": "10:35"}.items()


def test_one_that_was_done_by_word_takes_the_others_along() -> None:
    lines = STORY[:2]
    now = SEVEN + timedelta(minutes=30)
    wishes = tuple(SpokenWish(text=line, given=SEVEN) for line in lines)
    here = Started(identifier="s1", start=0, end=0, done=0)
    made = plan(Request(now=now, wishes=wishes, started=(here,)), interpreter(), limits=Limits())
    assert starts(made) == {"s2": "07:35"}


def test_lateness_without_a_length_is_asked_about() -> None:
    made = later("the guests are late")
    assert starts(made)["s1"] == "10:00"
    assert any("by how much that is later" in note for note in notes(made))


def test_of_one_name_that_is_meant_which_comes_next() -> None:
    lines = ("the bus comes at 8 am", "another bus comes at 9 am")
    assert starts(later("the bus is ten minutes late", lines=lines)) == {"s1": "08:10", "s2": "09:00"}
    started = [begun("s1", 10)]
    late = later("the bus is ten minutes late", lines=lines, minutes=70, started=started)
    assert starts(late) == {"s2": "09:10"}


def test_what_is_said_at_one_moment_may_be_two() -> None:
    lines = ("the bus comes at 8 am", "the bus comes at 9 am")
    assert starts(later("wave at 10 am", lines=lines)) == {"s1": "08:00", "s2": "09:00", "s3": "10:00"}


def test_the_rest_of_a_line_is_asked_for() -> None:
    made = later("the guests are ten minutes late, call mum at 9 am")
    assert starts(made).items() >= {"s1": "10:10", "s5": "09:00"}.items()


def test_what_is_lost_beside_news_is_pointed_at() -> None:
    made = later("the bus is cancelled, the next one leaves at 11 am", lines=("the bus leaves at 10 am",))
    assert any("say it in a sentence of its own" in note for note in notes(made))


@pytest.mark.parametrize(
    ("news", "days"),
    [
        ([], "Fri Thu Sat"),
        (["the party is moved to saturday at 8 pm"], "Sat Fri Sun"),
        (["the party is cancelled"], ""),
        (["the party is cancelled", "the party is moved to saturday at 8 pm"], "Sat Fri Sun"),
    ],
)
def test_what_is_on_a_day_counted_from_it_moves_by_days(news: Sequence[str], days: str) -> None:
    lines = (
        "the party is on friday at 8 pm",
        "pack the gifts the evening before the party",
        "return the chairs at ten the morning after the party",
    )
    wishes = [
        SpokenWish(text=line, given=SEVEN + timedelta(minutes=minute))
        for minute, line in enumerate((*lines, *news))
    ]
    now = SEVEN + timedelta(minutes=len(wishes))
    made = plan(Request(now=now, wishes=tuple(wishes), horizon=8 * 86400.0), interpreter(), limits=Limits())
    found = starts(made)
    moments = dict(zip((one.identifier for one in made.skills), made.schedule.start_times, strict=True))
    assert " ".join(f"{now + timedelta(seconds=moments[name]):%a}" for name in sorted(found)) == days
    assert [found[name] for name in sorted(found)] == (["20:00", "18:30", "10:00"] if days else [])


def test_what_moves_by_days_takes_as_long_as_was_said() -> None:
    lines = (
        "the party is tomorrow at 8 pm",
        "pack the gifts the evening before the party",
        "it takes 50 minutes",
        "the party is moved to friday at 8 pm",
    )
    wishes = tuple(
        SpokenWish(text=line, given=SEVEN + timedelta(minutes=minute)) for minute, line in enumerate(lines)
    )
    now = SEVEN + timedelta(minutes=len(lines))
    made = plan(Request(now=now, wishes=wishes, horizon=8 * 86400.0), interpreter(), limits=Limits())
    (gifts,) = [one for one in made.skills if one.identifier == "s2"]
    assert gifts.skill.duration == 3000
    assert starts(made)["s2"] == "18:30"


def test_entries_with_their_hours_in_front_are_no_news_of_each_other() -> None:
    lines = ["8AM all goats are fed", "9:30-11:30AM pens mucked out, pails washed and filled"]
    made = listed([*lines, "3:00PM all goats brought in, feet checked", "5:00PM all goats skipped out"])
    assert list(starts(made).values()) == ["08:00", "09:30", "15:00", "17:00"]
