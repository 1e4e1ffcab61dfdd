"""What is planned only in part is said: the first time of several, the start of what lasts, one of two."""

from datetime import datetime

import pytest

from fuzzytime.language import Language

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone
ONCE = "is planned once"
AT_START = "says when to start"
EITHER = "is about either of several"


@pytest.fixture(scope="module")
def language() -> Language:
    return Language.shipped()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("turn the roast every time the buzzer sounds", ONCE),
        ("whenever the tank is full, stop the pump", ONCE),
        ("turn the roast when the buzzer sounds", None),
        ("turn the roast every two hours", None),
        ("water the lawn as long as the tap is on", AT_START),
        ("keep the gate shut while the bull is out", AT_START),
        ("sweep the yard while the bull is out", None),
        ("rest half as long as you ran", None),
        (
            "boil peas for ten minutes, bake the pie for an hour, call me when peas or pie are done",
            EITHER,
        ),
        ("boil peas for ten minutes, bake the pie for an hour, call me once either is done", EITHER),
        ("boil peas for ten minutes, bake the pie for an hour, call me once both are done", None),
    ],
)
def test_what_is_planned_only_in_part_is_said(language: Language, text: str, said: str | None) -> None:
    messages = [remark.message for remark in language.read(text, now=NOW).remarks]
    limits = [limit for limit in (ONCE, AT_START, EITHER) if any(limit in message for message in messages)]
    assert limits == ([] if said is None else [said])


@pytest.mark.parametrize("text", ["sit by the fire", "wait by the river at noon", "play by the pool"])
def test_where_somebody_is_by_something_is_a_place(language: Language, text: str) -> None:
    reading = language.read(text, now=NOW)
    assert not [remark for remark in reading.remarks if "not used" in remark.message]
    (instruction,) = reading.instructions
    assert instruction.operation is not None
    assert (instruction.operation.place or "").startswith("by the ")


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("pay the maid every payday", ["every payday"]),
        ("turn the dough every ad break", ["every ad break"]),
        ("mop the gym between lessons", ["between lessons"]),
        ("show mum every photo", []),
        ("wipe every table at six", []),
        ("put the lamp between the chairs", []),
        ("pay the maid every friday", []),
    ],
)
def test_how_often_is_pointed_at_where_it_is_not_known(
    language: Language, text: str, left: list[str]
) -> None:
    remarks = language.read(text, now=NOW).remarks
    unknown = [remark for remark in remarks if remark.message.endswith("says when, and is not understood")]
    assert [text[slice(*remark.span)] for remark in unknown] == left
