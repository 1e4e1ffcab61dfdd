"""Sentences are read as the corpus says; texts refer to those before them; what is not understood is said."""

from datetime import datetime, timedelta
from typing import Any

import pytest

from fuzzytime.errors import InstructionError
from fuzzytime.language import Instruction, Language, Operation, RemarkKind
from fuzzytime.language.meaning.recurrences.recurrence import CalendarRecurrence, EvenRecurrence
from fuzzytime.language.meaning.recurrences.recurrence_by_months import RecurrenceByMonths
from fuzzytime.language.meaning.recurrences.recurrence_on_days import RecurrenceOnDays
from fuzzytime.requirement import Edge, TimeRequirement
from language.corpus_rows import sentences
from language.reading import NOW, language

pytestmark = pytest.mark.model

WEEK = 7 * 86400


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
            case (
                "lemma"
                | "negated"
                | "object"
                | "place"
                | "manner"
                | "purpose"
                | "order"
                | "stated"
                | "attended"
            ):
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


@pytest.mark.parametrize("row", sentences(), ids=lambda row: row["text"])
def test_a_sentence_is_read_as_its_row_says(row: dict[str, Any]) -> None:
    reading = language().read(row["text"], now=NOW)
    wanted = row["instructions"]
    assert len(reading.instructions) == len(wanted)
    assert [_said(i, w) for i, w in zip(reading.instructions, wanted, strict=True)] == wanted
    left = [row["text"][slice(*r.span)] for r in reading.remarks if r.message.endswith("is not used")]
    assert left == row.get("unused", [])


def test_a_time_that_bounds_what_is_before_it_is_told_of_where_it_is_said() -> None:
    text = "Put the roast in at noon, baste it every half hour and take it out at three"
    taken = [remark for remark in language().read(text, now=NOW).remarks if "am or pm" in remark.message]
    assert [text[slice(*remark.span)] for remark in taken] == ["at three"]


def test_texts_read_together_are_read_as_alone() -> None:
    texts = [row["text"] for row in sentences()[:: len(sentences()) // 400]]
    together = language().read_independent([(text, NOW) for text in texts])
    # What another language was asked for before is not remembered.
    alone = Language.shipped()
    assert together == [alone.read(text, now=NOW) for text in texts]


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


def test_nothing_stands_for_a_time_that_counts_from_another_instruction() -> None:
    reading = language().read("Set the table. Call me at noon or after setting the table", now=NOW)
    (said,) = reading.instructions[1].requirements
    assert said.text == "at noon"
    assert [(r.kind, reading.text[slice(*r.span)]) for r in reading.remarks] == [
        (RemarkKind.POLICY, "after setting the table")
    ]


def test_a_text_beyond_the_limit_is_refused() -> None:
    with pytest.raises(InstructionError, match="must not be longer than 4,000 characters, got 10,000,000"):
        language().read("a" * 10_000_000, now=NOW)


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
