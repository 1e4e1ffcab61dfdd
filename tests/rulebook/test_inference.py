"""Rules over context choose models and parameters, continuously, and say what they did."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.context import Context, Reading
from fuzzytime.errors import FuzzytimeError
from fuzzytime.requirement import Unit
from fuzzytime.rulebook import Resolution, Rulebook
from fuzzytime.rulebook.resolving.inference import takagi_sugeno
from fuzzytime.satisfaction import Trapezoid
from rulebook.books import book
from rulebook.requirements_of import ahead, word

SIGNALS = """
signals:
  heat: {unit: degC, range: [0, 100]}
  load: {range: [0, 10]}
variables:
  heat: {of: heat, terms: {high: {rising: [20, 80]}, low: {falling: [20, 80]}, top: {rising: [100, 100]}}}
  load: {of: load, terms: {high: {rising: [0, 10]}}}
"""


def rule(text: str) -> str:
    return f"rules:\n  - {{{text}}}\n"


def test_two_rules_with_weights_1_and_a_half_and_outputs_0_and_10_give_3_3333(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS
        + """
rules:
  - {name: one, on: {cue: soon}, if: heat is high, then: {model: soon, t: 0 s}}
  - {name: other, on: {cue: soon}, if: heat is high, then: {model: soon, t: 10 s}, weight: 0.5}
""",
    )
    resolution = rulebook.resolve(word("soon"), Context.of({"heat": 80.0}))
    assert resolution.parameters["t"] == pytest.approx(10 / 3)
    assert [round(share.share, 4) for share in resolution.shares] == [0.0, 0.6667, 0.3333]


def test_takagi_sugeno_is_a_weighted_mean_over_many_rows() -> None:
    rng = np.random.default_rng(1)
    weights, outputs = rng.random((50, 10_000)), rng.random((50, 1))
    expected = np.array(
        [np.average(outputs[:, 0], weights=weights[:, row]) for row in range(0, 10_000, 1000)]
    )
    np.testing.assert_allclose(takagi_sugeno(weights, outputs)[::1000], expected, atol=1e-12)


ONE_RULE = (
    SIGNALS
    + """
rules:
  - {name: hurry, on: {cue: soon}, if: heat is high, then: {model: soon, t: 1 min}}
"""
)


def test_the_table_s_row_takes_part_with_what_the_rules_leave(tmp_path: Path) -> None:
    rulebook = book(tmp_path, ONE_RULE)
    resolution = rulebook.resolve(word("soon"), Context.of({"heat": 50.0}))
    assert resolution.parameters["t"] == pytest.approx(0.5 * 60 + 0.5 * 300)
    row, hurry = resolution.shares
    assert (row.name, row.share) == ("soon", 0.5)
    assert (hurry.name, hurry.share, hurry.degree.low) == ("hurry", 0.5, 0.5)
    assert hurry.source == f"{tmp_path / 'mine.yaml'}:11"
    assert [(atom.text, atom.reading, atom.unit) for atom in hurry.atoms] == [("heat is high", 50.0, "degC")]


def test_without_a_reading_a_rule_is_silent_and_not_even_listed(tmp_path: Path) -> None:
    rulebook = book(tmp_path, ONE_RULE)
    resolution = rulebook.resolve(word("soon"), Context.of({"load": 3.0}))
    assert resolution == rulebook.resolve(word("soon"))
    assert [share.name for share in resolution.shares] == ["soon"]


def test_where_no_rule_speaks_the_table_s_row_stands_and_it_is_said(tmp_path: Path) -> None:
    resolution = book(tmp_path, ONE_RULE).resolve(word("soon"), Context.of({"heat": 10.0}))
    assert resolution.parameters["t"] == 300
    assert resolution.notes == ("no rule over context speaks: the table's row 'soon' stands",)


@pytest.fixture(scope="module")
def hurried(tmp_path_factory: pytest.TempPathFactory) -> Rulebook:
    return book(tmp_path_factory.mktemp("tables"), ONE_RULE)


@given(heat=st.floats(0, 99.9), size=st.floats(-1, 1))
def test_a_small_change_of_a_reading_changes_psi_a_little(
    hurried: Rulebook, heat: float, size: float
) -> None:
    times = np.linspace(0, 1800, 200)
    near = min(max(heat + size * 1e-5, 0.0), 100.0)
    one, other = (
        hurried.resolve(word("soon"), Context.of({"heat": value})).satisfaction(times)
        for value in (heat, near)
    )
    assert np.abs(one - other).max() < 1e-4


def test_rules_that_only_scale_multiply_by_their_degree_as_exponent(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS
        + """
rules:
  - {name: looser, on: {preposition: in}, if: heat is high, then: {scale: {w: 4}}}
  - {name: later, on: {preposition: in}, if: load is high, then: {scale: {t: 2}}}
""",
    )
    plain = rulebook.resolve(ahead("in", 10))
    scaled = rulebook.resolve(ahead("in", 10), Context.of({"heat": 50.0}))
    assert scaled.parameters["w"] == pytest.approx(2 * plain.parameters["w"])
    assert scaled.shares[0].share == 1.0
    assert scaled.shares[1].scale == {"w": pytest.approx(2)}
    moved = rulebook.resolve(ahead("in", 10), Context.of({"load": 10.0}))
    assert moved.parameters["t"] == 1200


def test_another_model_wins_by_its_weight(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS + rule("name: wait, on: {cue: soon}, if: heat is high, then: {model: later, t: 20 min}"),
    )
    assert rulebook.resolve(word("soon"), Context.of({"heat": 49.0})).model == "soon"
    resolution = rulebook.resolve(word("soon"), Context.of({"heat": 51.0}))
    assert resolution.model == "later"
    assert resolution.parameters["t"] == 1200
    assert [share.share for share in resolution.shares] == [0.0, 1.0]


def test_a_width_that_a_rule_sets_is_mixed_with_the_law_s(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS + rule("name: strict, on: {preposition: in}, if: heat is high, then: {w: 1 min}"),
    )
    law = rulebook.resolve(ahead("in", 10)).parameters["w"]
    resolution = rulebook.resolve(ahead("in", 10), Context.of({"heat": 50.0}))
    assert resolution.parameters["w"] == pytest.approx(0.5 * 60 + 0.5 * law)
    assert resolution.model == "in"


def test_a_rule_without_a_condition_always_speaks(tmp_path: Path) -> None:
    rulebook = book(tmp_path, rule("name: mine, on: {cue: soon}, then: {model: soon, t: 2 min}"))
    assert rulebook.resolve(word("soon")).parameters["t"] == 120


@pytest.mark.parametrize(
    ("match", "verb", "speaks"),
    [
        ("{cue: soon}", None, True),
        ("{cue: later}", None, False),
        ("{verb: [flip, turn]}", "flip", True),
        ("{verb: flip}", "boil", False),
        ("{verb: flip}", None, False),
        ("{constraint: vague, reference: start}", None, True),
        ("{constraint: at}", None, False),
        ("{word: SOON}", None, True),
        ("{}", None, True),
    ],
)
def test_on_says_what_a_rule_speaks_about(tmp_path: Path, match: str, verb: str | None, speaks: bool) -> None:  # noqa: FBT001
    rulebook = book(tmp_path, rule(f"name: r, on: {match}, then: {{model: soon, t: 2 min}}"))
    assert (len(rulebook.resolve(word("soon"), verb=verb).shares) == 2) is speaks


def test_on_may_name_hedge_number_and_unit(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        rule("name: r, on: {hedge: about, number: 10, unit: minute}, then: {scale: {w: 2}}"),
    )
    assert len(rulebook.resolve(ahead("in", 10, Unit.MINUTE, "about")).shares) == 2
    assert len(rulebook.resolve(ahead("in", 11, Unit.MINUTE, "about")).shares) == 1
    assert len(rulebook.resolve(ahead("in", 10)).shares) == 1


def test_unknown_readings_give_an_interval_and_the_lower_bound_decides(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS
        + rule("name: r, on: {cue: soon}, if: heat is high or load is high, then: {model: soon, t: 0 s}"),
    )
    resolution = rulebook.resolve(word("soon"), Context.of({"heat": 50.0}))
    share = resolution.shares[1]
    assert (share.degree.low, share.degree.high) == (0.5, 1.0)
    assert share.share == 0.5
    assert share.atoms[1].reading is None
    assert "the rule 'r' misses readings of load" in resolution.notes


@pytest.mark.parametrize(
    ("norm", "both", "either"), [("min", 0.25, 0.5), ("product", 0.125, 0.625), ("lukasiewicz", 0.0, 0.75)]
)
def test_tables_choose_how_degrees_are_joined(tmp_path: Path, norm: str, both: float, either: float) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS
        + f"""
options: {{and: {norm}}}
rules:
  - {{name: both, on: {{cue: soon}}, if: heat is high and load is high, then: {{model: soon, t: 0 s}}}}
  - {{name: either, on: {{cue: later}}, if: heat is high or load is high, then: {{model: later, t: 0 s}}}}
""",
    )
    context = Context.of({"heat": 50.0, "load": 2.5})
    assert rulebook.resolve(word("soon"), context).shares[1].degree.low == pytest.approx(both)
    assert rulebook.resolve(word("later"), context).shares[1].degree.low == pytest.approx(either)


def test_a_later_file_replaces_a_rule_of_the_same_name(tmp_path: Path) -> None:
    first, second = tmp_path / "first.yaml", tmp_path / "second.yaml"
    first.write_text("fuzzytime: 1\nrules: [{name: r, on: {cue: soon}, then: {model: soon, t: 1 min}}]\n")
    second.write_text("fuzzytime: 1\nrules: [{name: r, on: {cue: soon}, then: {model: soon, t: 2 min}}]\n")
    resolution = Rulebook.shipped(files=[first, second]).resolve(word("soon"))
    assert resolution.parameters["t"] == 120
    assert resolution.shares[1].source == f"{second}:2"


def test_a_file_may_speak_of_what_another_declares(tmp_path: Path) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_text("fuzzytime: 1\nrules: [{on: {cue: soon}, if: pan is hot, then: {model: soon, t: 7 s}}]\n")
    resolution = Rulebook.shipped(files=[mine]).resolve(word("soon"), Context.of({"pan_temp": 200.0}))
    assert f"{mine}:2" in [share.name for share in resolution.shares]


def test_a_window_of_time_looks_at_what_was_read(tmp_path: Path) -> None:
    rulebook = book(
        tmp_path,
        SIGNALS
        + rule("name: r, on: {cue: soon}, if: heat is high mostly in the last 10 min, then: {scale: {t: 2}}"),
    )

    def degree(context: Context) -> float:
        return rulebook.resolve(word("soon"), context).shares[1].degree.low

    long_hot = Context.of({"heat": [(-700, 80), (0, 80)]})
    just_hot = Context.of({"heat": [(-700, 20), (-61, 20), (-60, 80), (0, 80)]})
    young = Context.of({"heat": [(-60, 80), (0, 80)]})
    assert degree(long_hot) == 1.0
    assert degree(just_hot) == 0.0
    assert degree(young) == 0.0
    share = rulebook.resolve(word("soon"), young).shares[1]
    assert share.degree.high == 1.0


def resolution_of(rulebook: Rulebook, readings: dict[str, float]) -> Resolution:
    return rulebook.resolve(word("soon"), Context.of(readings))


def test_a_crisp_term_holds_at_its_edge(tmp_path: Path) -> None:
    rulebook = book(tmp_path, SIGNALS + rule("on: {cue: soon}, if: heat is top, then: {model: soon, t: 0 s}"))
    assert resolution_of(rulebook, {"heat": 100.0}).parameters["t"] == 0
    assert resolution_of(rulebook, {"heat": 99.99}).parameters["t"] == 300


def test_a_context_that_no_table_declares_is_refused() -> None:
    with pytest.raises(FuzzytimeError, match="unknown signal 'pan_tmp' \\(did you mean 'pan_temp'"):
        Rulebook.shipped().resolve(word("soon"), Context.of({"pan_tmp": 1.0}))


@pytest.mark.parametrize("duration", [-1.0, float("inf"), float("nan")])
def test_durations_must_be_finite(duration: float) -> None:
    with pytest.raises(FuzzytimeError, match="a duration must be finite"):
        Rulebook.shipped().resolve(word("soon"), duration=duration)


def test_readings_in_other_units_say_the_same() -> None:
    rulebook = Rulebook.shipped()
    fahrenheit = rulebook.resolve(word("soon"), Context.of({"pan_temp": "392 degF"}))
    celsius = rulebook.resolve(word("soon"), Context((Reading("pan_temp", 0.0, 200.0, "degC"),)))
    assert isinstance(celsius.satisfaction, Trapezoid)
    assert fahrenheit.parameters == pytest.approx(celsius.parameters)
