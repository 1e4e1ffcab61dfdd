"""All products of hedges, prepositions and anchors, counted: made of the word tables, none by hand."""

from collections.abc import Iterator
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import find_times, shipped_lexicon
from fuzzytime.language.grammar.lexicon import Entry
from fuzzytime.requirement import Constraint
from language.test_hedges import (
    AFTERTHOUGHTS,
    ANCHORS,
    BESIDE,
    DEADLINES,
    HEDGES,
    NOW,
    NUMBERS,
    RELEASES,
    UNITS,
    entries,
)

SENTENCES = (
    "{}",
    "call mum {}",
    "{} call mum",
    "{}, call mum",
    "please water the plants {}.",
    "I want to call mum {}",
    "could you call mum {}?",
    "remind me {} to call mum",
    "call mum {}, then feed the cat",
)
WORDS = [
    word
    for word in entries("word")
    # "Whenever" before a verb begins a clause, "then" what follows.
    if word.value.constraint not in {Constraint.EVERY, Constraint.FOR}
    and word.words not in shipped_lexicon().clauses
    and word.words != ("then",)
]
OF_NUMBERS = {"less than", "more than", "some"}
"""Hedges that stand beside numbers only: nobody says "more than at noon"."""


def said(entry: Entry) -> str:
    return " ".join(entry.words)


def distances() -> Iterator[tuple[str, float]]:
    """Give hedged distances from now, and their seconds."""
    for hedge, number, unit in product(HEDGES, NUMBERS, UNITS):
        count = NUMBERS[number]
        if count is not None:
            yield f"in {said(hedge)} {number} {unit}", count * UNITS[unit]
    for hedge in HEDGES:
        yield f"in {said(hedge)} half an hour", 1800
        yield f"in {said(hedge)} a quarter of an hour", 900
        yield f"in {said(hedge)} an hour and a half", 5400


def deadlines() -> Iterator[tuple[str, float]]:
    """Give deadlines, bare and hedged, and their seconds."""
    for preposition, anchor in product(DEADLINES, ANCHORS):
        yield f"{said(preposition)} {anchor}", ANCHORS[anchor]
    for word, hedge, anchor in product(("by", "before", "until", "no later than"), HEDGES, ANCHORS):
        yield f"{word} {said(hedge)} {anchor}", ANCHORS[anchor]


def releases() -> Iterator[tuple[str, float]]:
    """Give releases, and their seconds."""
    for preposition, anchor in product(RELEASES, ANCHORS):
        yield f"{said(preposition)} {anchor}", ANCHORS[anchor]


def phrases() -> list[str]:
    """Give times of every kind."""
    found = [f"in {said(hedge)} {number}" for hedge in HEDGES for number in ("ten minutes", "an hour")]
    found += [text for text, _ in (*deadlines(), *releases())]
    found += [f"{said(hedge)} {anchor}" for hedge, anchor in product(BESIDE, ANCHORS)]
    found += [f"{anchor} {said(h)}" for h, anchor in product(AFTERTHOUGHTS, ("at noon", "in ten minutes"))]
    found += [f"{said(h)} at noon" for h in HEDGES if h.value not in OF_NUMBERS]
    return found + [said(word) for word in WORDS]


def right(text: str, seconds: float) -> bool:
    """Whether all of a text is one time, and that many seconds away."""
    found = find_times(text, NOW).requirements
    if len(found) != 1 or found[0].text != text:
        return False
    return found[0].t_spec == seconds or seconds in {found[0].earliest, found[0].latest}


@pytest.mark.parametrize("made", [distances, deadlines, releases], ids=lambda made: made.__name__)
def test_of_all_products_the_anchor_is_right(made: type[Iterator[tuple[str, float]]]) -> None:
    wrong = [text for text, seconds in made() if not right(text, seconds)]
    asked = sum(1 for _ in made())
    assert len(wrong) <= 0.01 * asked, wrong[:20]


def test_every_product_of_a_deadline_is_a_deadline() -> None:
    found = {text: find_times(text, NOW).requirements for text, _ in deadlines()}
    assert [t for t, said in found.items() if [r.constraint for r in said] != [Constraint.BEFORE]] == []


@given(st.sampled_from(SENTENCES), st.sampled_from(phrases()))
def test_a_time_is_found_whole_in_every_sentence(sentence: str, phrase: str) -> None:
    text = sentence.format(phrase)
    assert phrase in [requirement.text for requirement in find_times(text, NOW).requirements]


@given(st.sampled_from(SENTENCES), st.sampled_from(WORDS))
def test_a_time_word_has_no_anchor_or_is_now(sentence: str, word: Entry) -> None:
    text = sentence.format(said(word))
    (found,) = [r for r in find_times(text, NOW).requirements if r.text == said(word)]
    assert found.word == word.value.word
    assert found.t_spec == (None if word.value.constraint is Constraint.VAGUE else 0)
