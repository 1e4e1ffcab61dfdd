"""A part of a condition says what tells how true it is, in words a person can act on."""

from pathlib import Path

import pytest

from fuzzytime.context import Context, Reading
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook import Resolution, Rulebook
from rulebook.books import book

SOON = TimeRequirement(text="soon", span=(0, 4), constraint=Constraint.VAGUE, word="soon")
TABLE = """
signals:
  heat: {unit: degC, range: [0, 300], max_age: 5 min, forecast: {model: linear, rate: 1, per: min}}
  queue: {unit: tasks, forecast: {model: hold, horizon: 10 min}}
  bell: {event: true}
variables:
  oven: {of: heat, terms: {hot: {rising: [100, 200]}}}
  trend: {rate_of: heat, over: 30 s, per: min, terms: {rising: {rising: [2, 10]}}}
  work: {of: queue, terms: {busy: {rising: [2, 6]}}}
  rung: {since: bell, terms: {lately: {falling: [1 min, 10 min]}}}
rules:
  - {name: r, on: {cue: soon}, if: CONDITION, then: {t: 1 min}}
"""


def heard(tmp_path: Path, condition: str, *readings: Reading) -> Resolution:
    return book(tmp_path, TABLE.replace("CONDITION", condition)).resolve(SOON, Context(readings))


def read(signal: str, *pairs: tuple[float, float | None]) -> tuple[Reading, ...]:
    return tuple(Reading(signal, at, value) for at, value in pairs)


@pytest.mark.parametrize(
    ("condition", "readings", "evidence"),
    [
        ("oven is hot", read("heat", (0, 150)), ["reading 150 °C"]),
        ("oven is hot", read("heat", (-120, 150)), ["expected 152 °C, last read 2 min ago"]),
        ("oven is hot", read("heat", (-400, 150)), ["the last reading is 6 min 40 s old, more than 5 min"]),
        ("work is busy", read("queue", (-120, 4)), ["reading 4 tasks, 2 min ago"]),
        ("work is busy", read("queue", (-900, 4)), ["the last reading is 15 min old, more than 10 min"]),
        ("trend is rising", read("heat", (-60, 100), (0, 130)), ["changes by +30 °C/min"]),
        ("trend is rising", read("heat", (-10, 100), (0, 105)), ["heat is known from 10 s ago on"]),
        ("rung is lately", read("bell", (-300, None)), ["bell 5 min ago"]),
        ("rung is lately", read("bell", (300, None)), ["bell has not happened"]),
        ("oven is hot or work is busy", read("heat", (0, 150)), ["reading 150 °C", "no reading"]),
        ("work is busy mostly in the last 2 min", read("queue", (-300, 4), (0, 4)), ["", "reading 4 tasks"]),
        (
            "(work is busy or oven is hot) mostly in the last 2 min",
            (*read("queue", (-30, 4), (0, 4)), *read("heat", (-60, 100), (0, 100))),
            [
                "queue is known from 30 s ago to 10 min ahead, heat is known from 1 min ago on",
                "reading 4 tasks",
                "reading 100 °C",
            ],
        ),
    ],
)
def test_evidence_says_what_was_read_and_when(
    tmp_path: Path, condition: str, readings: tuple[Reading, ...], evidence: list[str]
) -> None:
    atoms = heard(tmp_path, condition, *readings).shares[1].atoms
    assert [atom.evidence for atom in atoms] == evidence


def test_a_value_has_the_unit_that_it_is_told_in(tmp_path: Path) -> None:
    (atom,) = heard(tmp_path, "trend is rising", *read("heat", (-60, 100), (0, 130))).shares[1].atoms
    assert atom.reading == pytest.approx(30.0, abs=0.01)
    assert atom.unit == "°C/min"


def test_a_rule_says_that_its_last_reading_is_too_old(tmp_path: Path) -> None:
    resolution = heard(tmp_path, "oven is hot", *read("heat", (-400, 150)))
    assert resolution.notes == (
        "the rule 'r' misses readings of heat (the last is 6 min 40 s old, more than 5 min)",
        "no rule over context speaks: the table's row 'soon' stands",
    )


@pytest.mark.parametrize(
    ("condition", "readings", "reason"),
    [
        (
            "work is busy throughout the last 1 h",
            read("queue", (0, 9)),
            "cannot be told whether CONDITION: queue is known from now to 10 min ahead",
        ),
        (
            "rung is lately throughout the last 10 min",
            read("bell", (-120, None)),
            "cannot be told whether CONDITION: bell is known from 2 min ago on",
        ),
        (
            "(work is busy and work is not busy) or (work is not busy and work is busy)",
            read("queue", (0, 9)),
            "not yet: queue is at 9 tasks",
        ),
        (
            "oven is hot and oven is not hot",
            read("heat", (-60, 300), (0, 300)),
            "not yet: heat is at 300 °C",
        ),
    ],
)
def test_why_a_condition_never_comes_true(
    tmp_path: Path, condition: str, readings: tuple[Reading, ...], reason: str
) -> None:
    table = TABLE.replace("CONDITION", condition).replace("{t: 1 min}", "{model: when, core: 1 min}")
    table = table.replace("rate: 1, per: min", "horizon: 30 s").replace("linear", "hold")
    rulebook: Rulebook = book(tmp_path, table)
    assert rulebook.resolve(SOON, Context(readings)).reason == reason.replace("CONDITION", condition)
