"""A small share of the fuzzing that ``tests/trust/fuzz_language.py`` does by the million."""

from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import Language
from trust.fuzz_language import NOWS, check_grammar, texts, vocabulary

WORDS = vocabulary()


@pytest.mark.parametrize("now", NOWS, ids=repr)
def test_no_seeded_text_breaks_the_grammar(now: datetime | None) -> None:
    for text in texts(150, seed=20260304):
        check_grammar(text, now)


@given(st.text(max_size=80), st.sampled_from(NOWS))
def test_no_text_breaks_the_grammar(text: str, now: datetime | None) -> None:
    check_grammar(text, now)


@given(st.lists(st.sampled_from(WORDS), max_size=14).map(" ".join), st.sampled_from(NOWS))
def test_no_order_of_words_breaks_the_grammar(text: str, now: datetime | None) -> None:
    check_grammar(text, now)


@pytest.mark.model
def test_no_seeded_text_breaks_the_reading() -> None:
    language = Language.shipped()
    for text in texts(150, seed=7):
        try:
            reading = language.read(text, now=NOWS[0])
        except FuzzytimeError:
            continue
        spans = [r.span for i in reading.instructions for r in i.requirements] + [
            r.span for r in reading.remarks
        ]
        assert all(0 <= first <= end <= len(text) for first, end in spans)


@pytest.mark.parametrize(
    "words", ["at noon ", "six ", "first monday of ", "before 5 after 6 ", "3:30-", "one hundred and "]
)
def test_repeated_words_stay_within_bounds(words: str) -> None:
    check_grammar((words * 100)[:600], NOWS[0])


@pytest.mark.model
def test_a_clause_without_words_is_none() -> None:
    text = (
        "within the next 3 to 5 hours, less than two weeks after, "
        "meet me between 10:30 and a quarter to twelve tom, when the "
    )
    (wish,) = Language.shipped().read(text, now=NOWS[0]).instructions
    assert wish.operation is not None
    assert wish.operation.name == "meet me"
