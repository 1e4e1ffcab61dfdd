"""What asks for nothing, what is denied, and what is asked."""

import pytest

from fuzzytime.language import RemarkKind
from fuzzytime.requirement import Constraint
from language.reading import NOW, language

pytestmark = pytest.mark.model


@pytest.mark.parametrize("text", ["cancel the last two", "do the second one first", "skip the first one"])
def test_what_is_only_said_of_orders_asks_for_nothing(text: str) -> None:
    reading = language().read(f"call mum at five. call dad at six. {text}", now=NOW)
    assert [remark.message for remark in reading.remarks if remark.kind is RemarkKind.NOT_UNDERSTOOD] == [
        f"{text!r} is about what was asked for before: say anew what is meant"
    ]
    assert reading.instructions[-1].operation is None


def test_what_and_joins_to_a_denial_is_said_to_be_denied_too() -> None:
    (remark,) = language().read("don't open the lid and stir it", now=NOW).remarks
    assert remark.message == "'stir it' is taken as denied, too: what is to be done stands behind 'but'"
    assert language().read("don't open the lid or stir it", now=NOW).remarks == ()


def test_then_behind_nothing_but_a_denial_is_said_not_to_be_used() -> None:
    texts = ["Don't open the lid", "Then serve the soup"]
    alone, lines = language().read(". ".join(texts), now=NOW), language().read_all([(t, NOW) for t in texts])
    for remarks in (alone.remarks, lines[1].remarks):
        assert [remark.message for remark in remarks] == [
            "'Then' is not used: nothing that is to be done was said before it"
        ]


def test_an_alternative_is_asked_about_with_the_time_before_it() -> None:
    questions = language().read("call me at six or at seven", now=NOW).questions
    assert [[choice.hour for choice in question.choices] for question in questions] == [[18, 6]]


def test_an_ambiguous_time_is_a_question_with_the_choice_of_the_policy() -> None:
    (question,) = language().read("call me at six", now=NOW).questions
    assert [choice.hour for choice in question.choices] == [18, 6]
    assert question.chosen == 0


@pytest.mark.parametrize("text", ["", " ", "\n", ".", "!?", "\u202e", "\ud800", "\x00", "🍞"])
def test_a_text_without_words_gives_no_time(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [r for i in reading.instructions for r in i.requirements] == []


def test_what_is_denied_behind_a_verb_does_not_turn_its_times() -> None:
    reading = language().read("Dust the shelves. Hoover the stairs after you've dusted, not before.", now=NOW)
    (after,) = reading.instructions[1].requirements
    assert after.constraint is Constraint.AFTER


def test_of_two_lengths_the_second_is_said_not_to_be_used() -> None:
    text = "Marinate the tofu at least thirty minutes, ideally two hours"
    reading = language().read(text, now=NOW)
    assert reading.instructions[0].duration == 1800.0
    assert [text[slice(*r.span)] for r in reading.remarks] == ["ideally two hours"]


@pytest.mark.parametrize(
    ("text", "name", "left"),
    [
        ("Serve the soup, not the salad", "serve the soup", ["salad"]),
        ("Serve the soup, not the salad, with bread", "serve the soup with bread", ["salad"]),
        ("Put it in the fridge, not in the freezer, at noon", "put it in the fridge", ["freezer"]),
        ("Call Tom, not Tim, at six", "call Tom", ["Tim"]),
    ],
)
def test_what_is_denied_beside_what_is_meant_is_not_done(text: str, name: str, left: list[str]) -> None:
    reading = language().read(text, now=NOW)
    (instruction,) = reading.instructions
    assert instruction.operation is not None
    assert instruction.operation.name == name
    unused = [text[slice(*r.span)] for r in reading.remarks if r.message.endswith("is not used")]
    assert unused == left


@pytest.mark.parametrize(
    "text", ["No calls between 12 and 1", "No lunch at noon", "There is no school on friday"]
)
def test_what_is_not_to_be_asks_for_nothing(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert all(instruction.operation is None for instruction in reading.instructions)
    assert "what is not to be" in " ".join(remark.message for remark in reading.remarks)


@pytest.mark.parametrize(
    "text", ["The call's been moved to 4", "call moved to 4pm", "The call was postponed to 4"]
)
def test_what_was_moved_happens_at_its_new_time(text: str) -> None:
    (instruction,) = language().read(text, now=NOW).instructions
    assert instruction.operation is not None
    assert instruction.operation.stated
    assert instruction.operation.name.lower().removeprefix("the ") == "call"
    assert [r.constraint for r in instruction.requirements] == [Constraint.AT]


@pytest.mark.parametrize("text", ["No later than six call mum", "No rush, call mum", "No, call mum at six"])
def test_no_alone_forbids_nothing(text: str) -> None:
    operations = [instruction.operation for instruction in language().read(text, now=NOW).instructions]
    assert [operation.name for operation in operations if operation is not None] == ["call mum"]


def test_a_number_that_counts_something_else_is_no_time() -> None:
    reading = language().read("Change the oil every 3 months or 3000 miles", now=NOW)
    assert [r.text for r in reading.instructions[0].requirements] == ["every 3 months"]
    assert [remark.message for remark in reading.remarks] == ["'3000 miles' is not used"]


@pytest.mark.parametrize(
    "text",
    ["I fed the cat at 4", "The boxes were moved at 4", "The lesson's been cancelled"],
)
def test_what_has_been_done_is_not_done_again(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert all(instruction.operation is None for instruction in reading.instructions)
    assert "tells what was" in " ".join(remark.message for remark in reading.remarks)


@pytest.mark.parametrize(
    "text", ["Merry Christmas!", "Eid Mubarak!", "Happy birthday, Anna!", "good morning", "see you tomorrow"]
)
def test_a_greeting_asks_for_nothing(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert all(instruction.operation is None for instruction in reading.instructions)
    assert "greets, and says nothing to do" in " ".join(remark.message for remark in reading.remarks)


def test_of_two_repetitions_the_second_is_said_not_to_be_used() -> None:
    reading = language().read("Scan it every two days, on weekdays", now=NOW)
    assert [reading.text[slice(*r.span)] for r in reading.remarks if "repetitions" in r.message] == [
        "on weekdays"
    ]
    both = language().read("Turn it on at six for twenty minutes every other day", now=NOW)
    assert not [remark for remark in both.remarks if "repetitions" in remark.message]


def test_what_is_done_even_so_waits_for_nothing() -> None:
    reading = language().read("Call me even if it's the middle of the night", now=NOW)
    assert reading.instructions[0].requirements == ()
    (remark,) = reading.remarks
    assert remark.kind is RemarkKind.POLICY
    assert remark.message.endswith("all the same")


@pytest.mark.parametrize("text", ["when does the shop open", "when is the next bus"])
def test_a_question_when_something_is_holds_no_time(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [i.requirements for i in reading.instructions] == [()]


@pytest.mark.parametrize("text", ["where's my next meeting?", "when's dinner?", "how's the soup?"])
def test_a_question_is_one_in_short_too(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [remark.message for remark in reading.remarks] == [f"{text[:-1]!r} asks, and says nothing to do"]


@pytest.mark.parametrize("text", ["not until next week call the plumber", "not before 1h30 call the plumber"])
def test_what_a_time_denies_is_not_the_verb(text: str) -> None:
    call = language().read(text, now=NOW).instructions[0]
    assert [r.constraint.value for r in call.requirements] == ["after"]
    assert call.operation is not None
    assert not call.operation.negated


def test_otherwise_denies_the_condition_before_it() -> None:
    first, second = language().read("if the pan is hot flip it, otherwise heat the pan", now=NOW).instructions
    said = [i.requirements[0].condition for i in (first, second)]
    assert [condition is not None and condition.negated for condition in said] == [False, True]


@pytest.mark.parametrize("text", ["I swept the yard", "we've watered the ferns"])
def test_what_was_done_without_a_time_is_pointed_at(text: str) -> None:
    assert [remark.message for remark in language().read(text, now=NOW).remarks] == [
        f"{text!r} tells what was, and says nothing to do"
    ]


def test_whom_a_sentence_without_a_comma_asks_is_kept() -> None:
    instructions = language().read("lucy dust the piano and bob mop up", now=NOW).instructions
    assert [one.operation and one.operation.addressee for one in instructions] == ["lucy", "bob"]
    reading = language().read("sarah could you feed the cat at noon", now=NOW)
    assert [
        one.operation and (one.operation.addressee, one.operation.stated) for one in reading.instructions
    ] == [("sarah", False)]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Cook dinner for seven", ["for seven"]),
        ("Cook dinner for seven at six", []),
        ("Make lunch for 30", []),
        ("Cook dinner for Ann", []),
        ("turn it up by three", ["by three"]),
        ("raise the flag by eight in the morning", []),
        ("turn it up from three to six", ["from three to six"]),
        ("rotate the table by 90", []),
    ],
)
def test_a_number_that_may_be_the_hour_is_said_to_count(text: str, said: list[str]) -> None:
    remarks = language().read(text, now=NOW).remarks
    assert [text[slice(*r.span)] for r in remarks if "is taken for how m" in r.message] == said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("buy milk 10", ["10"]),
        ("do it 1830", ["1830"]),
        ("feed cat 8", ["8"]),
        ("cat vaccination 9.45", ["9.45"]),
        ("read chapter 4", []),
        ("update Windows 11", []),
        ("milk 10 at noon", []),
        ("pick 7", []),
        ("practice piano 1730", ["1730"]),
        ("Water The Plants 7.30!", ["7.30"]),
        ("install python 3.11", []),
        ("enter code 1530", []),
        ("heating on 6.30", ["6.30"]),
        ("staff meal 4.30, 20 min", ["4.30"]),
        ("Mr Singh 8.30 - 20 mins", ["8.30"]),
        ("set the ratio to 1.25 for ten minutes", []),
        ("stir 1.50 cups of flour in for 10 minutes", []),
        ("meet in room 3.15 for an hour", []),
        ("call mum at six dressed warmly", ["at six"]),
        ("stop at six meeting points", []),
        ("raise it by ten percent", []),
        ("draw a 10 by 12 rectangle", []),
        ("wait at 10 Downing Street", []),
    ],
)
def test_an_hour_behind_a_thing_is_said_to_be_none(text: str, said: list[str]) -> None:
    remarks = language().read(text, now=NOW).remarks
    assert [text[slice(*r.span)] for r in remarks if "not taken as a time" in r.message] == said


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("don't ring before ten, she's sleeping", "she's sleeping"),
        ("close the windows, it's raining", "it's raining"),
        ("don't touch the pan, it's hot", "it's hot"),
        ("wake me at four, I'm having a nap", "I'm having a nap"),
        (
            "start the dishwasher after ten tonight, electricity is cheaper then",
            "electricity is cheaper then",
        ),
        ("call me after nine, I'm in a meeting until then", "I'm in a meeting until then"),
        ("the kettle is boiling, make the tea", "the kettle is boiling"),
        ("the traffic's bad, leave at seven", "the traffic's bad"),
        ("I'm exhausted, wake me at four", "I'm exhausted"),
    ],
)
def test_how_things_are_is_told_and_not_to_be_done(text: str, why: str) -> None:
    reading = language().read(text, now=NOW)
    asked, told = sorted(reading.instructions, key=lambda one: one.operation is None)
    assert asked.operation is not None
    assert not asked.operation.stated
    assert told.operation is None
    assert f"{why!r} tells how things are, and says nothing to do" in [r.message for r in reading.remarks]


@pytest.mark.parametrize(
    "text", ["ring at ten, she's leaving at eleven", "the guests are coming in an hour, light the fire"]
)
def test_what_is_so_at_its_own_time_happens_then(text: str) -> None:
    instructions = language().read(text, now=NOW).instructions
    assert sorted(one.operation is not None and one.operation.stated for one in instructions) == [False, True]


@pytest.mark.parametrize("text", ["Hi all,", "many thanks", "kind regards", "hello there", "Thanks!"])
def test_what_is_only_polite_is_told(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [remark.kind for remark in reading.remarks] == [RemarkKind.TOLD]
    assert all(one.operation is None for one in reading.instructions)


def test_what_is_somebodys_in_a_condition_of_nothing_asked_is_read() -> None:
    (one,) = language().read("If her dog barks, that is a mistake.", now=NOW).instructions
    assert one.operation is not None
    assert one.operation.stated
