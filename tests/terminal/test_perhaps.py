"""What may be meant of something else is said, or asked: a second one, another person, another of several."""

import pytest

from terminal.talking import Talk, talk_of

THREE = "wash the car, mow the lawn and trim the hedge at ten"
DAY = ("gym at five", "call mum at six", "dinner with Jo at eight")


def lasts(talk: Talk) -> dict[str, float]:
    assert talk.turns.plan is not None
    return {one.identifier: one.skill.time_until_done / 60 for one in talk.turns.plan.skills}


@pytest.mark.parametrize(
    "line",
    [
        "the hedge took longer, another half an hour",
        "the hedge needs half an hour longer",
        "trim the hedge takes 35min",
        "s1.3 needs half an hour more",
        "make the hedge half an hour longer",
        "give the hedge another half an hour",
        "half an hour more for the hedge",
    ],
)
def test_a_length_is_of_the_thing_that_is_named_of_several(line: str) -> None:
    talk = talk_of(THREE)
    talk.say(line)
    assert (lasts(talk)["s1"], lasts(talk)["s1.3"]) == (30.0, 35.0)


@pytest.mark.parametrize("line", [":duration 1 35min", ":duration s1.3 35min"])
def test_which_of_several_takes_so_long_is_asked(line: str) -> None:
    talk = talk_of(THREE)
    before = lasts(talk)
    assert talk.say(line).startswith("which one takes so long: ")
    assert lasts(talk) == before


def test_what_is_not_running_is_not_what_is_done_beside_it() -> None:
    talk = talk_of(THREE)
    talk.wait(minutes=1)
    talk.say("make the car ten minutes longer")
    assert lasts(talk)["s1"] == 40.0


@pytest.mark.parametrize(
    "line",
    [
        "dishes took longer, another ten minutes",
        "the dishes took ten minutes longer",
        "the hob broke, another ten minutes",
        "the post came, ten minutes later",
    ],
)
def test_what_nothing_is_about_changes_nothing_else(line: str) -> None:
    talk = talk_of(*DAY)
    before = talk.entries, lasts(talk)
    assert talk.say(line).startswith("nothing that is planned is about ")
    assert (talk.entries, lasts(talk)) == before


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("gym at six", "gym at seven"),
        ("get the lasagne in at six", "put the lasagne in at half past six"),
        ("make the salad at six", "start the salad at seven"),
        ("incubator run at ten for an hour", "run the incubator until two"),
    ],
)
def test_a_second_one_is_told_of(first: str, second: str) -> None:
    assert "beside s1 " in talk_of(first).say(second)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("gym at six", "another gym at seven"),
        ("gym at six", "gym tomorrow at seven"),
        ("put the lasagne in at six", "take the lasagne out at seven"),
        ("feed the baby every day at six", "feed the baby at seven"),
    ],
)
def test_what_is_another_is_not(first: str, second: str) -> None:
    assert "beside" not in talk_of(first).say(second)


def test_what_is_cancelled_elsewhere_is_to_be_done() -> None:
    talk = talk_of("call mum at six")
    assert "nothing that is planned is about that" in talk.say("cancel the milk order")
    assert talk.entries == ["call mum at six", "cancel the milk order"]


def test_one_of_several_things_of_a_line_is_dropped_alone() -> None:
    talk = talk_of("gym at six and call mum at seven")
    assert "moved" not in talk.say("no gym today")
    assert talk.entries == ["call mum at seven"]


def test_who_is_meant_is_asked_where_several_come() -> None:
    talk = talk_of("Jane comes at seven", "the plumber comes at eight")
    assert talk.say("she'll be here at half eight").startswith("which one: Jane comes (s1) or ")
    talk = talk_of("Jane comes at seven", "tea at six")
    talk.wait(minutes=1)
    talk.say("she'll be here at half eight")
    assert f"{talk.start('s1'):%H:%M}" == "20:30"


@pytest.mark.parametrize(
    ("line", "entries"),
    [
        ("no gym today", DAY[1:]),
        ("actually no gym", DAY[1:]),
        ("drop s2 s1", DAY[2:]),
        (":drop 1 2", DAY[2:]),
        ("it's raining so cancel the gym", DAY[1:]),
        ("half an hour for the call", (DAY[0], "call mum at six for half an hour", DAY[2])),
        ("the gym should be at half past four", ("gym at half past four", *DAY[1:])),
        ("the gym has to be before lunch", ("gym before lunch", *DAY[1:])),
        ("the gym can move to four", ("gym at four", *DAY[1:])),
        ("it's six already", DAY),
        ("it's gone six", DAY),
        ("it's nearly six", DAY),
        ("I can't make the gym", DAY),
        ("move the gym", DAY),
        ("call mum earlier", DAY),
        ("I'm done for today", DAY),
    ],
)
def test_what_is_said_in_passing(line: str, entries: tuple[str, ...]) -> None:
    talk = talk_of(*DAY)
    talk.wait(minutes=1)
    talk.say(line)
    assert talk.entries == list(entries)


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("when do I have to leave for the gym?", "s1 gym: at 17:00"),
        ("what about dinner then?", "s3 dinner with Jo: at 20:00"),
        ("why is the call after the gym?", "s2 call mum"),
        ("what's keeping the call?", "s2 call mum"),
    ],
)
def test_questions_about_one_of_them(line: str, answer: str) -> None:
    assert talk_of(*DAY).say(line).startswith(answer)


GARDEN = ("plant the leeks at five", "clear the gutters at half past one")


@pytest.mark.parametrize(
    ("line", "entries"),
    [
        ("leeks tomorrow", ("plant the leeks tomorrow at five", GARDEN[1])),
        ("gutters at two", (GARDEN[0], "clear the gutters at two")),
        ("gutters for an hour", (GARDEN[0], f"{GARDEN[1]} for an hour")),
        ("I'll do the gutters at two", (GARDEN[0], "clear the gutters at two")),
        ("put the gutters off till two", (GARDEN[0], "clear the gutters at two")),
        ("move the leeks before the gutters", ("plant the leeks before the gutters", GARDEN[1])),
        ("the gutters first", GARDEN),
        ("everything tomorrow", GARDEN),
        ("undo everything", GARDEN),
        ("lunch at two", (*GARDEN, "lunch at two")),
    ],
)
def test_a_thing_alone_is_what_is_done_with_it(line: str, entries: tuple[str, ...]) -> None:
    talk = talk_of(*GARDEN)
    talk.wait(minutes=1)
    talk.say(line)
    assert talk.entries == list(entries)


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("table at five", "make the soup before six, set the table at five, chill the wine before six"),
        (
            "move the wine to five",
            "make the soup before six, set the table before six, chill the wine at five",
        ),
    ],
)
def test_a_time_that_several_share_stays_that_of_the_others(line: str, text: str) -> None:
    talk = talk_of("make the soup, set the table and chill the wine before six")
    talk.say(line)
    assert talk.entries == [text]


def test_what_is_put_off_in_the_morning_stays_there() -> None:
    talk = talk_of("at six mop the floor", "wash the car and feed the cat at half past nine")
    talk.say("the cat an hour later")
    assert f"{talk.start('s2.2'):%H:%M}" == "10:30"


def test_when_a_thing_is_may_be_told_without_a_preposition() -> None:
    assert talk_of("handover at eleven", "handover's ten past eleven").entries == [
        "handover at ten past eleven"
    ]


@pytest.mark.parametrize(
    "line", ["football at four till five", "meeting at 4 until 5", "gym tomorrow at four till five"]
)
def test_what_goes_on_until_an_hour_begins_at_the_other(line: str) -> None:
    talk = talk_of(line)
    assert f"{talk.start('s1'):%H:%M}" == "16:00"
    assert lasts(talk) == {"s1": 60.0}


def test_no_later_is_a_bound_and_no_correction() -> None:
    assert talk_of("call mum at six", "bedtime is half seven, no later").entries[1:] == [
        "bedtime is half seven, no later"
    ]


def test_what_is_stopped_before_it_is_told_to_have_started_is_not_told_of() -> None:
    talk = talk_of("peel the carrots", "call mum at six")
    assert "start now" not in talk.say("never mind the carrots")
    assert talk.entries == ["call mum at six"]


def test_what_is_like_something_planned_is_not_cancelled_elsewhere() -> None:
    talk = talk_of("viewing at 2 pm")
    assert "if 'viewing at 2 pm' is: drop s1" in talk.say("cancel the second viewing")
    assert "taken as something to do" in talk.say("cancel the gym membership")
    assert talk.entries == ["viewing at 2 pm", "cancel the gym membership"]
