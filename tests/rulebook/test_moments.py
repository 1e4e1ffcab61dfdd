"""Which moment of the execution words are about, and which one they name."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fuzzytime.requirement import Constraint, Reference, TimeRequirement
from fuzzytime.rulebook import Profile, Rulebook
from fuzzytime.satisfaction import Interval
from fuzzytime.times import HOUR, MINUTE
from rulebook.requirements_of import ahead, said, word

RULEBOOK = Rulebook.shipped()


def by_six(**fields: Any) -> TimeRequirement:  # noqa: ANN401
    return said(Constraint.BEFORE, preposition="by", t_spec=HOUR, **fields)


def test_by_six_is_done_by_six_unless_the_words_name_the_start() -> None:
    done, begun = (
        RULEBOOK.resolve(by_six(reference_said=named), duration=MINUTE, elapsed=20 * MINUTE)
        for named in (False, True)
    )
    assert (done.reference, done.satisfaction.best.high) == (Reference.FINISH, 40 * MINUTE)
    assert (begun.reference, begun.satisfaction.best.high) == (Reference.START, HOUR)


def test_by_six_speaks_of_the_start_in_the_study() -> None:
    study = Rulebook.shipped(Profile.STUDY)
    assert study.resolve(by_six(), elapsed=20 * MINUTE).satisfaction.best.high == HOUR


def test_a_user_s_row_chooses_which_moment_a_word_is_about(tmp_path: Path) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_text("fuzzytime: 1\nprepositions: {by: {model: before, reference: start}}\n")
    resolution = Rulebook.shipped(files=[mine]).resolve(by_six(), elapsed=20 * MINUTE)
    assert resolution.satisfaction.best.high == HOUR


def test_an_occurrence_of_a_series_is_no_wider_than_a_quarter_of_its_interval() -> None:
    @dataclass(frozen=True)
    class Hourly:
        interval: float | None = HOUR

        def occurrences(self, until: float) -> tuple[float, ...]:
            return tuple(np.arange(0, until, HOUR).tolist())

    tenth = said(Constraint.AT, t_spec=10 * HOUR, recurrence=Hourly())
    assert RULEBOOK.resolve(tenth).satisfaction.support.length == pytest.approx(30 * MINUTE)
    assert RULEBOOK.resolve(said(Constraint.AT, t_spec=10 * HOUR)).satisfaction.support.length > HOUR


def test_the_start_that_is_named_is_told_where_words_name_one() -> None:
    assert RULEBOOK.resolve(ahead("in", 10)).named == 10 * MINUTE
    finish = said(Constraint.AT, t_spec=HOUR, reference=Reference.FINISH)
    assert RULEBOOK.resolve(finish, elapsed=20 * MINUTE).named == 40 * MINUTE
    assert RULEBOOK.resolve(word("soon")).named is None


def test_a_model_of_intervals_takes_a_moment_as_one_without_length(tmp_path: Path) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_text(
        "fuzzytime: 1\nmodels: {odd: {breakpoints: [a - 1 min, a, b, b + 2 min]}}\n"
        "prepositions: {in: {model: odd}}\n"
    )
    function = Rulebook.shipped(files=[mine]).resolve(ahead("in", 10)).satisfaction
    assert function.support == Interval(9 * MINUTE, 12 * MINUTE)
