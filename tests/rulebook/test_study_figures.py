"""The paper's figures hold in the study profile (its section IV; units inferred: variances in min²)."""

import numpy as np
import pytest

from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.rulebook import Actor, Profile, Rulebook
from fuzzytime.satisfaction import SatisfactionFunction, Trapezoid
from rulebook.requirements_of import ahead, said, word

NOW = said(Constraint.AT, "now", word="now", t_spec=0.0)
STUDY = Rulebook.shipped(Profile.STUDY)


def variance(function: SatisfactionFunction) -> float:
    """Variance of ψ as a density over t ≥ 0, in min²."""
    times = np.linspace(0.0, 3600.0, 36_001)
    density = function(times)
    mean = np.average(times, weights=density)
    return float(np.average((times - mean) ** 2, weights=density)) / 3600.0


def psi(requirement: TimeRequirement, actor: Actor | None = None) -> SatisfactionFunction:
    rulebook = STUDY if actor is None else Rulebook.shipped(Profile.STUDY, actor)
    return rulebook.resolve(requirement).satisfaction


@pytest.mark.parametrize(
    ("requirement", "figure"),
    [(NOW, 0.197), (ahead("in", 1), 0.505), (ahead("in", 10), 0.955), (ahead("in", 30), 1.63)],
    ids=["now", "1 min", "10 min", "30 min"],
)
def test_variance_of_in_is_the_study_s(requirement: TimeRequirement, figure: float) -> None:
    assert variance(psi(requirement)) == pytest.approx(figure, rel=0.02)


def test_variance_grows_by_the_study_s_ratio() -> None:
    assert variance(psi(ahead("in", 30))) / variance(psi(NOW)) == pytest.approx(8.274, rel=0.02)


def test_variance_grows_with_the_time_named() -> None:
    variances = [variance(psi(ahead("in", minutes))) for minutes in np.linspace(0.5, 30, 8).tolist()]
    assert variances == sorted(variances)


def test_half_base_eight_hours_ahead_is_eighteen_minutes() -> None:
    assert STUDY.resolve(ahead("in", 8, Unit.HOUR)).parameters["w"] == pytest.approx(18 * 60, rel=0.02)


@pytest.mark.parametrize("minutes", [1, 10, 30])
def test_plateau_of_in_encloses_the_time_named(minutes: int) -> None:
    best = psi(ahead("in", minutes)).best
    assert best.low < 60 * minutes < best.high


@pytest.mark.parametrize("minutes", [1, 10, 30])
def test_before_the_next_is_full_from_the_start_to_the_time_named(minutes: int) -> None:
    function = psi(ahead("before the next", minutes))
    assert isinstance(function, Trapezoid)
    assert function.best.low == 0.0
    assert function.best.high == 60 * minutes
    assert function.support.high > 60 * minutes


@pytest.mark.parametrize("minutes", [1, 10, 30])
def test_after_is_full_from_the_time_named_with_the_study_s_margin_of_5_4_seconds(minutes: int) -> None:
    assert psi(ahead("after", minutes)).best.low == pytest.approx(60 * minutes, abs=5.4)


def test_after_has_the_study_s_mean_gradients() -> None:
    functions = [psi(ahead("after", minutes)) for minutes in (1, 10, 30)]
    corners = np.array([list(function.parameters.values()) for function in functions]) / 60
    assert np.mean(1 / (corners[:, 1] - corners[:, 0])) == pytest.approx(5.946, rel=1e-3)
    assert np.mean(1 / (corners[:, 3] - corners[:, 2])) == pytest.approx(0.312, rel=1e-3)


def test_after_has_its_right_maximum_beyond_the_time_named() -> None:
    assert psi(ahead("after", 10)).best.high > 610


def test_soon_is_approximately_now() -> None:
    approximately = said(Constraint.AT, word="now", fuzziness=("approximately",), t_spec=0.0)
    assert psi(word("soon")) == psi(approximately)


def test_approximately_widens() -> None:
    assert variance(psi(ahead("in", 10, Unit.MINUTE, "approximately"))) > variance(psi(ahead("in", 10)))


@pytest.mark.parametrize(("actor", "figure"), [(Actor.ROBOT, 1.171), (Actor.PERSON, 1.805)])
def test_actors_have_the_study_s_variance_in_thirty_minutes(actor: Actor, figure: float) -> None:
    assert variance(psi(ahead("in", 30), actor)) == pytest.approx(figure, rel=0.02)


def test_actors_differ_by_the_study_s_variance_in_one_minute() -> None:
    person, robot = (variance(psi(ahead("in", 1), actor)) for actor in (Actor.PERSON, Actor.ROBOT))
    assert person - robot == pytest.approx(-0.606, rel=0.02)


@pytest.mark.parametrize("requirement", [NOW, ahead("in", 1), ahead("in", 10)])
def test_robots_are_given_more_room_up_to_ten_minutes(requirement: TimeRequirement) -> None:
    assert variance(psi(requirement, Actor.ROBOT)) > variance(psi(requirement, Actor.PERSON))


@pytest.mark.parametrize(
    ("hedge", "number", "low", "high"), [("a few", 3, 3, 5.75), ("several", 7, 4, 10), ("a couple", 2, 2, 3)]
)
def test_vague_numbers_are_full_over_the_survey_s_range(
    hedge: str, number: float, low: float, high: float
) -> None:
    best = psi(ahead("in", number, Unit.MINUTE, hedge)).best
    assert best.low <= 60 * low
    assert best.high >= 60 * high


def test_a_hedge_widens_a_round_number_less() -> None:
    round_number = STUDY.resolve(ahead("in", 10, Unit.MINUTE, "about"))
    other_number = STUDY.resolve(ahead("in", 7, Unit.MINUTE, "about"))
    assert other_number.hedges[0].factor > round_number.hedges[0].factor > 1
