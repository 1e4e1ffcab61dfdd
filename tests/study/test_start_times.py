import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import Answers, influence_of_start_times
from fuzzytime.study.analysis.density import SQUARE_MINUTE


def test_the_ratio_of_the_paper_comes_out_of_a_study_with_its_law(answers: Answers) -> None:
    drawn = answers.subjective()
    keys = ("in-30", "in-now", "in-1", "in-10")
    found = influence_of_start_times(
        [answers.design.instruction(key).t_spec for key in keys], [drawn[key] for key in keys]
    )
    assert found.t_spec.tolist() == [0, 60, 600, 1800]
    assert found.increasing
    assert (found.variances / SQUARE_MINUTE).tolist() == pytest.approx([0.197, 0.505, 0.955, 1.63], rel=0.1)
    assert found.ratio == pytest.approx(8.274, rel=0.1)
    assert found.growth > 0


def test_times_must_differ_and_fit(answers: Answers) -> None:
    drawn = list(answers.subjective().values())
    with pytest.raises(FuzzytimeError, match="two instructions or more"):
        influence_of_start_times([0.0], drawn[:1])
    with pytest.raises(FuzzytimeError, match="two instructions or more"):
        influence_of_start_times([0.0, 1.0], drawn[:1])
    with pytest.raises(FuzzytimeError, match="must differ"):
        influence_of_start_times([60.0, 60.0], drawn[:2])
