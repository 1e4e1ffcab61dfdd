"""Questions of anybody, of gaps and of ends; and what is said right behind their answers."""

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model


def _day() -> Talk:
    return talk_of(
        "call the bank at 11 for 20 minutes",
        "lunch at half past twelve for 45 minutes",
        "drops every four hours starting at 4 pm until 9 pm",
        "clean the shop at 2 pm for an hour",
    )


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        # Of anybody
        ("is Ann free at 1.30 pm for a visit?", "yes: nothing is planned at 1.30 pm"),
        ("is the boss free at eleven?", "no: s1 call the bank is from 11:00 to 11:20"),
        ("what's Ann doing at two pm?", "s4 clean the shop: 14:00 to 15:00"),
        ("could her sister come at 3.30 pm?", "of 'at 3.30 pm' no more is known than the plan:"),
        ("who's on at eleven?", "s1 call the bank: 11:00 to 11:20"),
        # Between two things
        ("what have I got on between the bank and lunch?", "nothing is planned between the bank and lunch"),
        ("is there anything between the bank and the shop?", "s2 lunch: 12:30 to 13:15"),
        ("am I free between lunch and the shop?", "free from 13:15 to 14:00"),
        # Gaps of a length
        ("have I an hour free before lunch?", "yes: 1 h fits in at 11:20, with room until 12:30"),
        ("do I have two hours spare before the bank?", "yes: 2 h fits in at 09:00"),
        ("is there a half-hour gap between the bank and lunch?", "yes: 30 min fits in at 11:20"),
        ("have I got three hours free before the bank?", "no: 3 h does not fit in before 11:00"),
        ("can I squeeze in a nap after lunch?", "a nap (30 min, assumed) fits in at 13:15"),
        ("is there time for a nap before the bank? it takes three hours", "no: a nap (3 h) does not fit in"),
        # Ends
        ("will I be home by nine pm?", "yes: all that is planned is done at 20:10"),
        ("shall we be finished by noon?", "no: all that is planned is done at 20:10"),
        ("when will the loaf be out?", "all is done at 20:10"),
        ("what's the last thing I do before the shop?", "s2 lunch: at 12:30"),
        ("what's the first thing I do after lunch?", "s4 clean the shop: at 14:00"),
        ("what do I finish with?", "drops: at 20:00"),
        ("when are the next drops?", "s3 drops: at 16:00"),
        ("when is the call with Bob?", "nothing is planned about bob; but there is:"),
        # What looks like a change
        ("does lunch have to be at noon?", "s2 lunch: at 12:30"),
        ("is lunch cancelled?", "s2 lunch: at 12:30"),
        ("has lunch been moved to one?", "s2 lunch: at 12:30"),
        ("is the call still at eleven?", "s1 call the bank: at 11:00"),
        ("is lunch an hour? it feels like two", "'it feels like two' is told beside the question"),
    ],
)
def test_a_question_is_answered_and_changes_nothing(line: str, answer: str) -> None:
    talk = _day()
    before, start = talk.entries, talk.start("s2")
    assert answer in talk.say(line)
    assert (talk.entries, talk.start("s2")) == (before, start)


def test_what_only_happens_is_not_to_be_done() -> None:
    talk = talk_of("guests come at 5 pm", "bake a cake at 10 am for an hour")
    assert talk.say("is everything done before 5 pm?") == "yes: all that is planned is done at 11:00"


def test_what_is_done_several_times_is_done_with_the_last() -> None:
    talk = talk_of("knead the dough for ten minutes, then bake it for half an hour")
    talk.wait(seconds=1)
    answer = talk.say("when will the dough be done?")
    assert answer == "s1.2 bake the dough: at 09:10, in 10 min, done at 09:40"


@pytest.mark.parametrize(
    ("asked", "taken", "wish"),
    [
        (
            "is there room for a 20 minute walk before lunch?",
            "ok pop that in",
            "walk for 20 min before lunch",
        ),
        ("have I got time to sweep the hall after lunch?", "go on, do it", "sweep the hall after lunch"),
        ("am I free at half past eleven?", "have tea then", "have tea at half past eleven"),
        ("have I a gap before the shop?", "mow the lawn in it", "mow the lawn between 13:15 and 14:00"),
        (
            "what's on between lunch and the shop?",
            "mow the lawn in that gap, ten minutes",
            "mow the lawn between 13:15 and 14:00, ten minutes",
        ),
    ],
)
def test_what_there_is_room_for_is_taken(asked: str, taken: str, wish: str) -> None:
    talk = _day()
    talk.say(asked)
    assert f"taken as: {wish}" in talk.say(taken)
    assert talk.entries[-1] == wish


@pytest.mark.parametrize(
    ("asked", "taken", "answer"),
    [
        ("have I time for a nap after lunch?", "no, don't bother", "nothing is changed"),
        ("is there room for a six hour walk before lunch?", "pop that in", "nothing was said to fit in"),
        ("when am I free?", "mow the lawn in that gap", "which gap?"),
    ],
)
def test_what_there_is_no_room_for_is_not_taken(asked: str, taken: str, answer: str) -> None:
    talk = _day()
    before = talk.entries
    talk.say(asked)
    assert answer in talk.say(taken)
    assert talk.entries == before


@pytest.mark.parametrize(
    ("line", "wish"),
    [
        ("find the statement beforehand", "find the statement before I call the bank"),
        ("note it down after that, 5 minutes", "note it down after I call the bank, 5 minutes"),
    ],
)
def test_what_was_asked_about_is_meant_behind_the_answer(line: str, wish: str) -> None:
    talk = _day()
    talk.say("when do I call the bank?")
    talk.say(line)
    assert talk.entries[-1] == wish


def test_nothing_comes_before_what_has_begun() -> None:
    talk = talk_of("lecture at eleven for an hour", "write the essay for half an hour")
    talk.wait(minutes=1)
    talk.say("print the slides beforehand, ten minutes")
    assert talk.entries[-1] == "print the slides before the lecture, ten minutes"


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("feed Rolo right after his walk", (11, 30)),
        ("feed Biscuit right after her walk", (10, 30)),
        ("stack the chairs as soon as we've finished, takes ten minutes", (15, 0)),
        ("text Jo once I'm done", (15, 0)),
    ],
)
def test_it_counts_from_whose_it_is(line: str, start: tuple[int, int]) -> None:
    talk = talk_of(
        "walk Biscuit at ten for half an hour",
        "walk Rolo at eleven for half an hour",
        "walk the spaniels at 2 pm for an hour",
        line,
    )
    begin = talk.start("s4")
    assert (begin.hour, begin.minute) == start
