import json
import math
from dataclasses import replace

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import Answers, Design, Model, Population, analyse, corner_intervals, simulate
from fuzzytime.study.analysis.analyse import Analysis
from fuzzytime.study.analysis.density import SQUARE_MINUTE
from fuzzytime.study.reporting.numbers import numbers
from fuzzytime.study.reporting.report import report
from study.truths import truth


@pytest.fixture(scope="module")
def analysis(answers: Answers) -> Analysis:
    return analyse(answers, permutations=99)


def test_f1_the_trapezoid_is_best_and_its_plateau_holds_the_time(analysis: Analysis) -> None:
    assert set(analysis.models) == {"in", "after", "before"}
    for found in analysis.models.values():
        assert found.best[0] == found.best[1] == found.encloses
        assert found.errors[Model.TRAPEZOID][1] < found.errors[Model.BELL][1]
    after = analysis.models["after"]
    # The paper's figures: 5.946 and 0.312 per minute, the left plateau edge within 5.4 s of the time.
    assert after.right * 60 == pytest.approx(0.312, rel=0.05)
    assert after.left * 60 == pytest.approx(5.946, rel=0.1)
    assert max(map(abs, after.left_edges)) < 5.4
    assert math.isnan(analysis.models["before"].left)


def test_f2_compares_the_second_group_with_the_first(analysis: Analysis) -> None:
    assert analysis.compared == ("person", "robot")
    assert analysis.comparison is not None
    person = analysis.by_group["person"]["in-30"].variance
    robot = analysis.by_group["robot"]["in-30"].variance
    position = list(analysis.overall).index("in-30")
    assert analysis.comparison.differences[position] == pytest.approx(person - robot)
    assert analysis.scale is not None
    assert analysis.scale.few


def test_f3_comes_for_all_and_for_each_group(analysis: Analysis) -> None:
    assert set(analysis.start_times) == {None, "robot", "person"}
    everybody = analysis.start_times[None]
    assert (everybody.variances / SQUARE_MINUTE).tolist() == pytest.approx(
        [0.197, 0.505, 0.955, 1.63], rel=0.1
    )
    assert everybody.ratio == pytest.approx(8.274, rel=0.1)


def test_subgroups_that_diverge_are_named(design: Design, answers: Answers) -> None:
    times = design.timeline.times
    patient = np.where(times >= 1800, 1.0, 0.0)
    people = tuple(
        replace(person, curves={**person.curves, "after-30": patient}) if position % 2 else person
        for position, person in enumerate(answers.participants)
    )
    assert analyse(Answers(design, people), permutations=9).divergent == ("after-30",)
    assert analyse(answers, permutations=9).divergent == ()


def test_a_sampled_function_takes_more_memory_than_a_fitted_one(analysis: Analysis) -> None:
    assert (analysis.memory.sampled_bytes, analysis.memory.fitted_bytes) == (6400, 32)


def test_a_median_that_is_0_everywhere_has_no_fits_and_breaks_nothing(design: Design) -> None:
    drawn = simulate(replace(design, attention=None), truth, 6)
    people = tuple(replace(p, curves={**p.curves, "soon": np.zeros(800)}) for p in drawn.participants)
    found = analyse(Answers(drawn.design, people), permutations=9)
    assert found.overall["soon"].fits == {}
    assert found.comparison is None
    document = json.dumps(numbers(found), allow_nan=False)
    assert '"variance_min2": null' in document


def test_one_group_or_one_person_is_analysed_as_far_as_it_goes(design: Design) -> None:
    one = analyse(simulate(replace(design, groups={"robot": "robot"}), truth, 3))
    assert one.compared is None
    assert one.comparison is None
    alone = analyse(simulate(design, truth, 1))
    assert alone.comparison is None
    assert alone.overall["soon"].fits
    json.dumps(numbers(alone), allow_nan=False)


def test_nobody_to_analyse_is_said(design: Design) -> None:
    with pytest.raises(FuzzytimeError, match="no participant"):
        analyse(Answers(design, ()))


def test_all_numbers_are_json_and_agree_with_the_analysis(analysis: Analysis) -> None:
    document = json.loads(json.dumps(numbers(analysis), allow_nan=False))
    assert document["schema"] == "fuzzytime-study-analysis/1"
    assert document["participants"]["groups"] == {"robot": 16, "person": 16}
    entry = document["instructions"]["in-30"]
    fit = analysis.overall["in-30"].fits[Model.TRAPEZOID]
    assert entry["fits"]["trapezoid"]["sse"] == pytest.approx(fit.sse, rel=1e-5)
    assert set(entry["fits"]) == {model.value for model in Model}
    assert set(entry["fits"]["trapezoid"]["parameters"]) == {
        "rise_start",
        "full_start",
        "full_end",
        "fall_end",
    }
    assert len(entry["fits"]["polynomial"]["parameters"]) == 9
    assert len(entry["characteristics"]["median"]) == len(document["times_s"]) == 800
    assert set(entry["characteristics"]) >= {"mean", "median", "mode", "deviation", "skew", "kurtosis"}
    assert document["f2"]["variance"]["difference_min2"].keys() == document["instructions"].keys()
    assert document["f3"]["all"]["t_spec_s"] == [0, 60, 600, 1800]
    assert "characteristics" not in numbers(analysis, curves=False)["instructions"]["in-30"]  # type: ignore[index]


def test_intervals_of_corners_hold_the_truth(design: Design) -> None:
    drawn = simulate(design, truth, 32, seed=3, population=Population(individual=0.3))
    entry = analyse(drawn, permutations=9).overall["in-30"]
    intervals = corner_intervals(entry, resamples=60, seed=1)
    for (low, high), true in zip(intervals, (1625.8, 1730.3, 1869.7, 1974.2), strict=True):
        assert low - 3 <= true <= high + 3
        assert 2 < high - low < 60
    few = replace(drawn.design, instructions=(drawn.design.instruction("in-30"),))
    together = analyse(Answers(few, drawn.participants), permutations=9, resamples=60, seed=1)
    assert together.intervals == {"in-30": intervals}
    assert json.loads(json.dumps(numbers(together)))["corner_intervals_s"]["in-30"][0] == pytest.approx(
        intervals[0], rel=1e-4
    )
    assert "95 % intervals" in report(together, {})
    with pytest.raises(FuzzytimeError, match="20 resamples"):
        corner_intervals(entry, resamples=3)
