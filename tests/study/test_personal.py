import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.rulebook import Rulebook, check
from fuzzytime.satisfaction import Bell, Floored, SatisfactionFunction, Trapezoid
from fuzzytime.study import Answers, Direction, Prior, Rating, personal_table
from fuzzytime.study.personal import shown
from fuzzytime.study.rating_store import RatingStore

TEN = Trapezoid(420, 500, 700, 780)
"""What the population takes "in ten minutes" to be."""


@pytest.fixture(scope="module")
def prior() -> Prior:
    return Prior.shipped()


def rated(score: int | None, start: float, direction: Direction | None = None, **more: object) -> Rating:
    fields: dict[str, object] = {"satisfaction": TEN, "t_spec": 600.0, "preposition": "in", **more}
    return Rating(start=start, score=score, direction=direction, **fields)  # type: ignore[arg-type]


def honest(true: SatisfactionFunction, count: int, seed: int = 1) -> list[Rating]:
    """Rate starts around ten minutes as a person with a function of their own would."""
    generator = np.random.default_rng(seed)
    starts = generator.uniform(300, 900, count).tolist()
    scores = [1 + 4 * float(true(start)) + 0.5 * generator.standard_normal() for start in starts]
    return [rated(int(np.clip(round(s), 1, 5)), start) for s, start in zip(scores, starts, strict=True)]


def test_without_ratings_the_populations_table_stays(prior: Prior) -> None:
    found = personal_table(prior, [])
    assert found.width == pytest.approx(1.0)
    assert found.times == {}
    assert found.width_interval == pytest.approx((math.exp(-1.96 * 0.4), math.exp(1.96 * 0.4)), rel=0.05)


def test_the_more_ratings_the_nearer_the_table_comes_to_the_person(prior: Prior) -> None:
    lenient = TEN.widened(1.8, 600.0)
    widths = [personal_table(prior, honest(lenient, count)).width for count in (1, 5, 40)]
    assert 1.0 < widths[1] < 1.8 * 1.1
    assert widths[2] == pytest.approx(1.8, rel=0.15)
    assert abs(math.log(widths[2] / 1.8)) < abs(math.log(widths[0] / 1.8))


def test_a_strict_person_gets_a_narrow_table(prior: Prior) -> None:
    found = personal_table(prior, honest(TEN.widened(0.6, 600.0), 40))
    assert found.width == pytest.approx(0.6, rel=0.2)
    assert found.width_interval[0] < 0.6 < found.width_interval[1]


def test_who_likes_it_earlier_hears_times_as_shorter(prior: Prior) -> None:
    found = personal_table(prior, honest(TEN.shifted(-60.0), 40))
    assert found.times["in"] == pytest.approx(0.9, abs=0.03)
    assert found.width == pytest.approx(1.0, abs=0.2)


def test_too_late_moves_times_earlier_and_too_early_later(prior: Prior) -> None:
    late = personal_table(prior, [rated(None, 600.0, Direction.LATE)] * 3)
    early = personal_table(prior, [rated(None, 600.0, Direction.EARLY)] * 3)
    assert late.times["in"] < 0.97
    assert early.times["in"] > 1.03
    assert personal_table(prior, [rated(2, 600.0, Direction.LATE)]).times["in"] < 1


def test_one_rating_moves_less_than_many(prior: Prior) -> None:
    moves = [
        abs(math.log(personal_table(prior, [rated(4, 640.0, Direction.LATE)] * count).times["in"]))
        for count in (1, 2, 4, 8)
    ]
    assert moves == sorted(moves)
    assert moves[0] < 0.15


@given(
    st.lists(
        st.tuples(
            st.one_of(st.none(), st.integers(1, 5)),
            st.floats(0, 5000),
            st.sampled_from([None, "in", "before"]),
            st.sampled_from([Direction.EARLY, Direction.LATE]),
        ),
        max_size=6,
    )
)
def test_any_ratings_give_finite_factors_within_the_priors_reach(
    ratings: list[tuple[int | None, float, str | None, Direction]],
) -> None:
    prior = Prior.shipped()
    listed = [
        rated(score, start, direction, preposition=preposition)
        for score, start, preposition, direction in ratings
    ]
    found = personal_table(prior, listed)
    assert math.exp(-3 * prior.width) <= found.width <= math.exp(3 * prior.width)
    for factor in found.times.values():
        assert math.exp(-3 * prior.time) <= factor <= math.exp(3 * prior.time)


def test_ratings_of_clock_times_speak_of_the_width_only(prior: Prior) -> None:
    lenient = honest(TEN.widened(1.8, 600.0), 30)
    clock = [rated(rating.score, rating.start, preposition=None) for rating in lenient]
    found = personal_table(prior, clock)
    assert found.times == {}
    assert found.width > 1.4


def test_the_order_of_ratings_does_not_matter(prior: Prior) -> None:
    ratings = [*honest(TEN, 4), rated(2, 700.0, Direction.LATE, preposition="by"), rated(5, 650.0)]
    one, other = personal_table(prior, ratings), personal_table(prior, ratings[::-1])
    assert one.width == pytest.approx(other.width)
    assert one.times == pytest.approx(other.times)


def test_a_personal_table_is_a_rule_table_that_plans(prior: Prior, tmp_path: Path) -> None:
    found = personal_table(prior, honest(TEN.widened(1.8, 600.0).shifted(-60.0), 40))
    path = tmp_path / "mine.yaml"
    path.write_text(found.yaml, encoding="utf-8")
    assert check([path]) == ()

    def resolved(unit: Unit | None, *files: Path) -> SatisfactionFunction:
        said = TimeRequirement(
            text="in ten minutes",
            span=(0, 14),
            constraint=Constraint.AT,
            preposition="in",
            t_spec=600.0,
            number=10.0,
            unit=unit,
        )
        return Rulebook.shipped(files=files).resolve(said).satisfaction

    population, person = resolved(Unit.MINUTE), resolved(Unit.MINUTE, path)
    factor = person.support.length / population.support.length
    assert factor == pytest.approx(found.width, rel=0.1)
    middle = (person.best.low + person.best.high) / 2
    assert middle == pytest.approx(600.0 * found.times["in"], abs=2.0)
    # A time without a unit is one of the clock: it is heard as it is said.
    clock = resolved(None, path)
    assert (clock.best.low + clock.best.high) / 2 == pytest.approx(600.0)


def test_names_of_prepositions_are_quoted(prior: Prior, tmp_path: Path) -> None:
    odd = [rated(3, 640.0, preposition=name) for name in ("on", "before the next", "{x: [", "é'\"")]
    path = tmp_path / "mine.yaml"
    path.write_text(personal_table(prior, odd).yaml, encoding="utf-8")
    assert check([path]) == ()


def test_the_table_can_be_shown(prior: Prior) -> None:
    lines = shown(personal_table(prior, [rated(5, 600.0)]), ("after",)).split("\n")
    assert lines[0] == "1 rating"
    assert lines[1].startswith("width ")
    assert lines[-1] == "after: times are heard as 1.00 of what is said"


def test_the_spread_of_a_studys_participants_can_be_the_prior(answers: Answers) -> None:
    # They were simulated with a spread of 0.2; flanks of "before" are too narrow to show it.
    assert 0.1 < Prior.of_answers(answers).width < 0.25
    with pytest.raises(FuzzytimeError, match="three participants"):
        Prior.of_answers(Answers(answers.design, answers.participants[:2]))


@pytest.mark.parametrize(
    ("score", "start", "rule"),
    [(None, 1.0, "score or say"), (0, 1.0, "1 to 5, got 0"), (6, 1.0, "got 6"), (3, math.inf, "finite")],
)
def test_what_is_no_rating_is_refused(score: int | None, start: float, rule: str) -> None:
    with pytest.raises(FuzzytimeError, match=rule):
        rated(score, start)


def test_a_prior_says_what_is_wrong_with_it(tmp_path: Path) -> None:
    path = tmp_path / "personal.yaml"
    path.write_text("fuzzytime-personal: 1\nspread: {width: {value: -1, source: x}}\nrating: {}\n")
    with pytest.raises(DocumentError) as caught:
        Prior.of_file(path)
    assert "personal.yaml:2:25: spread.width.value" in str(caught.value)
    assert "missing key 'time'" in str(caught.value)


def test_ratings_are_kept_undone_and_exported(tmp_path: Path) -> None:
    path = tmp_path / "ratings.sqlite"
    kept = [rated(2, 700.0, Direction.LATE), rated(5, 600.0, satisfaction=Bell(600, 60, 2), preposition=None)]
    with RatingStore(path) as store:
        for rating in kept:
            store.add(rating, "2026-03-04")
    with RatingStore(path) as store:
        assert store.ratings() == tuple(kept)
        assert store.undo() == kept[1]
        assert store.ratings() == (kept[0],)
        assert store.undo() == kept[0]
        assert store.undo() is None
        store.add(kept[1], "2026-03-05")
        assert store.ratings() == (kept[1],)
        lines = store.export().splitlines()
    assert len(lines) == 3
    assert '"undone": true' in lines[0]
    assert '"undone": false' in lines[2]


def test_a_function_that_cannot_be_kept_is_refused(tmp_path: Path) -> None:
    with RatingStore(tmp_path / "ratings.sqlite") as store, pytest.raises(FuzzytimeError, match="'floored'"):
        store.add(rated(3, 600.0, satisfaction=Floored(TEN, 0.1)), "")


def test_a_file_of_something_else_is_no_file_of_ratings(tmp_path: Path) -> None:
    path = tmp_path / "ratings.sqlite"
    path.write_bytes(b"these are not ratings" * 500)
    with pytest.raises(FuzzytimeError, match=r"ratings\.sqlite holds"):
        RatingStore(path)
