"""Numbers in clauses: which signal they are about, in which unit, and how softly they are meant."""

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.context import Context
from fuzzytime.english import denies
from fuzzytime.requirement import Anchor, Comparison, Condition, Constraint, Side, TimeRequirement
from fuzzytime.rulebook import Profile, Resolution, Rulebook
from fuzzytime.rulebook.logic.formula import Not
from fuzzytime.rulebook.tables.documents import shipped_tables
from fuzzytime.rulebook.wording.sentences import understand
from rulebook.requirements_of import said

RULEBOOK = Rulebook.shipped()
TABLES = shipped_tables(Profile.EVERYDAY)


def number(side: Side, value: float, behind: str = "degrees", **fields: object) -> Comparison:
    until = fields.pop("until", None)
    words = f"{side} {value:g}" + (f" and {until:g}" if isinstance(until, float) else "")
    return Comparison(text=words, side=side, number=value, behind=behind, until=until, **fields)  # type: ignore[arg-type]


def clause(
    *comparisons: Comparison, subject: str | None = "pan", before: str = "the pan is"
) -> TimeRequirement:
    numbers = " and ".join(f"{one.text} {one.behind}" for one in comparisons)
    condition = Condition(text=f"when {before} {numbers}", subject=subject, comparisons=comparisons)
    return said(Constraint.WHEN, condition.text, preposition="when", condition=condition)


def now(requirement: TimeRequirement, **values: float) -> float:
    """Give how true the clause is now."""
    return holding(requirement, Context.of(dict(values))).shares[0].degree.low


def holding(requirement: TimeRequirement, context: Context) -> Resolution:
    return RULEBOOK.resolve(requirement, context)


@pytest.mark.parametrize(
    ("side", "degrees"),
    [
        (Side.ABOVE, {150: 0.0, 152.25: 0.5, 154.5: 1.0, 200: 1.0}),
        (Side.AT_LEAST, {145: 0.0, 147.75: 0.5, 150: 1.0, 200: 1.0}),
        (Side.AT, {145: 0.0, 147.75: 0.5, 150: 1.0, 200: 1.0}),
        (Side.AT_MOST, {100: 1.0, 150: 1.0, 152.25: 0.5, 155: 0.0}),
        (Side.BELOW, {100: 1.0, 145.5: 1.0, 147.75: 0.5, 150: 0.0}),
    ],
)
def test_a_number_is_soft_on_the_side_that_it_leaves_open(side: Side, degrees: dict[float, float]) -> None:
    for value, degree in degrees.items():
        held = now(clause(number(side, 150)), room_temp=20, pan_temp=value)
        assert held == pytest.approx(degree, abs=1e-9), value


@pytest.mark.parametrize(
    "thing", ["pan's temperature", "pan 's temperature", "pan\u2019s temperature", "temperature of the pan"]
)
def test_what_is_read_of_a_thing_is_about_it(thing: str) -> None:
    above = clause(number(Side.ABOVE, 150), subject=thing, before=f"the {thing} is")
    assert (now(above, pan_temp=140), now(above, pan_temp=160)) == (0.0, 1.0)


def test_a_range_is_full_between_its_ends() -> None:
    between = clause(number(Side.BETWEEN, 150, until=180.0))
    assert [now(between, pan_temp=value) for value in (140, 150, 180, 190)] == pytest.approx([0, 1, 1, 0])


@given(st.floats(0, 350), st.floats(0, 350))
def test_below_is_what_at_least_is_not_up_to_the_softness(said_number: float, value: float) -> None:
    context = {"pan_temp": value}
    below = now(clause(number(Side.BELOW, said_number)), **context)
    at_least = now(clause(number(Side.AT_LEAST, said_number)), **context)
    assert below == pytest.approx(1 - at_least, abs=1e-6)


def test_zero_has_no_share_and_is_a_cliff() -> None:
    empty = clause(number(Side.ABOVE, 0, "tasks"), subject="queue", before="the queue is")
    assert now(empty, queue=0) == 0
    assert now(empty, queue=1) == 1


def test_a_count_is_told_from_the_next() -> None:
    few = clause(number(Side.BELOW, 3, ""), subject="queue", before="the queue is")
    assert [now(few, queue=value) for value in (2, 3)] == [1, 0]


def test_a_number_counts_in_the_unit_that_was_said() -> None:
    fahrenheit = clause(number(Side.AT_LEAST, 350, "\u00b0F"))
    assert now(fahrenheit, pan_temp=176.67) == pytest.approx(1, abs=1e-3)
    assert now(fahrenheit, pan_temp=165) == 0
    (atom,) = holding(fahrenheit, Context.of({"pan_temp": 100})).shares[0].atoms
    assert atom.text == "pan is at least 350 \u00b0F (176.7 \u00b0C)"


def test_hedges_soften_a_number_by_their_row() -> None:
    (atom,) = (
        holding(clause(number(Side.ABOVE, 150, fuzziness=("about",))), Context.of({"pan_temp": 100}))
        .shares[0]
        .atoms
    )
    widened = 150 * (1 + 0.03 * TABLES.time_hedges["about"].widen)
    assert f"full from {widened:.4g} \u00b0C" in atom.meaning
    assert "rules/lookup.yaml:" in atom.meaning


def test_an_unknown_hedge_is_said() -> None:
    resolution = holding(
        clause(number(Side.ABOVE, 150, fuzziness=("verily",))), Context.of({"pan_temp": 100})
    )
    assert "unknown hedge 'verily': taken as none" in resolution.notes


def test_a_signal_s_own_softness_wins() -> None:
    signals = {**TABLES.signals, "pan_temp": replace(TABLES.signals["pan_temp"], softness=30.0)}
    condition = clause(number(Side.ABOVE, 150)).condition
    assert condition is not None
    understood = understand(condition, replace(TABLES, signals=signals))
    assert understood.tables.variables["pan"].terms["above 150 \u00b0C"].corners[:2] == (150, 180)


def test_what_heats_will_be_above_a_number() -> None:
    resolution = holding(clause(number(Side.ABOVE, 150)), Context.of({"pan_temp": [(-60, 60), (0, 110)]}))
    assert resolution.reason is None
    assert 10 < resolution.parameters["t"] < 300


def test_what_comes_down_reaches_a_number_from_above() -> None:
    cooling = Context.of({"weld_temp": [(-60.0 * k, 200 + 30.0 * k) for k in range(10)]})
    reached = clause(number(Side.AT, 100), subject="weld", before="the weld reaches")
    resolution = holding(reached, cooling)
    assert resolution.shares[0].degree.low == 0
    assert resolution.parameters["t"] > 60
    assert any("coming down" in note for note in resolution.notes)


def test_what_stays_above_a_number_has_reached_it() -> None:
    assert now(clause(number(Side.AT, 150)), oven_temp=20, pan_temp=220) == 1


def test_a_number_beyond_the_range_is_never_reached() -> None:
    reason = holding(clause(number(Side.ABOVE, 900)), Context.of({"pan_temp": 100})).reason
    assert reason == "never: pan_temp lies between -10 and 400 \u00b0C, so it is not above 900 \u00b0C"


def test_a_unit_that_does_not_fit_is_said() -> None:
    reason = holding(clause(number(Side.ABOVE, 20, "%")), Context.of({"pan_temp": 100})).reason
    assert reason == "pan_temp is measured in \u00b0C, got 'above 20 %'"


def test_without_readings_the_reason_names_the_signal() -> None:
    assert holding(clause(number(Side.ABOVE, 150)), Context.empty).reason == "not enough readings of pan_temp"


def test_it_is_the_only_thing_that_was_read_in_the_unit() -> None:
    hotter = clause(number(Side.ABOVE, 150), subject="it", before="it is")
    resolution = holding(hotter, Context.of({"pan_temp": 200, "queue": 3}))
    assert resolution.shares[0].degree.low == 1
    assert resolution.notes == ("'above 150' is taken as about pan_temp: nothing else of its kind was read",)


def test_without_a_reading_it_may_be_all_that_can_be_so() -> None:
    hotter = clause(number(Side.ABOVE, 1000), subject="it", before="it is")
    reason = holding(hotter, Context.of({"pan_temp": 200})).reason
    assert reason == "never: pan_temp lies between -10 and 400 \u00b0C, so it is not above 1000 \u00b0C"
    assert holding(hotter, Context.empty).reason == (
        "not enough readings: 'above 1000 degrees' may be about weld_temp"
    )


def test_it_is_asked_back_where_several_things_were_read() -> None:
    hotter = clause(number(Side.ABOVE, 150), subject="it", before="it is")
    context = Context.of({"pan_temp": 200, "oven_temp": 100, "outside_temp": 20})
    assert holding(hotter, context).reason == "'above 150' may be about pan_temp or oven_temp: name it"


def test_a_thing_that_no_table_knows_is_never_taken_for_another() -> None:
    soup = clause(number(Side.AT, 50), subject="soup", before="the soup is")
    assert holding(soup, Context.of({"pan_temp": 200})).reason == "no signal of 'soup' tells 'at 50 degrees'"


def test_the_unit_chooses_among_things_of_one_name() -> None:
    house = {"subject": "house", "before": "the house is"}
    loud = clause(number(Side.ABOVE, 60, "dB"), **house)
    assert RULEBOOK.signals_for(loud) == {"noise"}
    assert RULEBOOK.signals_for(clause(number(Side.ABOVE, 21), **house)) == {"room_temp"}


def test_a_bare_number_is_of_what_has_no_unit() -> None:
    few = clause(number(Side.BELOW, 5, "people are at home"), subject="people", before="there are")
    assert RULEBOOK.signals_for(few) == {"people_home"}


def test_it_depends_on_all_that_it_may_be() -> None:
    hotter = clause(number(Side.ABOVE, 150, "\u00b0C"), subject="it", before="it is")
    assert {"pan_temp", "oven_temp", "weld_temp"} <= RULEBOOK.signals_for(hotter)


def test_a_signal_without_a_variable_is_known_by_its_own_name(tmp_path: Path) -> None:
    table = tmp_path / "kiln.yaml"
    table.write_text("fuzzytime: 1\nsignals:\n  kiln_temp: {unit: degC, range: [0, 1300]}\n", "utf-8")
    rulebook = Rulebook.shipped(files=[table])
    kiln = clause(number(Side.BELOW, 100), subject="kiln temperature", before="the kiln temperature is")
    assert rulebook.resolve(kiln, Context.of({"kiln_temp": 80})).shares[0].degree.low == 1


def test_numbers_are_parts_of_a_clause_of_several() -> None:
    above, below = number(Side.ABOVE, 100), number(Side.BELOW, 150, "")
    both = clause(above, below)
    assert [now(both, pan_temp=value) for value in (90, 120, 160)] == [0, 1, 0]


def test_a_number_s_own_and_is_no_joint() -> None:
    text = "when the pan is between 150 and 180 degrees and the timer rings"
    between = Comparison(
        text="between 150 and 180",
        side=Side.BETWEEN,
        number=150,
        until=180.0,
        behind="degrees and the timer rings",
    )
    condition = Condition(text=text, subject="pan", comparisons=(between,))
    formula = understand(condition, TABLES).formula
    assert str(formula) == "pan is between 150 and 180 \u00b0C and timer has happened"


def test_a_number_is_denied_with_its_clause() -> None:
    condition = clause(number(Side.ABOVE, 150)).condition
    assert condition is not None
    assert str(understand(replace(condition, negated=True), TABLES).formula) == "not pan is above 150 \u00b0C"


@pytest.mark.parametrize(
    "text", ["the pan is hot and the timer rings", "the pan is not hot", "the timer rings"]
)
def test_the_contrary_of_a_clause_is_that_it_is_not_so(text: str) -> None:
    clause = Condition(text=text, negated=denies(text))
    other = replace(clause, negated=not clause.negated, contrary=True)
    formula = understand(clause, TABLES).formula
    assert formula is not None
    assert understand(other, TABLES).formula == Not(formula)


def test_a_distance_counts_from_a_number_too() -> None:
    anchor = Anchor(
        text="the pan reaches 180 degrees",
        object="the pan",
        lag=300.0,
        exact=True,
        comparisons=(Comparison(text="reaches 180", side=Side.AT, number=180, behind="degrees"),),
    )
    text = "five minutes after the pan reaches 180 degrees"
    later = said(Constraint.AFTER, text, preposition="after", anchor=anchor)
    best = holding(later, Context.of({"pan_temp": 200})).satisfaction.best
    assert best.low <= 300 <= best.high
