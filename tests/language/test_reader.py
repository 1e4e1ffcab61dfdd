"""Sentences are read as the corpus says; texts refer to those before them; what is not understood is said."""

from datetime import datetime, timedelta
from functools import cache
from typing import Any

import pytest
import yaml

from fuzzytime.errors import InstructionError
from fuzzytime.language import Instruction, Language, Operation, RemarkKind
from fuzzytime.language.meaning.recurrence import CalendarRecurrence, EvenRecurrence
from fuzzytime.language.meaning.recurrence_by_months import RecurrenceByMonths
from fuzzytime.language.meaning.recurrence_on_days import RecurrenceOnDays
from fuzzytime.requirement import Constraint, Edge, TimeRequirement
from language.corpus_rows import FOLDER, instant

pytestmark = pytest.mark.model

CORPUS = yaml.safe_load((FOLDER / "sentences.yaml").read_text("utf-8"))
NOW = instant(CORPUS["now"])
WEEK = 7 * 86400


@cache
def language() -> Language:
    return Language.shipped()


def _time(requirement: TimeRequirement, key: str) -> object:
    condition, anchor = requirement.condition, requirement.anchor
    match key:
        case "subject" | "word" if condition is not None:
            return getattr(condition, key)
        case "hedges" if condition is not None:
            return list(condition.hedges)
        case "first":
            return requirement.recurrence.occurrences(WEEK)[0] if requirement.recurrence is not None else None
        case "fuzziness":
            return list(requirement.fuzziness)
        case "target" | "lag" | "exact" | "edge":
            return getattr(anchor, key) if anchor is not None else None
        case _:
            return getattr(requirement, key)


def _said(instruction: Instruction, wanted: dict[str, Any]) -> dict[str, Any]:
    operation = instruction.operation
    found: dict[str, Any] = {}
    for key, value in wanted.items():
        match key:
            case "do":
                found[key] = operation.name if operation is not None else None
            case "to":
                found[key] = operation.addressee if operation is not None else None
            case "lemma" | "negated" | "object" | "place" | "manner" | "order" | "stated" | "attended":
                found[key] = getattr(operation, key)
            case "duration" | "alone":
                found[key] = getattr(instruction, key)
            case "next":
                series = instruction.repeats
                coming = (
                    series.coming(len(value))
                    if isinstance(
                        series, CalendarRecurrence | EvenRecurrence | RecurrenceByMonths | RecurrenceOnDays
                    )
                    else ()
                )
                found[key] = [f"{NOW + timedelta(seconds=first):%Y-%m-%dT%H:%M}" for first, _ in coming]
            case "length_of":
                found[key] = instruction.length_of and instruction.length_of.target
            case "times":
                pairs = zip(instruction.requirements, value, strict=False)
                found[key] = [
                    {name: _time(requirement, name) for name in time} for requirement, time in pairs
                ]
                found[key] += [{"text": r.text} for r in instruction.requirements[len(value) :]]
    return found


@pytest.mark.parametrize("row", CORPUS["sentences"], ids=lambda row: row["text"])
def test_a_sentence_is_read_as_its_row_says(row: dict[str, Any]) -> None:
    reading = language().read(row["text"], now=NOW)
    wanted = row["instructions"]
    assert len(reading.instructions) == len(wanted)
    assert [_said(i, w) for i, w in zip(reading.instructions, wanted, strict=True)] == wanted


def test_a_time_that_bounds_what_is_before_it_is_told_of_where_it_is_said() -> None:
    text = "Put the roast in at noon, baste it every half hour and take it out at three"
    taken = [remark for remark in language().read(text, now=NOW).remarks if "am or pm" in remark.message]
    assert [text[slice(*remark.span)] for remark in taken] == ["at three"]


def test_texts_read_together_are_read_as_alone() -> None:
    texts = [row["text"] for row in CORPUS["sentences"]]
    together = language().read_independent([(text, NOW) for text in texts])
    assert together == [language().read(text, now=NOW) for text in texts]


def test_a_later_text_refers_to_an_earlier_one() -> None:
    texts = [
        "Boil the pasta",
        "Five minutes before you serve the pasta, warm the plates",
        "After boiling the pasta, serve it",
    ]
    first, _, third = language().read_all([(text, NOW) for text in texts])
    anchor = third.instructions[0].requirements[0].anchor
    assert anchor is not None
    assert (anchor.target, anchor.edge) == (0, Edge.END)
    assert first.remarks == ()


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


@pytest.mark.parametrize("text", ["cancel the last two", "do the second one first", "skip the first one"])
def test_what_is_only_said_of_orders_asks_for_nothing(text: str) -> None:
    reading = language().read(f"call mum at five. call dad at six. {text}", now=NOW)
    assert [remark.message for remark in reading.remarks if remark.kind is RemarkKind.NOT_UNDERSTOOD] == [
        f"{text!r} is about what was asked for before: say anew what is meant"
    ]
    assert reading.instructions[-1].operation is None


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


def test_what_and_joins_to_a_denial_is_said_to_be_denied_too() -> None:
    (remark,) = language().read("don't open the lid and stir it", now=NOW).remarks
    assert remark.message == "'stir it' is taken as denied, too: what is to be done stands behind 'but'"
    assert language().read("don't open the lid or stir it", now=NOW).remarks == ()


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


def test_then_behind_nothing_but_a_denial_is_said_not_to_be_used() -> None:
    texts = ["Don't open the lid", "Then serve the soup"]
    alone, lines = language().read(". ".join(texts), now=NOW), language().read_all([(t, NOW) for t in texts])
    for remarks in (alone.remarks, lines[1].remarks):
        assert [remark.message for remark in remarks] == [
            "'Then' is not used: nothing that is to be done was said before it"
        ]


def test_what_is_later_counts_from_the_text_before() -> None:
    texts = [
        "Ten minutes later, call the bakery",
        "Put the lasagne in the oven",
        "Take it out 45 minutes later",
    ]
    first, _, third = language().read_all([(text, NOW) for text in texts])
    assert first.instructions[0].requirements[0].t_spec == 600
    anchor = third.instructions[0].requirements[0].anchor
    assert anchor is not None
    assert (anchor.target, anchor.lag, anchor.exact) == (1, 2700, True)


def test_a_distance_from_a_meal_counts_from_the_instruction_that_makes_it() -> None:
    texts = [
        "Cook dinner at seven pm",
        "Open the wine half an hour before dinner",
        "Wash up an hour after dinner",
    ]
    _, *after = language().read_all([(text, NOW) for text in texts])
    anchors = [reading.instructions[0].requirements[0].anchor for reading in after]
    assert [(a.target, a.edge, a.lag, a.exact) for a in anchors if a is not None] == [
        (0, Edge.START, -1800.0, True),
        (0, Edge.END, 3600.0, True),
    ]
    alone = language().read(texts[1], now=NOW).instructions[0].requirements[0]
    assert alone.anchor is None


def test_a_text_refers_to_a_later_one_where_none_before_is_meant() -> None:
    texts = [
        "Serve the rice after the soup is done",
        "Set the table before the soup is done",
        "Cook the soup in ten minutes",
        "Cook the soup again tomorrow",
    ]
    alone = language().read_all([(texts[0], NOW)])[0]
    assert [remark.kind for remark in alone.remarks] == [RemarkKind.UNRESOLVED]
    readings = language().read_all([(text, NOW) for text in texts])
    assert [reading.remarks for reading in readings[:2]] == [(), ()]
    again = language().read_all([(text, NOW) for text in (*texts[2:], texts[0])])
    targets = [
        requirement.anchor.target
        for reading in (*readings[:2], again[2])
        for requirement in reading.instructions[0].requirements
        if requirement.anchor is not None
    ]
    assert targets == [2, 2, 1]


def test_a_text_refers_to_what_was_given_before() -> None:
    given = [Operation(verb="boil", lemma="boil", span=(0, 4), object="the pasta")]
    reading = language().read("then drain it", now=NOW, given=given)
    operation, (requirement,) = reading.instructions[0].operation, reading.instructions[0].requirements
    assert operation is not None
    assert operation.object == "the pasta"
    assert requirement.anchor is not None
    assert requirement.anchor.target == 0


def test_an_unresolved_reference_is_said() -> None:
    reading = language().read("After setting the table, call everyone", now=NOW)
    (remark,) = reading.remarks
    assert remark.kind is RemarkKind.UNRESOLVED
    assert reading.text[slice(*remark.span)] == "After setting the table"


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


def test_each_text_has_a_moment_of_its_own() -> None:
    noon = datetime(2026, 3, 4, 12)  # noqa: DTZ001
    first, second = language().read_independent(
        [("feed the cat at one pm", NOW), ("feed the cat at one pm", noon)]
    )
    assert first.instructions[0].requirements[0].t_spec == 4 * 3600
    assert second.instructions[0].requirements[0].t_spec == 3600


def test_without_a_clock_offsets_and_vague_words_are_understood() -> None:
    reading = language().read("set the table in ten minutes, feed the cat soon", now=None)
    assert [r.constraint.value for i in reading.instructions for r in i.requirements] == ["at", "vague"]
    assert reading.remarks == ()


def test_without_a_clock_a_clock_time_is_not_guessed() -> None:
    reading = language().read("set the table at noon", now=None)
    assert reading.instructions[0].requirements == ()
    assert [(r.kind, reading.text[slice(*r.span)]) for r in reading.remarks] == [
        (RemarkKind.NOT_UNDERSTOOD, "at noon")
    ]


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
        ("wipe the bar at closing time", "closing time"),
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
    ],
)
def test_words_that_belong_to_a_name_or_a_noun_are_not_pointed_at(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert reading.remarks == ()
    assert reading.instructions[0].requirements == ()


def test_nothing_stands_for_a_time_that_counts_from_another_instruction() -> None:
    reading = language().read("Set the table. Call me at noon or after setting the table", now=NOW)
    (said,) = reading.instructions[1].requirements
    assert said.text == "at noon"
    assert [(r.kind, reading.text[slice(*r.span)]) for r in reading.remarks] == [
        (RemarkKind.POLICY, "after setting the table")
    ]


def test_an_alternative_is_asked_about_with_the_time_before_it() -> None:
    questions = language().read("call me at six or at seven", now=NOW).questions
    assert [[choice.hour for choice in question.choices] for question in questions] == [[18, 6]]


def test_an_ambiguous_time_is_a_question_with_the_choice_of_the_policy() -> None:
    (question,) = language().read("call me at six", now=NOW).questions
    assert [choice.hour for choice in question.choices] == [18, 6]
    assert question.chosen == 0


def test_vague_amounts_are_kept() -> None:
    (instruction,) = language().read("bring some food and a few screws in a bit", now=NOW).instructions
    assert [(p.text, p.noun) for p in instruction.fuzzy_parameters] == [
        ("some food", "food"),
        ("a few screws", "screws"),
    ]
    assert instruction.fuzzy_parameters[1].quantity == (2, 3, 4, 6)


def test_a_text_beyond_the_limit_is_refused() -> None:
    with pytest.raises(InstructionError, match="must not be longer than 4,000 characters, got 10,000,000"):
        language().read("a" * 10_000_000, now=NOW)


@pytest.mark.parametrize("text", ["", " ", "\n", ".", "!?", "\u202e", "\ud800", "\x00", "🍞"])
def test_a_text_without_words_gives_no_time(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [r for i in reading.instructions for r in i.requirements] == []


def test_full_width_digits_and_typographic_marks_are_read() -> None:
    reading = language().read("Feed the cat at ８：３０ pm – please", now=NOW)
    assert reading.instructions[0].requirements[0].t_spec == 11.5 * 3600


def test_an_order_that_follows_nothing_is_said() -> None:
    reading = language().read("Meanwhile, feed the cat at noon", now=NOW)
    (remark,) = reading.remarks
    assert remark.kind is RemarkKind.UNRESOLVED
    assert reading.text[slice(*remark.span)].startswith("Meanwhile")


@pytest.mark.parametrize("text", ["Flip the pancakes after the pan is hot", "Ring the bell after the parade"])
def test_what_readings_may_tell_is_not_said_to_be_wrong(text: str) -> None:
    (remark,) = language().read(text, now=NOW).remarks
    assert "readings or an instruction" in remark.message


def test_a_reference_reaches_over_many_instructions() -> None:
    between = [f"water plant number {count}" for count in range(60)]
    texts = ["peel the apples", *between, "bake the pie after you have peeled the apples", "then cool it"]
    readings = language().read_all([(text, NOW) for text in texts])
    (after,) = readings[-2].instructions[0].requirements
    assert after.anchor is not None
    assert after.anchor.target == 0
    operation = readings[-1].instructions[0].operation
    assert operation is not None
    assert operation.object == "the pie"


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
    (remark,) = language().read("on arrival call reception", now=NOW).remarks
    assert "names nothing to do" in remark.message
    assert language().read("in ten minutes", now=NOW).remarks == ()


def test_two_times_with_nothing_but_joints_between_them_are_of_one_thing() -> None:
    reading = language().read("within the next 3 hours, and within the next 5 hours", now=NOW)
    (instruction,) = reading.instructions
    assert [requirement.text for requirement in instruction.requirements] == [
        "within the next 3 hours",
        "within the next 5 hours",
    ]


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


def test_what_is_denied_behind_a_verb_does_not_turn_its_times() -> None:
    reading = language().read("Dust the shelves. Hoover the stairs after you've dusted, not before.", now=NOW)
    (after,) = reading.instructions[1].requirements
    assert after.constraint is Constraint.AFTER


def test_of_two_lengths_the_second_is_said_not_to_be_used() -> None:
    text = "Marinate the tofu at least thirty minutes, ideally two hours"
    reading = language().read(text, now=NOW)
    assert reading.instructions[0].duration == 1800.0
    assert [text[slice(*r.span)] for r in reading.remarks] == ["ideally two hours"]


def test_nothing_is_said_to_be_unused_where_all_is_read() -> None:
    texts = [row["text"] for row in CORPUS["sentences"]]
    readings = language().read_independent([(text, NOW) for text in texts])
    unused = [(r.text, m.message) for r in readings for m in r.remarks if m.message.endswith("is not used")]
    assert unused == [("Stay behind after class to tidy the art room", "'art room' is not used")]


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
    ["The call's been moved to 4", "The meeting has been moved to 4", "The lesson's been cancelled"],
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


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("Clean the garage over the bank holiday weekend", ["bank holiday weekend"]),
        ("Paint the fence on bank holiday monday", ["monday"]),
        ("Paint the fence over the weekend", []),
        ("Visit the weekend market", []),
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
        ("iron the shirts pm", ["pm"]),
        ("walk the dog am & pm", ["pm"]),
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


def test_a_time_on_a_day_that_is_not_known_is_pointed_at() -> None:
    reading = language().read("Fetch the cake by noon the day before the christening", now=NOW)
    (remark, _) = reading.remarks
    assert (remark.kind, reading.text[slice(*remark.span)]) == (RemarkKind.UNRESOLVED, "by noon")


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


def test_what_is_done_even_so_waits_for_nothing() -> None:
    reading = language().read("Call me even if it's the middle of the night", now=NOW)
    assert reading.instructions[0].requirements == ()
    assert [remark.message.endswith("all the same") for remark in reading.remarks] == [True]


@pytest.mark.parametrize("text", ["when does the shop open", "when is the next bus"])
def test_a_question_when_something_is_holds_no_time(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [i.requirements for i in reading.instructions] == [()]


@pytest.mark.parametrize("text", ["where's my next meeting?", "when's dinner?", "how's the soup?"])
def test_a_question_is_one_in_short_too(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [remark.message for remark in reading.remarks] == [f"{text[:-1]!r} asks, and says nothing to do"]


def test_an_end_of_a_time_that_is_not_known_is_pointed_at() -> None:
    reading = language().read("call Bob at next year's start", now=NOW)
    assert [remark.kind for remark in reading.remarks] == [RemarkKind.NOT_UNDERSTOOD]


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


@pytest.mark.parametrize("text", ["not until next week call the plumber", "not before 1h30 call the plumber"])
def test_what_a_time_denies_is_not_the_verb(text: str) -> None:
    call = language().read(text, now=NOW).instructions[0]
    assert [r.constraint.value for r in call.requirements] == ["after"]
    assert call.operation is not None
    assert not call.operation.negated


def test_minutes_beside_a_hedge_are_a_time() -> None:
    call = language().read("call the plumber about eleven thirty", now=NOW).instructions[0]
    assert [r.text for r in call.requirements] == ["about eleven thirty"]


@pytest.mark.parametrize("text", ["call bob on ethiopian new year", "call bob on parsi new year"])
def test_a_feast_of_another_calendar_is_pointed_at(text: str) -> None:
    reading = language().read(text, now=NOW)
    assert [i.requirements for i in reading.instructions] == [()]
    assert any("was not understood" in remark.message for remark in reading.remarks)


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


def test_otherwise_denies_the_condition_before_it() -> None:
    first, second = language().read("if the pan is hot flip it, otherwise heat the pan", now=NOW).instructions
    said = [i.requirements[0].condition for i in (first, second)]
    assert [condition is not None and condition.negated for condition in said] == [False, True]


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
