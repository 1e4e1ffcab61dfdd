"""Conditions of rules are read by their grammar, and every problem has its place."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.rulebook.logic.formula import (
    And,
    Direction,
    Formula,
    Is,
    Not,
    Operator,
    Or,
    Window,
    variables,
    window_reach,
)
from fuzzytime.rulebook.logic.grammar import KEYWORDS, parse_condition

TERMS = {"pan": {"hot", "warm"}, "workload": {"busy"}}
HEDGES = {"very", "somewhat"}
HOT, BUSY = Is("pan", "hot"), Is("workload", "busy")


def formula(text: str) -> Formula | None:
    parsed = parse_condition(text, TERMS, HEDGES)
    assert parsed.problems == ()
    return parsed.formula


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pan is hot", HOT),
        ("pan is very very hot", Is("pan", "hot", ("very", "very"))),
        ("pan is not very hot", Not(Is("pan", "hot", ("very",)))),
        ("not pan is hot and workload is busy", And((Not(HOT), BUSY))),
        ("pan is hot or workload is busy and pan is warm", Or((HOT, And((BUSY, Is("pan", "warm")))))),
        ("(pan is hot or workload is busy) and pan is warm", And((Or((HOT, BUSY)), Is("pan", "warm")))),
        (
            "workload is busy mostly in the last about 10 min",
            Window(Operator.MOSTLY, Direction.LAST, 600.0, 0.25, BUSY),
        ),
        ("pan is hot throughout next 30s", Window(Operator.THROUGHOUT, Direction.NEXT, 30.0, 0.0, HOT)),
        ("pan is hot throughout next 1h30", Window(Operator.THROUGHOUT, Direction.NEXT, 5400.0, 0.0, HOT)),
        ("pan is hot sometime in last 1e2 s", Window(Operator.SOMETIME, Direction.LAST, 100.0, 0.0, HOT)),
        (
            "pan is hot sometime in the last about 2min30s",
            Window(Operator.SOMETIME, Direction.LAST, 150.0, 0.25, HOT),
        ),
        ("pan is Very hot", Is("pan", "hot", ("very",))),
        (
            "not (pan is hot) sometime in the last roughly .5 h",
            Not(Window(Operator.SOMETIME, Direction.LAST, 1800.0, 0.5, HOT)),
        ),
    ],
)
def test_conditions_are_read(text: str, expected: Formula) -> None:
    assert formula(text) == expected


@pytest.mark.parametrize(
    ("text", "problems"),
    [
        ("pan is hto", [(7, "'pan' has no term 'hto' (did you mean 'hot'?)")]),
        ("wrkload is busy", [(0, "unknown variable 'wrkload' (did you mean 'workload'?)")]),
        ("pna is hto or pan is hto", [(0, "unknown variable 'pna'"), (21, "'pan' has no term 'hto'")]),
        ("pan hot", [(4, "expected 'is', got 'hot'")]),
        ("pan is", [(6, "expected a term, got the end")]),
        ("", [(0, "expected a variable, got the end")]),
        ("pan is hot and", [(14, "expected a variable, got the end")]),
        ("(pan is hot", [(11, "expected ')', got the end")]),
        ("pan is hot)", [(10, "expected 'and', 'or', a window or the end, got ')'")]),
        ("pan is hot; import os", [(10, "got ';'")]),
        ("pan is hot mostly in the 10 min", [(25, "expected 'last' or 'next', got '10'")]),
        ("pan is hot mostly in the last min", [(30, "expected a number, got 'min'")]),
        ("pan is hot mostly in the last 10 mins ago", [(38, "got 'ago'")]),
        (
            "pan is hot mostly in the last 10 mnutes",
            [(33, "unknown unit of time 'mnutes' (did you mean 'minutes'?)")],
        ),
        (f"pan is hot mostly in the last {'9' * 400} s", [(30, "a window must be longer than 0")]),
        ("pan is hot mostly in the last 0 min", [(30, "a window must be longer than 0")]),
        ("pan is vry hot", [(7, "unknown hedge 'vry' (did you mean 'very'?)")]),
        ("pan is hot mosty in the last 5 min", [(11, "got 'mosty' (did you mean 'mostly'?)")]),
        ("pan is hot mostly in the last abuot 5 min", [(30, "no hedge 'abuot' (did you mean 'about'?)")]),
        ("pan is hot mostly in the last 1x30", [(30, "a duration's unit must be one of ms, s")]),
        ("pan is hot mostly in the last abuot 1h30", [(30, "no hedge 'abuot' (did you mean 'about'?)")]),
        ("pan is hot mostly in the last -5 min", [(30, "a window must be longer than 0")]),
        ("pan is hot mostly in the last 1e400 min", [(30, "a window must be longer than 0")]),
        # What follows a broken form is searched as well.
        ("pan hot && pan is hto || pan is wram", [(4, "'is'"), (18, "'hot'"), (22, "'||'"), (32, "'warm'")]),
        (
            "pan_temp is hot",
            [(0, "'pan_temp' is a signal; a condition speaks of variables (known: pan)")],
        ),
        ("pan is __import__('os')", [(7, "'pan' has no term '__import__'"), (17, "got '('")]),
        ("not " * 30 + "pan is hot", [(96, "must not be nested deeper than 24")]),
        ("pan is " + "very " * 500 + "hot", [(0, "must not be longer than 2000 characters")]),
    ],
)
def test_problems_are_placed(text: str, problems: list[tuple[int, str]]) -> None:
    parsed = parse_condition(text, TERMS, HEDGES, {"pan_temp": ["pan"]})
    assert parsed.formula is None
    assert [problem.offset for problem in parsed.problems] == [offset for offset, _ in problems]
    for problem, (_, message) in zip(parsed.problems, problems, strict=True):
        assert message in problem.message


ATOMS = st.builds(
    Is,
    st.just("pan"),
    st.sampled_from(["hot", "warm"]),
    st.lists(st.sampled_from(["very", "somewhat"]), max_size=2).map(tuple),
)
PARTS_OF_WINDOWS = (
    st.sampled_from(Operator),
    st.sampled_from(Direction),
    st.sampled_from([30.0, 600.0, 5400.0]),
    st.sampled_from([0.0, 0.25, 0.5]),
)


def larger(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    several = st.lists(parts, min_size=2, max_size=3).map(tuple)
    return st.one_of(
        parts.map(Not),
        several.map(And),
        several.map(Or),
        st.builds(Window, *PARTS_OF_WINDOWS, parts),
    )


@given(st.recursive(ATOMS, larger, max_leaves=6))
def test_what_is_written_is_read_again(written: Formula) -> None:
    again = formula(str(written))
    assert str(again) == str(written)
    assert again is not None
    assert variables(again) == variables(written)
    for direction in Direction:
        assert window_reach(again, direction) == pytest.approx(window_reach(written, direction))


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused_with_a_place_inside_it(text: str) -> None:
    parsed = parse_condition(text, TERMS, HEDGES)
    assert (parsed.formula is None) == bool(parsed.problems)
    assert all(0 <= problem.offset <= len(text) for problem in parsed.problems)


@given(
    st.lists(
        st.sampled_from([*KEYWORDS, "pan", "hot", "(", ")", "10", "min", "very", "workload"]), max_size=14
    )
)
def test_any_row_of_its_words_is_read_or_refused(words: list[str]) -> None:
    parsed = parse_condition(" ".join(words), TERMS, HEDGES)
    assert (parsed.formula is None) == bool(parsed.problems)
