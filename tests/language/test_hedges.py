"""Mechanical products of hedges, prepositions and anchors keep the anchor, the hedge and the side."""

from datetime import datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import find_times
from fuzzytime.language.finding import shipped_lexicon
from fuzzytime.language.grammar.lexicon import Entry, Preposition
from fuzzytime.requirement import Constraint, TimeRequirement

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001
ANCHORS = {
    "noon": 3 * 3600,
    "5:30 pm": 8.5 * 3600,
    "half past six pm": 9.5 * 3600,
    "8 pm": 11 * 3600,
    "quarter to nine pm": 11.75 * 3600,
    "tomorrow at 7 am": 22 * 3600,
    "friday at 17:30": 56.5 * 3600,
}
NUMBERS = {"ten": 10, "10": 10, "twenty-five": 25, "45": 45, "ninety": 90, "an hour": None}
UNITS = {"seconds": 1, "minutes": 60, "min": 60, "hours": 3600, "hrs": 3600}


def entries(*categories: str) -> list[Entry]:
    """Give the ways to say something of some categories."""
    tables = shipped_lexicon().entries.values()
    found = [entry for row in tables for entry in row if entry.category in categories]
    return [entry for entry in found if all(word[0].isalpha() for word in entry.words)]


HEDGES = entries("hedge")
AFTERTHOUGHTS = [entry for entry in entries("hedge_after") if entry.words != ("ish",)]
BESIDE = entries("beside")
DEADLINES = entries("preposition_before")
RELEASES = [entry for entry in entries("preposition_after") if entry.words != ("since",)]
MORE_OR_LESS = {"at least": Constraint.AFTER, "more than": Constraint.AFTER}
MORE_OR_LESS |= {"at most": Constraint.BEFORE, "less than": Constraint.BEFORE}


def only(text: str) -> TimeRequirement:
    """Give the one requirement of a text, which must be all of it."""
    (requirement,) = find_times(text, NOW).requirements
    assert requirement.text == text
    return requirement


@given(st.sampled_from(HEDGES), st.sampled_from(sorted(NUMBERS)[:-1]), st.sampled_from(sorted(UNITS)))
def test_a_hedge_before_a_distance_is_kept(hedge: Entry, number: str, unit: str) -> None:
    if NUMBERS[number] is None:
        return
    requirement = only(f"in {' '.join(hedge.words)} {number} {unit}")
    constraint = MORE_OR_LESS.get(hedge.value, Constraint.AT)
    within = constraint is Constraint.BEFORE and requirement.preposition == "within"
    assert requirement.t_spec == (NUMBERS[number] or 0) * UNITS[unit]
    assert requirement.constraint is constraint
    assert within or requirement.fuzziness == (hedge.value,)


@given(st.sampled_from(AFTERTHOUGHTS), st.sampled_from(sorted(NUMBERS)[:-1]))
def test_a_hedge_behind_a_distance_is_kept(hedge: Entry, number: str) -> None:
    if NUMBERS[number] is None:
        return
    requirement = only(f"in {number} minutes {' '.join(hedge.words)}")
    assert requirement.t_spec == (NUMBERS[number] or 0) * 60
    assert requirement.fuzziness == (hedge.value,)


@given(st.sampled_from(HEDGES), st.sampled_from(sorted(ANCHORS)), st.sampled_from(["", "at "]))
def test_a_hedge_before_a_clock_time_keeps_its_anchor(hedge: Entry, anchor: str, preposition: str) -> None:
    # "Up to six" is a bound, and no hedge.
    if hedge.words in {("over",), ("up", "to")} or (
        preposition and anchor.startswith(("tomorrow", "friday"))
    ):
        return
    if hedge.words == ("some",) and anchor.startswith("friday"):
        # "Some friday" is any.
        return
    requirement = only(f"{preposition}{' '.join(hedge.words)} {anchor}")
    assert requirement.t_spec == ANCHORS[anchor]
    assert (*requirement.fuzziness, requirement.preposition)[0] == hedge.value


@given(st.sampled_from(DEADLINES), st.sampled_from(sorted(ANCHORS)))
def test_every_deadline_stays_a_deadline(preposition: Entry, anchor: str) -> None:
    requirement = only(f"{' '.join(preposition.words)} {anchor}")
    value: Preposition = preposition.value
    assert (requirement.constraint, requirement.preposition) == (Constraint.BEFORE, value.name)
    assert (requirement.earliest, requirement.latest) == (None, ANCHORS[anchor])


@given(st.sampled_from(RELEASES), st.sampled_from(sorted(ANCHORS)))
def test_every_release_stays_a_release(preposition: Entry, anchor: str) -> None:
    requirement = only(f"{' '.join(preposition.words)} {anchor}")
    at = " ".join(preposition.words) in {"starting", "beginning", "commencing"}
    assert requirement.constraint is (Constraint.AT if at else Constraint.AFTER)
    assert requirement.earliest == ANCHORS[anchor]


@given(st.sampled_from(BESIDE), st.sampled_from(sorted(ANCHORS)))
def test_just_off_an_anchor_is_a_point_and_no_bound(hedge: Entry, anchor: str) -> None:
    requirement = only(f"{' '.join(hedge.words)} {anchor}")
    assert requirement.constraint is Constraint.AT
    assert requirement.t_spec == ANCHORS[anchor]
    assert requirement.fuzziness == (hedge.value,)


@given(st.sampled_from(HEDGES), st.sampled_from(DEADLINES + RELEASES), st.sampled_from(["noon", "8 pm"]))
def test_a_hedge_inside_a_bound_is_kept(hedge: Entry, preposition: Entry, anchor: str) -> None:
    said = find_times(f"{' '.join(preposition.words)} {' '.join(hedge.words)} {anchor}", NOW).requirements
    assert len(said) == 1
    assert ANCHORS[anchor] in {said[0].t_spec, said[0].earliest}


@given(st.datetimes(datetime(2026, 3, 4, 9, 1), datetime(2026, 3, 5, 8, 59)))  # noqa: DTZ001
def test_every_minute_of_the_day_is_found_in_every_way_to_type_it(moment: datetime) -> None:
    minute = moment.replace(second=0, microsecond=0)
    wanted = (minute - NOW) / timedelta(seconds=1)
    for form in ("%H:%M", "%I:%M %p", "%Hh%M", "%I.%M%p", "at %H%M", "at %H.%M", "%I:%M:00 %p"):
        text = minute.strftime(form)
        assert find_times(text, NOW).requirements[0].t_spec == pytest.approx(wanted), text
