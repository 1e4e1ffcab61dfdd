"""Questions about how late something may start, how long it is between two, and when there is a free hour."""

import pytest

from terminal.talking import talk_of

pytestmark = pytest.mark.model

DAY = ("paint the fence at ten for two hours", "call the bank at two", "lunch with Priya at half twelve")
ROAST = (
    "roast the beef at four for two hours",
    "make the gravy when the beef is done",
    "guests come at seven",
    "serve the beef when they're here",
)


@pytest.mark.parametrize(
    ("day", "asked", "answer"),
    [
        (
            DAY,
            "how late can I start the fence?",
            "s1 paint the fence: at 10:30 at the latest, because of s3 lunch",
        ),
        (DAY, "when do I have to start the fence at the latest?", "at 10:30 at the latest"),
        (DAY, "what's the earliest I can call the bank?", "at 13:15 at the earliest"),
        (DAY, "how early can I start the fence?", "s1 paint the fence: at once"),
        (
            DAY,
            "by when do I need to call the bank?",
            "at 14:00, and nothing else that is planned waits for it",
        ),
        (
            ROAST,
            "how late can I start the roast?",
            "s1 roast the beef: at 17:00 at the latest, because of s4 serve",
        ),
        (("call the plumber before noon",), "how late can I call the plumber?", "running, until 09:10:00"),
        (DAY, "can we do the fence later?", "by how much? Say: push it back by ten minutes"),
        (DAY, "do the fence later", "it may start at 10:30 at the latest, because of s3 lunch with Priya"),
        (DAY, "could I call the bank earlier?", "it may start at 13:15 at the earliest"),
    ],
)
def test_how_late_or_early_something_may_start_is_told(day: tuple[str, ...], asked: str, answer: str) -> None:
    talk = talk_of(*day)
    assert answer in " ".join(talk.say(asked).split())
    assert talk.entries == list(day)


@pytest.mark.parametrize(
    ("asked", "answer"),
    [
        ("how long between the fence and lunch?", "30 min, from 12:00 to 12:30"),
        ("how much time do I have between lunch and the call?", "45 min, from 13:15 to 14:00"),
        ("how long do I have after lunch?", "45 min, from 13:15 to 14:00"),
        ("what's the gap between the fence and the bank?", "with s3 lunch with Priya, 12:30 to 13:15"),
        ("when's my first free half hour?", "30 min fits in at 09:00, with room until 10:00"),
        ("when's the next gap of at least an hour?", "1 h fits in at 09:00"),
        ("do I have a free hour this afternoon?", "yes: 1 h fits in at 14:10, with room until 18:00"),
        ("have I got half an hour before lunch?", "yes: 30 min fits in"),
        ("when could I fit in a run of forty minutes?", "a run (40 min) fits in at 09:00"),
        ("can I squeeze in an hour's swim?", "yes: swim (1 h) fits in at 09:00"),
        ("is anything clashing?", "no: everything that is planned has its time"),
        ("am I on track?", "yes: everything that is planned has its time"),
        ("can I still get everything done?", "yes: everything that is planned has its time"),
        ("will it all be done by three?", "yes: all that is planned is done at 14:10"),
    ],
)
def test_questions_about_gaps_and_clashes_are_answered(asked: str, answer: str) -> None:
    assert answer in talk_of(*DAY).say(asked)


@pytest.mark.parametrize(
    ("supposed", "answer"),
    [
        ("what would happen if I skipped lunch?", "If you did that:"),
        ("what if I painted the fence at eleven?", "moved: s1 paint the fence from 10:00 to 11:00"),
        ("what if the call takes an hour?", "14:00 15:00 call the bank"),
        ("what if I didn't call the bank?", "If you did that:"),
        ("suppose I call the bank at three?", "moved: s2 call the bank from 14:00 to 15:00"),
    ],
)
def test_what_is_supposed_is_read_as_it_is_said_elsewhere(supposed: str, answer: str) -> None:
    talk = talk_of(*DAY)
    assert answer in talk.say(supposed)
    assert talk.entries == list(DAY)
