"""Words know their place in the text, and are levelled without changing it."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language.grammar.words import words_of


@given(st.text())
def test_words_cover_the_text_in_order_without_overlap(text: str) -> None:
    words = words_of(text)
    assert all(text[word.start : word.end].strip() for word in words)
    assert all(first.end <= second.start for first, second in pairwise(words))
    left = "".join(
        text[a:b]
        for a, b in zip(
            [0, *(word.end for word in words)], [*(word.start for word in words), len(text)], strict=True
        )
    )
    assert left.strip() == ""


@given(st.text())
def test_a_word_is_never_empty(text: str) -> None:
    assert all(word.text for word in words_of(text))


@pytest.mark.parametrize(
    ("text", "levelled"),
    [
        ("３PM", ["3", "pm"]),
        ("O’Clock", ["o'clock"]),
        ("5–6", ["5", "-", "6"]),
        ("½ h", ["½", "h"]),
        ("2′ 30″", ["2", "'", "30", '"']),
        ("15h30", ["15", "h", "30"]),
        ("don't", ["don't"]),
        ("a.m.", ["a", ".", "m", "."]),
        ("ＮＯＯＮ", ["noon"]),
    ],
)
def test_forms_of_one_character_are_levelled(text: str, levelled: list[str]) -> None:
    assert [word.text for word in words_of(text)] == levelled
