import re
from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook import Actor, Profile, Rulebook, check
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study import Answers, Design, Population, StudyInstruction, calibrate, rule_table, simulate
from fuzzytime.study.asking.questions import Timeline
from fuzzytime.study.calibration.breakpoints import Breakpoint, explained
from study.truths import half_base, truth

CONSTRAINTS = {"in": Constraint.AT, "before": Constraint.BEFORE, "after": Constraint.AFTER}


def requirement(entry: StudyInstruction) -> TimeRequirement:
    """Say what an instruction of the study says, as the language would."""
    worded = entry.word is not None
    return TimeRequirement(
        text=entry.text,
        span=(0, len(entry.text)),
        constraint=Constraint.VAGUE if entry.word == "soon" else CONSTRAINTS[entry.preposition],
        preposition=None if worded else entry.preposition,
        word=entry.word,
        fuzziness=(entry.fuzziness,) if entry.fuzziness is not None and not worded else (),
        t_spec=None if entry.word == "soon" else entry.t_spec,
    )


def ahead(t_spec: float) -> TimeRequirement:
    return TimeRequirement(
        text="in a time", span=(0, 9), constraint=Constraint.AT, preposition="in", t_spec=t_spec
    )


def tables(answers: Answers, folder: Path, actor: Actor | None = None) -> Rulebook:
    path = folder / "mine.yaml"
    path.write_text(rule_table(calibrate(answers)), encoding="utf-8")
    assert check([path]) == ()
    return Rulebook.shipped(actor=actor, files=[path])


@pytest.mark.parametrize("profile", list(Profile))
def test_a_table_calibrated_on_simulated_answers_is_the_truth_again(
    design: Design, tmp_path: Path, profile: Profile
) -> None:
    true = Rulebook.shipped(profile)

    def shown(entry: StudyInstruction, _group: str) -> object:
        return true.resolve(requirement(entry)).satisfaction

    found = tables(simulate(design, shown, 32, seed=4), tmp_path)  # type: ignore[arg-type]
    times = design.timeline.times
    for entry in design.instructions:
        meant = true.resolve(requirement(entry)).satisfaction(times)
        calibrated = found.resolve(requirement(entry)).satisfaction(times)
        assert np.sqrt(((calibrated - meant) ** 2).mean()) < 0.015, entry.key


def test_the_law_between_the_times_asked_is_the_truths(answers: Answers, tmp_path: Path) -> None:
    found = tables(answers, tmp_path)
    said = ahead(1200.0)
    low, high = found.resolve(said).satisfaction.support.low, found.resolve(said).satisfaction.support.high
    assert 1200 - low == pytest.approx(half_base(1200), rel=0.03)
    assert high - 1200 == pytest.approx(half_base(1200), rel=0.03)


def test_groups_that_differ_give_factors_for_actors(design: Design, tmp_path: Path) -> None:
    population = Population(group_widths={"person": 1.3, "robot": 0.8})
    different = simulate(design, truth, 32, seed=2, population=population)
    said = ahead(1800.0)

    def base(actor: Actor | None) -> float:
        return tables(different, tmp_path, actor).resolve(said).satisfaction.support.length

    assert base(Actor.PERSON) / base(Actor.ROBOT) == pytest.approx(1.3 / 0.8, rel=0.1)
    assert "groups differ" in (tmp_path / "mine.yaml").read_text()


def test_groups_that_do_not_differ_are_planned_alike(answers: Answers, tmp_path: Path) -> None:
    robot, person = (tables(answers, tmp_path, actor) for actor in (Actor.ROBOT, Actor.PERSON))
    assert robot.tables.actors[Actor.ROBOT](1800.0) == person.tables.actors[Actor.PERSON](1800.0) == 1
    assert "no difference found" in (tmp_path / "mine.yaml").read_text()


def test_every_number_says_where_it_comes_from(answers: Answers) -> None:
    text = rule_table(calibrate(answers))
    assert text.count("32 participants (16 robot, 16 person)") >= 8
    assert "prediction error (SSE) 0.00" in text
    assert "permutation test p = " in text


def test_a_study_of_one_preposition_gives_a_table_too(design: Design, tmp_path: Path) -> None:
    for preposition in ("in", "after", "before"):
        asked = tuple(e for e in design.instructions if e.preposition == preposition and not e.word)
        found = tables(simulate(replace(design, instructions=asked), truth, 8), tmp_path)
        for entry in asked:
            meant, calibrated = truth(entry), found.resolve(requirement(entry)).satisfaction
            times = design.timeline.times
            assert np.abs(calibrated(times) - meant(times)).mean() < 0.01


def without(answers: Answers, keys: Collection[str]) -> Answers:
    """Give the answers of people who draw nothing for some instructions."""
    people = tuple(
        replace(person, curves={**person.curves, **dict.fromkeys(keys, np.zeros(800))})
        for person in answers.participants
    )
    return Answers(replace(answers.design, attention=None), people)


def test_a_median_that_is_0_everywhere_is_left_out_and_named(design: Design, tmp_path: Path) -> None:
    answers = without(simulate(design, truth, 4), {"soon", "after-30"})
    found = calibrate(answers)
    assert found.left_out == ("soon", "after-30")
    assert found.cautions == ("the median is 0 everywhere, and left out, for: soon, after-30",)
    assert set(found.words) == {"now"}
    assert f"# Caution: {found.cautions[0]}.\n" in rule_table(found)
    tables(answers, tmp_path)


def test_medians_that_are_all_0_give_no_table(design: Design) -> None:
    answers = without(simulate(design, truth, 4), {entry.key for entry in design.instructions})
    with pytest.raises(FuzzytimeError, match="nothing to calibrate"):
        calibrate(answers)


def test_half_hearted_people_give_a_table_with_a_caution(design: Design, tmp_path: Path) -> None:
    drawn = simulate(design, truth, 6)
    people = tuple(
        replace(person, curves={key: 0.4 * curve for key, curve in person.curves.items()})
        for person in drawn.participants
    )
    answers = Answers(drawn.design, people)
    found = calibrate(answers)
    assert set(found.poor) >= {"in-10", "in-30", "after-10"}
    assert "a trapezoid fits the median badly (R² below 0.9) for: " in found.cautions[0]
    tables(answers, tmp_path)


def test_widths_of_hours_are_written_as_durations(design: Design, tmp_path: Path) -> None:
    day = replace(
        design,
        timeline=Timeline(0.0, 24 * 3600.0, 800),
        attention=None,
        instructions=(replace(design.instruction("in-10"), t_spec=10 * 3600.0),),
    )
    wide = Trapezoid(0.0, 6 * 3600.0, 14 * 3600.0, 20 * 3600.0)
    answers = simulate(day, {"in-10": wide}, 6)
    assert re.search(r"points: \{600 min: 3\d{4} s\}", rule_table(calibrate(answers)))
    assert tables(answers, tmp_path).resolve(ahead(36000.0)).satisfaction.support.length > 19 * 3600


def test_people_who_contradict_each_other_give_a_table_that_can_be_read(
    design: Design, tmp_path: Path
) -> None:
    times = design.timeline.times
    people = tuple(
        replace(
            person,
            curves={
                entry.key: np.asarray(
                    times < entry.t_spec + 120 if place % 2 else times > entry.t_spec - 120, np.float64
                )
                for entry in design.instructions
            },
        )
        for place, person in enumerate(simulate(design, truth, 8).participants)
    )
    answers = Answers(design, people)
    assert calibrate(answers).cautions
    tables(answers, tmp_path)


@given(st.floats(-500, 500), st.floats(0, 5))
def test_lengths_are_explained_within_the_tolerance(constant: float, share: float) -> None:
    widths = [113.0, 115.0, 133.0, 174.0]
    found = explained([constant + share * w for w in widths], widths, 4.5)
    for w in widths:
        assert found.value(0.0, w) == pytest.approx(constant + share * w, abs=4.5)


def test_whoever_is_more_lenient_does_not_mean_less() -> None:
    widths = [113.0, 115.0, 133.0, 174.0]
    assert explained([500 - 2 * w for w in widths], widths, 1.0).width == 0
    assert explained([0, 10, 0, 12], [120, 121, 122, 123], 1.0).constant in (0, 5.5)


def test_the_simplest_explanation_is_taken() -> None:
    widths = [113.0, 115.0, 133.0, 174.0]
    assert explained([0.5, -1, 1, 0], widths, 4.5) == Breakpoint(0.0)
    assert explained([192, 193, 191, 192], widths, 4.5) == Breakpoint(192.0)
    assert explained([0.4 * w for w in widths], widths, 4.5).text == "0.4w"
    assert explained([0.9 * w - 60 for w in widths], widths, 1.0).text == "0.9w - 60 s"


@pytest.mark.parametrize(
    ("corner", "text"),
    [
        (Breakpoint(0.0), "0 s"),
        (Breakpoint(-12.5), "-12.5 s"),
        (Breakpoint(0.0, 1.0, -1.0), "t - w"),
        (Breakpoint(3.0, 0.0, -0.5), "-0.5w + 3 s"),
        (Breakpoint(float("inf")), "inf"),
        (Breakpoint(1e-9, 1.0, 0.9999), "t + w"),
    ],
)
def test_sums_are_written_as_rule_tables_read_them(corner: Breakpoint, text: str) -> None:
    assert corner.text == text
