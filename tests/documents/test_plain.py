"""Frozen values as JSON: the same come back, and nothing but values of this library is made."""

import json
from datetime import date
from types import MappingProxyType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.documents.plain import made_again, written
from fuzzytime.language.grammar.lexicon import Entry, Forms
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import Constraint, TimeRequirement

SIMPLE = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False)
    | st.text(st.characters(exclude_categories=["Cs"]))
    | st.times().map(lambda found: found.replace(fold=0))
    | st.sampled_from(Constraint)
)
VALUES = st.recursive(
    SIMPLE,
    lambda inner: (
        st.lists(inner, max_size=4).map(tuple)
        | st.frozensets(SIMPLE, max_size=4)
        | st.dictionaries(SIMPLE, inner, max_size=4)
        | st.dictionaries(SIMPLE, inner, max_size=4).map(MappingProxyType)
    ),
    max_leaves=20,
)


@given(VALUES)
def test_what_is_written_comes_back(value: object) -> None:
    found = made_again(written((value,)))[0]
    assert found == value
    assert type(found) is type(value)


@pytest.mark.parametrize(
    "value",
    [
        TimeRequirement(text="at noon", span=(0, 7), constraint=Constraint.AT, t_spec=10.0),
        Policy(),
        Forms({("half", "past"): 30}),
        Entry(("half", "past"), "fraction", 30),
    ],
)
def test_values_of_the_library_come_back(value: object) -> None:
    found = made_again(written(value))
    assert found == value
    assert type(found) is type(value)


def test_what_is_shared_is_written_once() -> None:
    shared = ("a", "b")
    found = made_again(written((shared, shared)))
    assert found[0] is found[1]


@pytest.mark.parametrize("value", [date(2026, 3, 4), ["a list"], {"a", "set"}, b"bytes", len, object()])
def test_other_values_are_refused(value: object) -> None:
    with pytest.raises(TypeError, match="cannot be written"):
        written((value,))


@pytest.mark.parametrize(
    "kind",
    [
        "os:system",
        "fuzzytimes:Other",
        "fuzzytime.documents.plain:import_module",
        "fuzzytime.documents.plain:Path.unlink",
        "fuzzytime.documents.document:Document",
    ],
)
def test_nothing_else_is_made(kind: str) -> None:
    text = json.dumps(
        {"kinds": [kind], "atoms": ["x"], "tuples": [], "sets": [], "made": [[0, 0]], "whole": 1}
    )
    with pytest.raises((ValueError, TypeError, AttributeError)):
        made_again(text)
