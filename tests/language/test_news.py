"""News of what happens: when it will be, that it will not, that it is there."""

from datetime import datetime

import pytest

from fuzzytime.language import Operation
from fuzzytime.language.about_wishes import NewsKind, news_in
from fuzzytime.language.finding import shipped_lexicon

NOW = datetime(2026, 3, 4, 15)  # noqa: DTZ001 - the tests' moment is of no zone
GUESTS = Operation(verb="come", lemma="come", span=(0, 4), object="the guests", stated=True)
TRAIN = Operation(verb="leaves", lemma="leave", span=(0, 6), object="the train", stated=True)
MEETING = Operation(verb="meeting", lemma="be", span=(0, 7), object="the meeting", stated=True)


@pytest.mark.parametrize(
    ("line", "happening", "by"),
    [
        ("the guests are ten minutes late", GUESTS, 600),
        ("the guests will be about half an hour late", GUESTS, 1800),
        ("they come an hour later", GUESTS, 3600),
        ("they're five minutes early", GUESTS, -300),
        ("the guests arrive ten minutes earlier", GUESTS, -600),
        ("sorry, the train is delayed by 20 minutes", TRAIN, 1200),
        ("the train has a delay of an hour and a half", TRAIN, 5400),
        ("the meeting was pushed back by half an hour", MEETING, 1800),
        ("the train's delayed by 20 minutes", TRAIN, 1200),
        ("the guests'll be ten minutes late", GUESTS, 600),
        ("they're coming an hour earlier", GUESTS, -3600),
        ("the meeting has been brought forward by ten minutes", MEETING, -600),
    ],
)
def test_it_is_heard_by_how_much_something_is_later(line: str, happening: Operation, by: float) -> None:
    (news,) = news_in(line, NOW, shipped_lexicon())
    assert (news.kind, news.by, news.is_of(happening, shipped_lexicon())) == (NewsKind.LATER, by, True)


@pytest.mark.parametrize(
    ("line", "happening", "at"),
    [
        ("the guests come at 7 pm", GUESTS, 4 * 3600),
        ("the guests are late, they come at 8 pm", GUESTS, 5 * 3600),
        ("they won't be here until 8 pm", GUESTS, 5 * 3600),
        ("the meeting starts at 4 pm now", MEETING, 3600),
        ("the meeting was moved to four", MEETING, 3600),
        ("the meeting is postponed until five", MEETING, 2 * 3600),
        ("it turns out the train leaves in ten minutes", TRAIN, 600),
    ],
)
def test_new_times_of_what_happens_are_heard(line: str, happening: Operation, at: float) -> None:
    *_, news = news_in(line, NOW, shipped_lexicon())
    assert news.time is not None
    assert (news.kind, news.time.t_spec, news.is_of(happening, shipped_lexicon())) == (
        NewsKind.TIME,
        at,
        True,
    )


@pytest.mark.parametrize(
    ("line", "happening", "kind"),
    [
        ("the train was cancelled", TRAIN, NewsKind.CANCELLED),
        ("the meeting is off", MEETING, NewsKind.CANCELLED),
        ("the guests aren't coming", GUESTS, NewsKind.CANCELLED),
        ("they won't come after all", GUESTS, NewsKind.CANCELLED),
        ("the guests can't come today", GUESTS, NewsKind.CANCELLED),
        ("the train's cancelled", TRAIN, NewsKind.CANCELLED),
        ("the guests are here", GUESTS, NewsKind.THERE),
        ("the guests arrived", GUESTS, NewsKind.THERE),
        ("the train left", TRAIN, NewsKind.THERE),
        ("they are home", GUESTS, NewsKind.THERE),
        ("they have arrived", GUESTS, NewsKind.THERE),
        ("the train has left", TRAIN, NewsKind.THERE),
        ("the guests are late", GUESTS, NewsKind.LATE),
        ("they are not here yet", GUESTS, NewsKind.LATE),
        ("the guests don't come at 7", GUESTS, NewsKind.LATE),
    ],
)
def test_what_becomes_of_it_is_heard(line: str, happening: Operation, kind: NewsKind) -> None:
    (news,) = news_in(line, NOW, shipped_lexicon())
    assert (news.kind, news.is_of(happening, shipped_lexicon())) == (kind, True)


@pytest.mark.parametrize(
    "line",
    [
        "call the guests at 8",
        "call mum when the guests are here",
        "set the table ten minutes before the guests come",
        "prepare the train for the guests at noon",
        "come at eight",
        "the guests left",
        "the guests' room is ready",
        "another train leaves at 9",
        "a train leaves at 9",
        "some guests come at eight",
        "the guests leave at ten",
        "the train comes every hour",
        "turn it off",
        "don't call the guests at 8",
        "serve the guests ten minutes later",
        "the guests' dinner is at eight",
    ],
)
def test_what_is_about_something_else_is_no_news(line: str) -> None:
    found = news_in(line, NOW, shipped_lexicon())
    assert not any(
        news.is_of(happening, shipped_lexicon()) for news in found for happening in (GUESTS, TRAIN, MEETING)
    )


def test_what_is_asked_for_has_no_news() -> None:
    order = Operation(verb="serve", lemma="serve", span=(0, 5), object="the soup")
    assert not any(
        news.is_of(order, shipped_lexicon())
        for news in news_in("the soup is ten minutes late", NOW, shipped_lexicon())
    )
