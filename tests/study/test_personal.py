import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.rulebook import Rulebook, check
from fuzzytime.satisfaction import Bell, Floored, Sampled, SatisfactionFunction, Trapezoid
from fuzzytime.study import Cue, CueKind, Direction, Prior, Rating, personal_table
from fuzzytime.study.answers.rating import document_of, rating_of

IN = Cue(CueKind.PREPOSITION, "in")
SOON = Cue(CueKind.WORD, "soon")
TEN = Trapezoid(420, 500, 700, 780)
"""What the population takes "in ten minutes" to be."""


@pytest.fixture(scope="module")
def prior() -> Prior:
    return Prior.shipped()


def rated(score: int | None, start: float, direction: Direction | None = None, **more: object) -> Rating:
    fields: dict[str, object] = {"satisfaction": TEN, "t_spec": 600.0, "cue": IN, **more}
    return Rating(start=start, score=score, direction=direction, **fields)  # type: ignore[arg-type]


def honest(true: SatisfactionFunction, count: int, seed: int = 1, latest: float = 900.0) -> list[Rating]:
    """Rate starts around ten minutes as a person with a function of their own would."""
    generator = np.random.default_rng(seed)
    starts = generator.uniform(300, latest, count).tolist()
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


def test_a_very_lenient_person_is_found_too(prior: Prior) -> None:
    found = personal_table(prior, honest(TEN.widened(4.0, 600.0), 120, latest=1500.0))
    assert found.width == pytest.approx(4.0, rel=0.2)


def test_who_likes_it_earlier_hears_times_as_shorter(prior: Prior) -> None:
    found = personal_table(prior, honest(TEN.shifted(-60.0), 40))
    assert found.times[IN] == pytest.approx(0.9, abs=0.03)
    assert found.width == pytest.approx(1.0, abs=0.2)


def test_too_late_moves_times_earlier_and_too_early_later(prior: Prior) -> None:
    late = personal_table(prior, [rated(None, 600.0, Direction.LATE)] * 3)
    early = personal_table(prior, [rated(None, 600.0, Direction.EARLY)] * 3)
    assert late.times[IN] < 0.97
    assert early.times[IN] > 1.03
    assert personal_table(prior, [rated(2, 600.0, Direction.LATE)]).times[IN] < 1


def test_one_rating_moves_less_than_many(prior: Prior) -> None:
    moves = [
        abs(math.log(personal_table(prior, [rated(4, 640.0, Direction.LATE)] * count).times[IN]))
        for count in (1, 2, 4, 8)
    ]
    assert moves == sorted(moves)
    assert moves[0] < 0.15


@given(
    st.lists(
        st.tuples(
            st.one_of(st.none(), st.integers(1, 5)),
            st.floats(0, 5000),
            st.sampled_from([None, IN, Cue(CueKind.PREPOSITION, "before"), SOON]),
            st.sampled_from([Direction.EARLY, Direction.LATE]),
        ),
        max_size=6,
    )
)
def test_any_ratings_give_finite_factors_within_the_priors_reach(
    ratings: list[tuple[int | None, float, Cue | None, Direction]],
) -> None:
    prior = Prior.shipped()
    listed = [rated(score, start, direction, cue=cue) for score, start, cue, direction in ratings]
    found = personal_table(prior, listed)
    assert math.exp(-3 * prior.width) <= found.width <= math.exp(3 * prior.width)
    for cue, factor in found.times.items():
        spread = prior.word if cue is SOON else prior.time
        assert math.exp(-3 * spread) <= factor <= math.exp(3 * spread)


def test_ratings_of_clock_times_speak_of_the_width_only(prior: Prior) -> None:
    lenient = honest(TEN.widened(1.8, 600.0), 30)
    clock = [rated(rating.score, rating.start, cue=None) for rating in lenient]
    found = personal_table(prior, clock)
    assert found.times == {}
    assert found.width > 1.4


def test_the_order_of_ratings_does_not_matter(prior: Prior) -> None:
    ratings = [
        *honest(TEN, 4),
        rated(2, 700.0, Direction.LATE, cue=Cue(CueKind.PREPOSITION, "by")),
        rated(5, 650.0),
    ]
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
    assert middle == pytest.approx(600.0 * found.times[IN], abs=2.0)
    # A time without a unit is one of the clock: it is heard as it is said.
    clock = resolved(None, path)
    assert (clock.best.low + clock.best.high) / 2 == pytest.approx(600.0)


def test_names_of_prepositions_are_quoted(prior: Prior, tmp_path: Path) -> None:
    names = ("on", "before the next", "{x: [", "é'\"")
    odd = [rated(3, 640.0, cue=Cue(kind, name)) for name in names for kind in CueKind]
    path = tmp_path / "mine.yaml"
    path.write_text(personal_table(prior, odd).yaml, encoding="utf-8")
    # That nobody says some of these is another matter than how they are written.
    assert all("must be one of the known words" in mistake.message for mistake in check([path]))
    # YAML 1.1 takes the key "on" for true.
    cues = [rule[True] for rule in yaml.safe_load(path.read_text("utf-8"))["rules"][1:]]
    assert {cue.get("preposition") or cue["word"] for cue in cues} == set(names)


def test_the_table_can_be_shown(prior: Prior) -> None:
    lines = personal_table(prior, [rated(5, 600.0), rated(4, 60.0, cue=SOON, t_spec=0.0)]).lines
    assert lines[0].startswith("your wishes are 1.")
    assert [line.partition(":")[0] for line in lines[1:]] == ["'in'", "'soon'"]


def test_a_word_is_heard_sooner_or_later_and_says_nothing_of_widths(prior: Prior) -> None:
    soon: dict[str, Any] = {"satisfaction": Trapezoid(0, 0, 300, 1200), "t_spec": 0.0, "cue": SOON}
    late = personal_table(prior, [rated(2, 420.0, Direction.LATE, **soon)] * 4)
    content = personal_table(prior, [rated(5, 900.0, **soon)] * 4)
    assert late.times[SOON] < 0.8
    assert content.times[SOON] > 1.5
    assert late.width == pytest.approx(1.0)


@pytest.mark.parametrize("start", [430.0, 600.0, 740.0])
@pytest.mark.parametrize("score", [None, 1, 3])
def test_too_late_never_moves_times_later_nor_too_early_earlier(
    prior: Prior, start: float, score: int | None
) -> None:
    late = personal_table(prior, [rated(score, start, Direction.LATE)])
    early = personal_table(prior, [rated(score, start, Direction.EARLY)])
    assert late.times[IN] < 1.0 < early.times[IN]


def test_a_direction_that_contradicts_everything_moves_a_table_little(prior: Prior) -> None:
    careless = personal_table(prior, [rated(None, 6000.0, Direction.EARLY)])
    assert careless.times[IN] == pytest.approx(1.0, abs=0.05)


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


@pytest.mark.parametrize("cue", [None, IN, SOON])
@pytest.mark.parametrize("function", [TEN, Bell(600, 60, 2), Sampled([0, 60], [0.5, 1])])
def test_a_rating_is_kept_exactly(cue: Cue | None, function: SatisfactionFunction) -> None:
    rating = rated(2, 700.0, Direction.LATE, satisfaction=function, cue=cue)
    assert rating_of(json.loads(json.dumps(document_of(rating)))) == rating


def test_a_function_that_cannot_be_kept_is_refused() -> None:
    with pytest.raises(FuzzytimeError, match="'floored'"):
        document_of(rated(3, 600.0, satisfaction=Floored(TEN, 0.1)))


@pytest.mark.parametrize(
    "change", [{"model": "none"}, {"cue": {}}, {"cue": {"verb": "x"}}, {"score": 9}, {"start_s": "soon"}]
)
def test_a_document_that_is_no_rating_is_refused(change: dict[str, object]) -> None:
    with pytest.raises(FuzzytimeError):
        rating_of({**document_of(rated(3, 600.0)), **change})
