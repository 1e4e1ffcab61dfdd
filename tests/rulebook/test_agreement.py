"""Rows of earlier files live with what later files lay over them, or a mistake says why not."""

import re
from pathlib import Path

import pytest

from fuzzytime.context import Context
from fuzzytime.errors import DocumentError
from fuzzytime.requirement import Condition, Constraint, TimeRequirement
from fuzzytime.rulebook import Rulebook, check
from fuzzytime.rulebook.tables.variables import Term

HOT = TimeRequirement(
    text="when the pan is hot",
    span=(0, 19),
    constraint=Constraint.WHEN,
    preposition="when",
    condition=Condition(text="the pan is hot", subject="the pan", word="hot"),
)


def with_table(tmp_path: Path, *texts: str) -> Rulebook:
    files = []
    for number, text in enumerate(texts):
        files.append(tmp_path / f"table{number}.yaml")
        files[-1].write_text(f"fuzzytime: 1\n{text}\n", encoding="utf-8")
    return Rulebook.shipped(files=files)


@pytest.mark.parametrize(
    ("text", "key", "message"),
    [
        (
            "variables:\n  pan: {of: pan_temp, terms: {scorching: {rising: [250, 280]}}}",
            "variables.pan",
            (
                "must have the term 'hot', for which the rules "
                "'flip-when-hot' (…) and 'soon-on-a-hot-pan' (…) ask"
            ),
        ),
        (
            "signals:\n  pan_temp: {event: true}",
            "signals.pan_temp",
            "must not be an event, as the variable 'pan' (…) looks at its values",
        ),
        (
            "signals:\n  rice_on: {unit: kg}",
            "signals.rice_on",
            "must be an event, as the variable 'rice' (…) counts from it",
        ),
        (
            "signals:\n  pan_temp: {unit: kg}",
            "signals.pan_temp",
            "must be measured in what converts to 'degC', as the variable 'pan' (…) is",
        ),
    ],
)
def test_what_a_row_below_needs_must_stay(tmp_path: Path, text: str, key: str, message: str) -> None:
    with pytest.raises(DocumentError) as caught:
        with_table(tmp_path, text)
    (mistake,) = caught.value.mistakes
    assert (mistake.place, mistake.key) == (f"{tmp_path / 'table0.yaml'}:3:3", key)
    assert re.sub(r"rules/kitchen.yaml:\d+", "…", mistake.message) == message


def test_a_term_may_go_with_the_rules_that_ask_for_it(tmp_path: Path) -> None:
    rulebook = with_table(
        tmp_path,
        """variables:
  pan: {of: pan_temp, words: [pan], terms: {scorching: {rising: [250, 280]}}}
rules:
  - {name: flip-when-hot, if: pan is scorching, then: {scale: {w: 1}}, on: {cue: soon}}
  - {name: soon-on-a-hot-pan, if: pan is scorching, then: {scale: {w: 1}}, on: {cue: soon}}""",
    )
    reason = rulebook.resolve(HOT, Context.of({"pan_temp": 200.0})).reason
    assert reason == "'the pan' has no term 'hot' (known: scorching)"


@pytest.mark.parametrize("now", [100.0, 175.0, 185.0, 240.0])
def test_a_signal_in_another_unit_means_the_same(tmp_path: Path, now: float) -> None:
    course = "forecast: {model: approach, set_point: %s, time_constant: 150 s, spread: 1.6, horizon: 15 min}"
    celsius = with_table(
        tmp_path, f"signals:\n  pan_temp: {{unit: degC, range: [0, 350], {course % '230 degC'}}}"
    )
    fahrenheit = with_table(
        tmp_path, f"signals:\n  pan_temp: {{unit: degF, range: [0 degC, 350 degC], {course % '230 degC'}}}"
    )
    in_fahrenheit = now * 9 / 5 + 32
    one = celsius.resolve(HOT, Context.of({"pan_temp": now}))
    other = fahrenheit.resolve(HOT, Context.of({"pan_temp": in_fahrenheit}))
    times = [0.0, 60.0, 120.0, 240.0, 480.0, 900.0]
    assert other.satisfaction(times).tolist() == pytest.approx(one.satisfaction(times).tolist(), abs=1e-6)


def test_rates_have_no_zero_of_their_own(tmp_path: Path) -> None:
    rulebook = with_table(tmp_path, "signals:\n  pan_temp: {unit: degF}")
    before = Rulebook.shipped().tables.variables["pan_trend"].terms["rising"]
    after = rulebook.tables.variables["pan_trend"].terms["rising"]
    assert after.corners[:2] == pytest.approx([corner * 9 / 5 for corner in before.corners[:2]])


def test_a_file_s_own_unit_holds_for_its_own_terms_whatever_a_later_one_says(tmp_path: Path) -> None:
    first = "signals:\n  kiln: {unit: degC}\nvariables:\n  kiln: {of: kiln, terms: {hot: {rising: [0, 100]}}}"
    rulebook = with_table(tmp_path, first, "signals:\n  kiln: {unit: degF}")
    term = rulebook.tables.variables["kiln"].terms["hot"]
    assert isinstance(term, Term)
    assert term.corners[:2] == pytest.approx([32.0, 212.0])


def test_a_wrong_row_is_one_mistake(tmp_path: Path) -> None:
    file = tmp_path / "wrong.yaml"
    file.write_text(
        "fuzzytime: 1\nsignals:\n  bell: {event: true}\n"
        "variables:\n  ringing: {of: bell, terms: {loud: {rising: [1, 2]}}}\n"
        "rules:\n  - {if: ringing is loud, then: {t: 1 min}}\n",
        encoding="utf-8",
    )
    assert [mistake.message for mistake in check([file])] == [
        "'of' needs a signal with values, got the event 'bell'"
    ]
