"""Rules become rows of symbols; the chart applies them, and keeps the weightiest reading."""

import pytest

from fuzzytime.language.grammar.chart import LONGEST, Grammar, Piece
from fuzzytime.language.grammar.patterns import literal, unfolded
from fuzzytime.language.grammar.words import words_of


def pieces(grammar: Grammar, text: str, category: str) -> list[Piece]:
    words = words_of(text)
    return [p for cell in grammar.parse(words, {}) for p in cell.get(category, {}).values()]


def test_a_choice_and_an_option_unfold_to_plain_rows() -> None:
    assert unfolded("a|an b? <c>") == (
        (("'a", "'b", "c"), (2,)),
        (("'a", "c"), (1,)),
        (("'an", "'b", "c"), (2,)),
        (("'an", "c"), (1,)),
    )


def test_an_optional_piece_that_is_absent_is_given_as_none() -> None:
    assert (("'x",), (None,)) in unfolded("x <c>?")


def test_a_category_may_have_spaces() -> None:
    assert unfolded("<month day> of") == ((("month day", "'of"), (0,)),)


def test_pieces_of_any_length_are_found_by_recursion() -> None:
    grammar = Grammar()
    grammar.rule("many", "x")(lambda: 1)
    grammar.rule("many", "<many> <many>")(lambda one, other: one + other)
    assert {(p.start, p.end, p.value) for p in pieces(grammar, "x x x", "many")} == {
        (a, b, b - a) for a in range(3) for b in range(a + 1, 4)
    }


def test_the_weightier_reading_is_kept() -> None:
    grammar = Grammar()
    grammar.rule("c", "x", weight=0.1)(lambda: "light")
    grammar.rule("c", "x", weight=0.2)(lambda: "heavy")
    grammar.rule("c", "x", weight=0.0)(lambda: "feather")
    assert [p.value for p in pieces(grammar, "x", "c")] == ["heavy"]


def test_a_rule_may_decline() -> None:
    grammar = Grammar()
    grammar.rule("c", "x")(lambda: None)
    assert pieces(grammar, "x", "c") == []


@pytest.mark.parametrize("text", ["half past", "half-past"])
def test_a_hyphen_that_joins_words_is_passed_over(text: str) -> None:
    grammar = Grammar()
    grammar.rule("c", "half past")(lambda: 30)
    assert [p.value for p in pieces(grammar, text, "c")] == [30]


def test_a_hyphen_with_spaces_is_a_word() -> None:
    grammar = Grammar()
    grammar.rule("c", "half past")(lambda: 30)
    assert pieces(grammar, "half - past", "c") == []


def test_no_piece_is_longer_than_the_limit() -> None:
    grammar = Grammar()
    grammar.rule("many", "x")(lambda: 1)
    grammar.rule("many", "<many> <many>")(lambda one, other: one + other)
    assert max(p.end - p.start for p in pieces(grammar, "x " * (LONGEST + 20), "many")) == LONGEST


def test_a_literal_is_no_category() -> None:
    assert literal("hour") != "hour"
