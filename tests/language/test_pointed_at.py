"""What is not understood, or not used, is pointed at; what is no time is not."""

from datetime import timedelta

import pytest

from fuzzytime.language import RemarkKind
from language.reading import NOW, language

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "text",
    [
        "turn the grill on for the last five minutes",
        "in the last 5 minutes add the peas",
        "baste the duck every 20 minutes for the last hour",
        "paint the gate. Turn the lights on for the last hour",
    ],
)
def test_the_end_of_nothing_that_was_said_is_pointed_at(text: str) -> None:
    (remark,) = language().read(text, now=NOW).remarks
    assert remark.kind is RemarkKind.NOT_UNDERSTOOD
    assert "is the end of something" in remark.message


@pytest.mark.parametrize(
    ("text", "said", "meant"),
    [
        ("stir the soup soo", "soo", "soon"),
        ("call mum laterr, then eat", "laterr", "later"),
        ("call mum tonigh", "tonigh", "tonight"),
    ],
)
def test_a_slip_where_a_time_stands_is_pointed_at(text: str, said: str, meant: str) -> None:
    messages = [remark.message for remark in language().read(text, now=NOW).remarks]
    assert f"{said!r} is no time that is known: did you mean {meant!r}?" in messages


@pytest.mark.parametrize(
    "text", ["water the plants late", "the soo line is shut, call Ann at noon", "call Soo"]
)
def test_a_word_that_looks_like_a_slip_elsewhere_is_not_pointed_at(text: str) -> None:
    assert not [r for r in language().read(text, now=NOW).remarks if "did you mean" in r.message]


@pytest.mark.parametrize(
    "text",
    [
        "give dad his morning tablets after lunch",
        "give everyone evening tablets at noon",
        "bring evening snacks before noon",
        "put the vase on the 18th century table",
    ],
)
def test_a_word_about_time_that_names_a_thing_is_not_pointed_at(text: str) -> None:
    assert language().read(text, now=NOW).remarks == ()


def test_a_date_of_what_is_named_is_pointed_at() -> None:
    text = "book a flight for the ninth returning the sixteenth"
    (remark,) = language().read(text, now=NOW).remarks
    assert remark.kind is RemarkKind.NOT_UNDERSTOOD
    assert text[slice(*remark.span)] == "the sixteenth"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("strip the wall and paint by noon", "'paint' is taken for a thing: say 'then' before it"),
        (
            "once the paint and varnish dry, sand the edges",
            "'once the paint and varnish dry' says when, and is",
        ),
    ],
)
def test_what_is_left_open_or_not_understood_is_said(text: str, message: str) -> None:
    (remark,) = language().read(text, now=NOW).remarks
    assert remark.message.startswith(message)


def test_a_distance_before_nothing_is_said() -> None:
    for text, words in (
        ("remind me of the trip a day before", "a day"),
        ("bake the cake the day before", "the day"),
    ):
        (remark,) = language().read(text, now=NOW).remarks
        assert remark.kind is RemarkKind.NOT_UNDERSTOOD
        assert text[slice(*remark.span)] == f"{words} before"
    told = language().read("dinner is at 7 pm, remind me an hour before", now=NOW)
    assert told.remarks == ()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("paint the fence for months", "months"),
        ("call mum at 25 o'clock", "25 o'clock"),
        ("water the plants at 27 pm", "27 pm"),
        ("paint the fence on the 31st of april", "on the 31st of april"),
        ("boil a ten minute egg", "ten minute"),
        ("put the bins out the night before", "the night before"),
        ("open the lid at noon, better still at sunrise", "at sunrise"),
        ("pack the bags the night before", "the night before"),
        ("no one leaves before 2", "no one leaves before 2"),
        ("the guests arrived at six", "the guests arrived at six"),
        ("in no time the tent was up", "in no time the tent was up"),
        ("open the gate after 6 pm near the pool by 5 pm today", "by 5 pm today"),
        ("switch the pump off at 6 pm near the pool at 8 pm", "at 8 pm"),
        ("boil it for 1 minute less than the packet says", "1 minute"),
        ("turn the roast halfway through", "halfway through"),
        ("stir the soup half past soon", "half past"),
        ("stir the soup now and then", "now and then"),
        ("stir the soup every now and then", "every now and then"),
        ("top up the water as needed", "as needed"),
        ("log the temperature twice per shift", "twice per"),
        ("rest the steak for half as long as you cooked it", "for half as long as"),
        ("row four lots with ninety seconds' rest", "ninety seconds"),
        ("switch the pump off by 6 pm today near the pool at 8 pm", "at 8 pm"),
        ("water the plants from time to time", "from time to time"),
        ("leave the heating off until further notice", "until further notice"),
        ("let it cool for a bit", "for a bit"),
        ("wait a while then slice it", "a while"),
        ("what should I do next?", "what should I do next"),
        ("when does the soup start?", "when does the soup start"),
        ("is the soup ready?", "is the soup ready"),
        ("Koche die Suppe", "Koche die Suppe"),
        ("stelle den Topf auf den Herd", "stelle den Topf auf den Herd"),
    ],
)
def test_words_that_look_like_time_and_are_none_are_pointed_at(text: str, words: str) -> None:
    reading = language().read(text, now=NOW)
    pointed = [text[slice(*r.span)] for r in reading.remarks if r.kind is RemarkKind.NOT_UNDERSTOOD]
    assert pointed == [words]


@pytest.mark.parametrize(
    "text",
    [
        "invite June and April to dinner",
        "iron the Sunday dress",
        "visit the 24-hour shop",
        "sort the bills by month",
        "put the notes in between the pages",
    ],
)
def test_words_that_belong_to_a_name_or_a_noun_are_not_pointed_at(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert reading.remarks == ()
    assert reading.instructions[0].requirements == ()


@pytest.mark.parametrize(
    ("text", "words"),
    [("Meanwhile, feed the cat at noon", "Meanwhile"), ("water the plants in between", "in between")],
)
def test_an_order_that_follows_nothing_is_said(text: str, words: str) -> None:
    reading = language().read(text, now=NOW)
    (remark,) = reading.remarks
    assert remark.kind is RemarkKind.UNRESOLVED
    assert reading.text[slice(*remark.span)].startswith(words)


@pytest.mark.parametrize("text", ["Flip the pancakes after the pan is hot", "Ring the bell after the parade"])
def test_what_readings_may_tell_is_not_said_to_be_wrong(text: str) -> None:
    (remark,) = language().read(text, now=NOW).remarks
    assert "readings or an instruction" in remark.message


def test_an_order_that_is_not_planned_is_pointed_at() -> None:
    reading = language().read("we leave for the airport remind me", now=NOW)
    assert [reading.text[slice(*remark.span)] for remark in reading.remarks] == ["remind me"]


@pytest.mark.parametrize(
    "text",
    [
        "cut the loaf into quarters",
        "play eight days a week",
        "hug April",
        "use the 10 minute rice",
        "call Dawn after lunch",
        "in a bowl, mix flour and salt",
        "say good night at 8 pm",
        "set bedtime for 8 pm",
    ],
)
def test_what_is_called_like_a_time_is_not_pointed_at(text: str) -> None:
    assert language().read(text, now=NOW).remarks == ()


def test_words_without_a_verb_that_is_understood_are_pointed_at() -> None:
    (remark,) = language().read("on reception call duty", now=NOW).remarks
    assert "names nothing to do" in remark.message
    assert language().read("in ten minutes", now=NOW).remarks == ()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("add the stock a ladle at noon", "ladle"),
        ("remind me for tomorrow interview", "interview"),
        ("set an alarm for five o'clock labelled taxi", "taxi"),
    ],
)
def test_names_that_neither_an_operation_nor_a_time_holds_are_pointed_at(text: str, words: str) -> None:
    reading = language().read(text, now=NOW)
    unused = [text[slice(*r.span)] for r in reading.remarks if r.message.endswith("is not used")]
    assert unused == [words]


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("Clean the garage over the bank holiday weekend", ["bank holiday weekend"]),
        ("Paint the fence on bank holiday monday", ["monday"]),
        ("Paint the fence over the weekend", []),
        ("Visit the weekend market", []),
        ("Paint the room over half term", ["over half term"]),
        ("Call mum within 8 weekends", ["8 weekends"]),
        ("Plan the birthday party at six", []),
    ],
)
def test_days_that_are_not_known_are_pointed_at(text: str, left: list[str]) -> None:
    reading = language().read(text, now=NOW)
    unknown = [r for r in reading.remarks if r.message.endswith("looks like a time and was not understood")]
    assert [text[slice(*remark.span)] for remark in unknown] == left


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("load the truck H-2", ["H-2"]),
        ("T-30 open the doors", ["T-30"]),
        ("T+10 open the doors", ["T+10"]),
        ("open the doors at T minus 10", ["T minus 10"]),
        ("open the doors at t plus ten", ["t plus ten"]),
        ("buy the T plus 3 shirts", []),
        ("take vitamin D-3", []),
        ("watch T-1000 tonight", []),
        ("iron the shirts pm", []),
        ("walk the dog am & pm", []),
        ("say am or pm", []),
        ("pump at 10 ml/min", []),
    ],
)
def test_times_counted_from_what_is_not_known_are_pointed_at(text: str, left: list[str]) -> None:
    reading = language().read(text, now=NOW)
    unknown = [r for r in reading.remarks if r.message.endswith("looks like a time and was not understood")]
    assert [text[slice(*remark.span)] for remark in unknown] == left


def test_tags_in_front_of_a_line_are_not_used() -> None:
    reading = language().read("(A) call the bank at noon", now=NOW)
    (remark,) = reading.remarks
    assert (remark.kind, reading.text[slice(*remark.span)]) == (RemarkKind.POLICY, "(A)")


def test_tags_behind_a_line_are_not_used_and_none_of_its_name() -> None:
    reading = language().read("call the bank at noon #money #urgent", now=NOW)
    assert [str(one.operation.name) for one in reading.instructions if one.operation] == ["call the bank"]
    assert [reading.text[slice(*remark.span)] for remark in reading.remarks] == ["#money", "#urgent"]


def test_a_time_on_a_day_that_is_not_known_is_pointed_at() -> None:
    reading = language().read("Fetch the cake by noon the day before the christening", now=NOW)
    (remark, _) = reading.remarks
    assert (remark.kind, reading.text[slice(*remark.span)]) == (RemarkKind.UNRESOLVED, "by noon")


def test_an_end_of_a_time_that_is_not_known_is_pointed_at() -> None:
    reading = language().read("call Bob at next year's start", now=NOW)
    assert [remark.kind for remark in reading.remarks] == [RemarkKind.NOT_UNDERSTOOD]


@pytest.mark.parametrize("text", ["call bob on ethiopian new year", "call bob on parsi new year"])
def test_a_feast_of_another_calendar_is_pointed_at(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [i.requirements for i in reading.instructions] == [()]
    assert any("was not understood" in remark.message for remark in reading.remarks)


@pytest.mark.parametrize(
    ("text", "earliest"),
    [
        ("Set the alarm for twenty to six", "2026-03-05T05:40"),
        ("Soak the beans tonight, cook them in the morning", "2026-03-05T08:00"),
        ("Call mum one evening this week", "2026-03-08T18:00"),
    ],
)
def test_what_is_said_in_the_evening_is_ahead(text: str, earliest: str) -> None:
    reading = language().read(text, now=NOW + timedelta(hours=11))
    last = reading.instructions[-1].requirements[-1].earliest
    assert last is not None
    assert f"{NOW + timedelta(hours=11, seconds=last):%Y-%m-%dT%H:%M}" == earliest


@pytest.mark.parametrize(
    ("text", "verb", "object_", "time"),
    [
        (
            "text mike i'm on my way and should be there in twenty minutes",
            "text",
            "mike",
            "in twenty minutes",
        ),
        ("message june that dinner is at seven", "message", "june", "at seven"),
        ("ask dave to pick me up at half five", "ask", "dave to pick me up at half five", "at half five"),
        ("sign me up for spin class on tuesdays at six", "sign", "me", "on tuesdays at six"),
        ("delete emails older than thirty days", "delete", "emails older than", "thirty days"),
    ],
)
def test_times_of_what_is_told_or_named_are_pointed_at(text: str, verb: str, object_: str, time: str) -> None:
    reading = language().read(text, now=NOW)
    (instruction,) = reading.instructions
    operation = instruction.operation
    assert operation is not None
    assert (operation.verb, operation.object, instruction.requirements) == (verb, object_, ())
    assert [text[slice(*remark.span)] for remark in reading.remarks] == [time]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("leave the tray in room twelve at the usual time", "at the usual time"),
        ("hand out the cups at sunday's match", "at sunday's match"),
        ("post the form by friday's last collection", "by friday's last"),
        ("ring the gong at the same old time", "at the same old time"),
        ("get up at silly o'clock", "silly o'clock"),
        ("pick the plums on the first dry day", "day"),
    ],
)
def test_a_time_of_which_nothing_tells_when_it_is_is_pointed_at(text: str, said: str) -> None:
    messages = [remark.message for remark in language().read(text, now=NOW).remarks]
    assert f"{said!r} looks like a time and was not understood" in messages


@pytest.mark.parametrize(("text", "number"), [("plank 10", "10"), ("steep 5", "5"), ("simmer ten", "ten")])
def test_a_number_of_which_nothing_says_what_it_counts_is_pointed_at(text: str, number: str) -> None:
    (remark,) = language().read(text, now=NOW).remarks
    assert remark.kind is RemarkKind.NOT_UNDERSTOOD
    assert text[slice(*remark.span)] == number


@pytest.mark.parametrize("text", ["play 7", "call 911"])
def test_a_number_that_names_a_thing_is_not_pointed_at(text: str) -> None:
    assert not language().read(text, now=NOW).remarks


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("book the court 12-2", "12-2"),
        ("wash the dog 3/15", "3/15"),
        ("wash the car 15/3.", "15/3"),
        ("pay the rent 4/2026, please", "4/2026"),
        ("call mum 2026-09", "2026-09"),
        ("paint the fence, 2-4", "2-4"),
        ("check the oven every 10 till 5", "every 10"),
        ("paint the fence on my birthday", "on my birthday"),
        ("paint the fence on payday", "on payday"),
    ],
)
def test_what_may_be_a_date_or_hours_is_pointed_at(text: str, said: str) -> None:
    messages = [remark.message for remark in language().read(text, now=NOW).remarks]
    assert f"{said!r} looks like a time and was not understood" in messages


@pytest.mark.parametrize(
    "text", ["read pages 3-5", "mix it 1/3", "file invoice 10/2026", "label each one", "check on every one"]
)
def test_numbers_of_things_are_not_pointed_at(text: str) -> None:
    assert language().read(text, now=NOW).remarks == ()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("jog every weekday except holidays", "holidays"),
        ("open daily except public holidays", "public holidays"),
        ("jog every day but not on rest days", "rest days"),
        ("jog every day except for mum's birthday and feed the cat", "mum's birthday"),
    ],
)
def test_days_left_out_that_are_not_known_are_pointed_at(text: str, said: str) -> None:
    messages = [remark.message for remark in language().read(text, now=NOW).remarks]
    assert f"{said!r} looks like a time and was not understood" in messages


@pytest.mark.parametrize(
    "text", ["water the plants every day, except the cactus", "jog daily but not on sundays"]
)
def test_what_is_left_out_else_is_not_pointed_at(text: str) -> None:
    assert not [r for r in language().read(text, now=NOW).remarks if r.message.endswith("was not understood")]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("swimming at 8pm (bring towels)", "'(bring towels)' is taken as a note, and not planned"),
        ("Sam, dinner at 7pm", "'Sam' is not used"),
        ("choir at 7pm, Jo, Sam", "'Jo, Sam' names nothing to do that is understood"),
        ("call me in minutes", "'minutes' looks like a time and was not understood"),
    ],
)
def test_what_stands_beside_and_is_not_planned_is_pointed_at(text: str, message: str) -> None:
    assert [remark.message for remark in language().read(text, now=NOW).remarks] == [message]
