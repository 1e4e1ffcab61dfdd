from dataclasses import replace

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Rectangle, Trapezoid
from fuzzytime.study import Answers, Design, Hand, Model, Population, StudyInstruction, fit, simulate
from study.truths import truth


@pytest.mark.parametrize("seed", range(3))
def test_the_corners_of_the_truth_are_recovered_within_five_seconds(design: Design, seed: int) -> None:
    for key, drawn in simulate(design, truth, 32, seed=seed).subjective().items():
        meant = truth(design.instruction(key))
        assert isinstance(meant, Trapezoid)
        found = fit(drawn.times, drawn.median, Model.TRAPEZOID).function
        assert isinstance(found, Trapezoid)
        for corner, true in zip(found.corners, meant.corners, strict=True):
            # Nobody can draw a corner before the instruction is given.
            assert max(corner, 0.0) == pytest.approx(max(true, 0.0), abs=5.0)


def test_the_same_seed_gives_the_same_answers_another_one_others(design: Design, answers: Answers) -> None:
    def curves(answers: Answers) -> np.ndarray:
        return np.array([list(person.curves.values()) for person in answers.participants])

    assert (curves(simulate(design, truth, 32, seed=1)) == curves(answers)).all()
    assert (curves(simulate(design, truth, 32, seed=2)) != curves(answers)).any()


def test_without_hand_and_differences_everybody_draws_the_truth(design: Design) -> None:
    steady = Population(individual=0.0, hand=Hand(time=0.0, satisfaction=0.0))
    person = simulate(design, truth, 1, population=steady).participants[0]
    for entry in design.instructions:
        meant = truth(entry)(design.timeline.times)
        assert person.curves[entry.key] == pytest.approx(meant, abs=1 / 600 + 1e-9)


def test_curves_are_satisfactions_and_untouched_where_there_is_nothing_to_draw(answers: Answers) -> None:
    times = answers.design.timeline.times
    for person in answers.participants:
        for curve in person.curves.values():
            assert curve.min() >= 0
            assert curve.max() <= 1
        assert (person.curves["in-now"][times > 400] == 0).all()


def test_groups_and_orders_are_shared_out(answers: Answers) -> None:
    assert sorted(person.group for person in answers.participants) == ["person"] * 16 + ["robot"] * 16
    orders = {person.order for person in answers.participants}
    assert len(orders) == 32
    assert {frozenset(order) for order in orders} == {frozenset(answers.participants[0].curves)}


def test_answers_about_the_participant_are_those_that_the_page_would_take(answers: Answers) -> None:
    given = 0
    for person in answers.participants:
        for key, answer in person.demographics.items():
            assert answers.design.question(key).checked(answer) == answer
            given += 1
        assert person.control in range(1, 6)
    assert 3 * 32 * 0.8 < given < 3 * 32


def test_a_group_may_be_wider(design: Design) -> None:
    wide = simulate(design, truth, 32, population=Population(group_widths={"person": 2.0}))
    medians = {group: wide.subjective(group)["in-30"].median.sum() for group in ("robot", "person")}
    assert medians["person"] / medians["robot"] == pytest.approx(2.0, rel=0.2)


def test_a_truth_may_differ_between_groups(design: Design) -> None:
    def by_group(entry: StudyInstruction, group: str) -> Rectangle:
        return Rectangle(0, 3600) if group == "robot" else Rectangle(entry.t_spec, entry.t_spec + 300)

    drawn = simulate(design, by_group, 8)
    assert drawn.subjective("robot")["in-30"].median[200] == 1
    assert drawn.subjective("person")["in-30"].median[200] == 0


def test_the_inattentive_are_caught_by_the_attention_check(design: Design) -> None:
    drawn = simulate(design, truth, 12, population=Population(inattentive=3))
    assert len(drawn.set_aside) == 3


@pytest.mark.parametrize(
    "spread", [{"individual": -1.0}, {"group_widths": {"person": 0.0}}, {"inattentive": -1}]
)
def test_impossible_populations_are_refused(spread: dict[str, object]) -> None:
    with pytest.raises(FuzzytimeError, match="must be"):
        Population(**spread)  # type: ignore[arg-type]


def test_impossible_hands_are_refused() -> None:
    with pytest.raises(FuzzytimeError, match="error in time"):
        Hand(time=-1.0)
    with pytest.raises(FuzzytimeError, match="smoothness"):
        Hand(smoothness=0.0)


def test_a_truth_or_a_group_that_does_not_fit_the_design_is_refused(design: Design) -> None:
    with pytest.raises(FuzzytimeError, match="got none for 'in-now'"):
        simulate(design, {"soon": Rectangle(0, 60)})
    with pytest.raises(FuzzytimeError, match="one of robot, person, got 'dog'"):
        simulate(design, truth, population=Population(group_widths={"dog": 1.0}))
    with pytest.raises(FuzzytimeError, match="at least one participant, got 0"):
        simulate(design, truth, 0)


def test_a_design_without_control_question_gets_no_answer_to_it(design: Design) -> None:
    assert simulate(replace(design, control=None), truth, 1).participants[0].control is None
