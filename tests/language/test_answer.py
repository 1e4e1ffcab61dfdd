"""The answer for other programs has the documented keys, always."""

import json
from datetime import datetime
from functools import cache

import pytest

from fuzzytime.language import Language, answer

pytestmark = pytest.mark.model

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001
KEYS = {"text", "now", "operation", "requirements", "duration_s", "repeats", "instructions", "error"}
REQUIREMENT_KEYS = {
    "text",
    "span",
    "reference",
    "constraint",
    "preposition",
    "fuzziness",
    "number",
    "unit",
    "t_spec_s",
    "earliest",
    "latest",
}


@cache
def language() -> Language:
    return Language.shipped()


def test_the_documented_example_is_answered_as_documented() -> None:
    found = answer(language().read("Flip the pancakes in about two minutes", now=NOW))
    assert found == {
        "text": "Flip the pancakes in about two minutes",
        "now": "2026-03-04T09:00:00",
        "operation": {
            "verb": "flip",
            "object": "the pancakes",
            "place": None,
            "span": [0, 4],
            "negated": False,
        },
        "requirements": [
            {
                "text": "in about two minutes",
                "span": [18, 38],
                "reference": "start",
                "constraint": "at",
                "preposition": "in",
                "fuzziness": "about",
                "number": 2,
                "unit": "minute",
                "t_spec_s": 120.0,
                "earliest": "2026-03-04T09:02:00",
                "latest": "2026-03-04T09:02:00",
            }
        ],
        "duration_s": None,
        "repeats": None,
        "instructions": 1,
        "error": None,
    }


def test_the_first_operation_stands_behind_what_only_says_how_things_are() -> None:
    found = answer(language().read("we're out of milk so order some before noon", now=NOW))
    assert found["operation"]["verb"] == "order"
    assert [each and each["verb"] for each in found["operations"]] == [None, "order"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "in ten minutes",
        "set the table",
        "boil the eggs for eight minutes",
        "feed the cat every day at nine",
        "set the table, then feed the cat",
        "stir when the pan is hot",
        "serve before you eat",
        "call me at six",
        "call me at noon or at one",
    ],
)
def test_the_keys_are_always_there_and_the_answer_is_json(text: str) -> None:
    found = answer(language().read(text, now=NOW))
    assert found.keys() >= KEYS
    assert all(requirement.keys() >= REQUIREMENT_KEYS for requirement in found["requirements"])
    assert json.loads(json.dumps(found, allow_nan=False)) == found


def test_several_instructions_are_counted_listed_and_told_apart() -> None:
    found = answer(language().read("set the table soon, then feed the cat at noon", now=NOW))
    assert found["instructions"] == 2
    assert [operation["verb"] for operation in found["operations"]] == ["set", "feed"]
    assert [requirement["instruction"] for requirement in found["requirements"]] == [0, 1, 1]
    assert found["operation"] == found["operations"][0]


@pytest.mark.parametrize(
    ("text", "earliest", "latest"),
    [
        ("eat at noon", "2026-03-04T12:00:00", "2026-03-04T12:00:00"),
        ("eat by noon", None, "2026-03-04T12:00:00"),
        ("eat after noon", "2026-03-04T12:00:00", None),
        ("eat tomorrow morning", "2026-03-05T08:00:00", "2026-03-05T12:00:00"),
        ("eat soon", None, None),
        ("eat when it is hot", None, None),
        ("eat for ten minutes", None, None),
        ("eat every day", "2026-03-04T09:00:00", "2026-03-05T09:00:00"),
    ],
)
def test_bounds_are_open_where_the_constraint_leaves_them_open(
    text: str, earliest: str | None, latest: str | None
) -> None:
    (requirement,) = answer(language().read(text, now=NOW))["requirements"]
    assert (requirement["earliest"], requirement["latest"]) == (earliest, latest)


def test_a_repetition_has_its_words_its_interval_and_its_next_occurrences() -> None:
    found = answer(language().read("feed the cat every day at nine pm", now=NOW))
    assert found["repeats"] == {
        "text": "every day at nine pm",
        "interval_s": 86400.0,
        "next": ["2026-03-04T21:00:00", "2026-03-05T21:00:00", "2026-03-06T21:00:00"],
    }


def test_a_duration_stands_in_seconds_and_among_the_requirements() -> None:
    found = answer(language().read("boil the eggs for eight minutes", now=NOW))
    assert found["duration_s"] == 480.0
    assert [requirement["constraint"] for requirement in found["requirements"]] == ["for"]


def test_the_operation_is_what_is_asked_for_before_what_only_happens() -> None:
    found = answer(language().read("the coach leaves at two, call a cab at one", now=NOW))
    assert [operation["verb"] for operation in found["operations"]] == ["leaves", "call"]
    assert found["operation"]["verb"] == "call"
    assert answer(language().read("the coach leaves at two", now=NOW))["operation"]["verb"] == "leaves"
