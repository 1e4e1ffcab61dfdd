"""Every row of the table serves every time, also one that has passed."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.requirement import Constraint
from fuzzytime.rulebook import Rulebook
from fuzzytime.rulebook.wording.lookup import find
from rulebook.requirements_of import said, word

RULEBOOK = Rulebook.shipped()
TIMES = st.floats(-1e6, 1e6, allow_nan=False)


@given(time=TIMES, preposition=st.sampled_from(sorted(RULEBOOK.tables.prepositions)))
def test_a_time_near_or_far_ahead_or_passed_has_a_satisfaction(time: float, preposition: str) -> None:
    for constraint in (Constraint.AT, Constraint.BEFORE, Constraint.AFTER):
        requirement = said(constraint, preposition=preposition, t_spec=time)
        function = RULEBOOK.resolve(requirement).satisfaction
        assert 0.0 <= float(function(time)) <= 1.0


@pytest.mark.parametrize("constraint", [Constraint.BEFORE, Constraint.AT])
def test_what_should_have_been_done_a_day_ago_satisfies_nobody_now(constraint: Constraint) -> None:
    function = RULEBOOK.resolve(said(constraint, preposition="before", t_spec=-86_400.0)).satisfaction
    assert float(function(0.0)) == 0.0


def test_the_row_of_the_words_as_they_were_said_goes_before_that_of_what_they_are_called() -> None:
    assert find(replace(word("later"), text="Later  on"), RULEBOOK.tables).row.name == "later on"
    assert find(replace(word("later"), text="later than that"), RULEBOOK.tables).row.name == "later"
