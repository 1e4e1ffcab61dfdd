"""Orders and their times, where a tree alone would have them otherwise."""

import pytest

from fuzzytime.language import RemarkKind
from fuzzytime.requirement import Constraint
from language.reading import NOW, language

pytestmark = pytest.mark.model


def test_vague_amounts_are_kept() -> None:
    (instruction,) = language().read("bring some food and a few screws in a bit", now=NOW).instructions
    assert [(p.text, p.noun) for p in instruction.fuzzy_parameters] == [
        ("some food", "food"),
        ("a few screws", "screws"),
    ]
    assert instruction.fuzzy_parameters[1].quantity == (2, 3, 4, 6)


def test_full_width_digits_and_typographic_marks_are_read() -> None:
    reading = language().read("Feed the cat at ８：３０ pm – please", now=NOW)
    assert reading.instructions[0].requirements[0].t_spec == 11.5 * 3600


def test_two_times_with_nothing_but_joints_between_them_are_of_one_thing() -> None:
    reading = language().read("within the next 3 hours, and within the next 5 hours", now=NOW)
    (instruction,) = reading.instructions
    assert [requirement.text for requirement in instruction.requirements] == [
        "within the next 3 hours",
        "within the next 5 hours",
    ]


def test_a_line_before_tells_the_day_of_an_event() -> None:
    lines = [
        "The christening is on Saturday at three",
        "Fetch the cake by noon the day before the christening",
    ]
    (_, fetch) = language().read_all([(line, NOW) for line in lines])
    assert [part.t_spec for part in fetch.instructions[0].requirements] == [183600]
    assert fetch.remarks == ()


def test_a_length_in_front_of_then_is_what_is_waited() -> None:
    reading = language().read("Give it a week, then bring it back", now=NOW)
    assert [part.t_spec for part in reading.instructions[0].requirements] == [7 * 86400]
    lines = [("Send the offer", NOW), ("Give it an hour, then call the client", NOW)]
    anchor = language().read_all(lines)[1].instructions[0].requirements[0].anchor
    assert anchor is not None
    assert (anchor.target, anchor.lag, anchor.exact) == (0, 3600, True)


def test_a_length_told_of_what_is_cooked_so_long_is_left_to_it() -> None:
    lines = [("Bake the bread", NOW), ("Give it an hour, then take it out", NOW)]
    reading = language().read_all(lines)[1]
    assert reading.remarks[0].kind is RemarkKind.UNRESOLVED
    assert reading.text[slice(*reading.remarks[0].span)].startswith("Give it an hour")


def test_days_counted_from_an_event_are_whole_days() -> None:
    lines = ["The wedding is on Saturday at 3 pm", "Two days before the wedding order the flowers"]
    order = language().read_all([(line, NOW) for line in lines])[1].instructions[0]
    (day,) = order.requirements
    assert (day.constraint, day.earliest, day.latest) == (Constraint.BETWEEN, 54000, 140400)
    assert order.day_of == 0


@pytest.mark.parametrize("text", ["tomorrow at nine call the insurance", "friday at two ring the school"])
def test_a_verb_behind_a_time_in_front_is_what_is_to_be_done(text: str) -> None:
    operation = language().read(text, now=NOW).instructions[0].operation
    assert operation is not None
    assert operation.verb in {"call", "ring"}


def test_what_is_made_for_so_long_from_today_is_for_that_day() -> None:
    made = language().read("schedule a checkup for two months from today", now=NOW).instructions[0]
    away = language().read("i am away for two weeks from today", now=NOW).instructions[0]
    assert [r.earliest for r in made.requirements] == [61 * 86400 - 9 * 3600]
    assert (made.duration, away.duration) == (None, 14 * 86400)


def test_a_weather_is_like_something_on_a_day() -> None:
    asked = language().read("what's the weather like on thursday", now=NOW).instructions[0]
    assert [r.text for r in asked.requirements] == ["on thursday"]


def test_who_wants_to_be_up_is_so_in_the_morning() -> None:
    up = language().read("i want to be up by six", now=NOW).instructions[0]
    assert [r.latest for r in up.requirements] == [21 * 3600]


@pytest.mark.parametrize(
    "text",
    [
        "between two and four call the plumber",
        "between ten and half past call the plumber",
        "tomorrow between two and four call mum",
        "around six water the lawn",
        "hey olly by seven feed the cat",
        "alexa after six feed the cat",
        "can you by seven feed the cat",
        "could you please at half past six water the lawn",
        "shortly before eleven thirty call the plumber",
        "at precisely six p.m. water the lawn",
        "hey robot at 6 p.m. water the lawn",
        "at most half an hour after 1730 call the plumber",
    ],
)
def test_a_time_in_front_leaves_one_order_behind_it(text: str) -> None:
    reading = language().read(text, now=NOW)
    said = [
        (i.operation.verb, i.operation.object, len(i.requirements))
        for i in reading.instructions
        if i.operation
    ]
    assert said in (
        [("call", "the plumber", 1)],
        [("call", "mum", 1)],
        [("water", "the lawn", 1)],
        [("feed", "the cat", 1)],
    )
    assert len(reading.instructions) == 1


def test_an_order_behind_an_abbreviation_is_another() -> None:
    reading = language().read("boil the eggs at 6 p.m. add the salt", now=NOW)
    assert [i.operation.verb for i in reading.instructions if i.operation] == ["boil", "add"]


def test_minutes_beside_a_hedge_are_a_time() -> None:
    call = language().read("call the plumber about eleven thirty", now=NOW).instructions[0]
    assert [r.text for r in call.requirements] == ["about eleven thirty"]


@pytest.mark.parametrize(
    ("text", "verb", "object_"),
    [
        ("order sushi for half past seven tonight", "order", "sushi"),
        ("silence calls for two hours", "silence", "calls"),
        ("tomorrow at nine text karen", "text", "karen"),
        ("don't let me forget to post the letter this afternoon", "post", "the letter"),
        ("phone interview at ten", "interview", "phone interview"),
    ],
)
def test_orders_that_trees_have_for_nouns(text: str, verb: str, object_: str) -> None:
    (instruction,) = language().read(text, now=NOW).instructions
    operation = instruction.operation
    assert operation is not None
    assert (operation.verb, operation.object, operation.negated) == (verb, object_, False)


def test_weekdays_need_no_commas_between_them() -> None:
    set_ = language().read("set an alarm for monday wednesday and friday at six am", now=NOW).instructions
    assert [[r.earliest for r in i.requirements] for i in set_] == [[421200.0], [594000.0], [162000.0]]


def test_several_of_one_kind_need_no_comma_before_them() -> None:
    text = "set two alarms for tomorrow one at six and one at seven"
    alarms = language().read(text, now=NOW).instructions
    assert [[r.earliest for r in i.requirements] for i in alarms] == [[75600.0], [79200.0]]


def test_fillers_are_within_a_time_and_say_nothing() -> None:
    (alarm,) = language().read("set an alarm for uh seven am", now=NOW).instructions
    assert [(r.text, r.earliest) for r in alarm.requirements] == [("for uh seven am", 79200.0)]
    assert alarm.operation is not None
    assert alarm.operation.object == "an alarm"


def test_what_is_played_may_be_called_like_a_time() -> None:
    for text, times in (
        ("play jazz tomorrow", ["tomorrow"]),
        ("play tomorrow at six", ["tomorrow at six"]),
        ("text dad happy new year at midnight", ["at midnight"]),
    ):
        (instruction,) = language().read(text, now=NOW).instructions
        assert [r.text for r in instruction.requirements] == times


@pytest.mark.parametrize(
    ("text", "times"),
    [
        ("remind me every hour between nine and five to drink water", ["every hour between nine and five"]),
        ("turn the lamp on a little before sunset", ["a little before sunset"]),
        ("block out the twenty fourth until the twenty sixth", ["until the twenty sixth"]),
    ],
)
def test_a_time_ends_where_the_sentence_goes_on(text: str, times: list[str]) -> None:
    (instruction,) = language().read(text, now=NOW).instructions
    assert [r.text for r in instruction.requirements] == times


def test_days_share_the_clock_time_of_the_first() -> None:
    done = language().read("vacuum downstairs at eleven on tuesday and thursday", now=NOW).instructions
    assert [[r.earliest for r in i.requirements] for i in done] == [[525600.0], [93600.0]]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("from now on wake me at six", ["'at six'"]),
        ("starting tomorrow wake me at six", ["'at six'"]),
        ("for a week feed the fish at eight", ["'at eight'"]),
        ("for the next three days feed the cat at seven and eight", ["'at seven'", "'eight'"]),
    ],
)
def test_a_note_on_the_half_of_the_day_names_the_clock_time_once(text: str, words: list[str]) -> None:
    messages = [remark.message for remark in language().read(text, now=NOW).remarks]
    assert [message.split(" is taken as")[0] for message in messages] == words
