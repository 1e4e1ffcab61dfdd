"""Personal calibration: ratings of start times move a person's own table away from the population's.

A person is described by two kinds of numbers: how wide they take all times (a factor of w), and how far they
hear times of one preposition from what is said (a factor of t). Both have the population's value as the
prior, so that few ratings move little: their posterior mean, over a grid, is what the person's table says.
"""

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.resources import rules_directory
from fuzzytime.satisfaction import Floats, SatisfactionFunction
from fuzzytime.study.answers import Answers
from fuzzytime.study.density import variance
from fuzzytime.yaml_nodes import Node, Reader

GRID = 61
"""Values tried of each number, from −3 to 3 of its standard deviations."""


class Direction(StrEnum):
    """Which way a start was wrong."""

    EARLY = "too early"
    LATE = "too late"


@dataclass(frozen=True, slots=True, kw_only=True)
class Rating:
    """What a person thought of one start.

    Parameters
    ----------
    satisfaction
        ψ by which the start was chosen, of the population's table.
    t_spec
        The time that was said, in seconds.
    start
        When it started, in seconds; both count from when the instruction was given.
    preposition
        The preposition that was said; None where times are not to be heard otherwise, as for a clock time.
    score
        From 1 to 5, None where none was given.
    direction
        Whether it was too early or too late, None where that was not said.

    Raises
    ------
    FuzzytimeError
        If neither score nor direction is given, the score is none, or a time is not finite.
    """

    satisfaction: SatisfactionFunction
    t_spec: float
    start: float
    preposition: str | None = None
    score: int | None = None
    direction: Direction | None = None

    def __post_init__(self) -> None:
        if self.score is None and self.direction is None:
            raise FuzzytimeError("a rating must give a score or say what was wrong")
        if self.score is not None and not 1 <= self.score <= 5:
            raise FuzzytimeError(f"a score must be one of 1 to 5, got {self.score}")
        if not (math.isfinite(self.t_spec) and math.isfinite(self.start)):
            raise FuzzytimeError(f"times must be finite, got {self.t_spec} and {self.start}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Prior:
    """How people lie about the population's table, and how firm a rating is.

    Parameters
    ----------
    width, time
        Standard deviations of the logarithms of a person's factors of w and of t.
    noise
        Standard deviation of a score, in points.
    direction
        How sharply "too late" begins at the plateau's end, in widths of its flank.
    points
        Of the scale.
    """

    width: float
    time: float
    noise: float
    direction: float
    points: int = 5

    @classmethod
    def shipped(cls) -> "Prior":
        """Read ``rules/study/personal.yaml``."""
        return cls.of_file(rules_directory() / "study" / "personal.yaml")

    @classmethod
    def of_file(cls, path: Path) -> "Prior":
        """Read a prior.

        Raises
        ------
        OSError
            If the file cannot be read.
        DocumentError
            If it breaks rules.
        """
        reader = Reader.of_file(path)
        sections = ("fuzzytime-personal", "spread", "rating")
        root = reader.mapping(reader.root(), "", sections, sections)
        numbers: dict[str, float] = {}
        for section, keys in (("spread", ("width", "time")), ("rating", ("points", "noise", "direction"))):
            found = reader.mapping(root[section], section, keys, keys) if section in root else {}
            numbers |= {key: _value(reader, node, f"{section}.{key}") for key, node in found.items()}
        reader.finish()
        points = int(numbers.pop("points"))
        return cls(points=points, **numbers)

    @classmethod
    def of_answers(cls, answers: Answers) -> "Prior":
        """Take the spread of widths from a study: how its participants' curves differ in breadth.

        Raises
        ------
        FuzzytimeError
            If fewer than three participants count.
        """
        if len(answers.counted) < 3:
            raise FuzzytimeError(f"a spread needs three participants or more, got {len(answers.counted)}")
        shipped = cls.shipped()
        ratios = []
        for drawn in answers.subjective().values():
            own, common = variance(drawn.times, drawn.values), float(variance(drawn.times, drawn.median))
            if np.isfinite(common) and common > 0:
                ratios.append(np.log(np.where(own > 0, own, np.nan) / common) / 2)
        widths = np.nanmean(np.array(ratios), axis=0)
        spread = float(np.nanstd(widths, ddof=1))
        return cls(
            width=max(spread, 0.01),
            time=shipped.time,
            noise=shipped.noise,
            direction=shipped.direction,
            points=shipped.points,
        )


def _value(reader: Reader, node: Node, key: str) -> float:
    parts = reader.mapping(node, key, ("value", "source"), ("value", "source"))
    return reader.number(parts["value"], f"{key}.value", 1e-3, 100.0) if "value" in parts else 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class PersonalTable:
    """What a person's ratings amount to: factors over the population's table, and how sure they are.

    Parameters
    ----------
    width
        Factor of w.
    width_interval
        The factor's 95 % interval.
    times
        Factors of t by preposition.
    ratings
        How many ratings there are, by preposition; None counts those that speak of the width only.
    """

    width: float
    width_interval: tuple[float, float]
    times: Mapping[str, float]
    ratings: Mapping[str | None, int]

    @property
    def yaml(self) -> str:
        """The table as a rule file, to be laid over the population's."""
        total = sum(self.ratings.values())
        low, high = self.width_interval
        counted = f"personal: {total} rating{'s' * (total != 1)}"
        lines = [
            "# A person's own table: laid over the population's by `--rules`.",
            "fuzzytime: 1",
            f"source: {json.dumps(counted)}",
            "rules:",
            "  - name: personal width",
            f"    then: {{scale: {{w: {self.width:.4g}}}}}",
            f"    source: {json.dumps(f'{counted}; 95 % interval {low:.3g} to {high:.3g}')}",
        ]
        for preposition, factor in self.times.items():
            count, name = self.ratings[preposition], json.dumps(preposition, ensure_ascii=False)
            lines += [
                f"  - name: {json.dumps(f'personal time after {preposition!r}', ensure_ascii=False)}",
                # A clock time is heard as it is said: only spoken durations have these units.
                f"    on: {{preposition: {name}, unit: [second, minute, hour]}}",
                f"    then: {{scale: {{t: {factor:.4g}}}}}",
                f"    source: {json.dumps(f'personal: {count} ratings')}",
            ]
        return "\n".join(lines) + "\n"


def personal_table(prior: Prior, ratings: Iterable[Rating]) -> PersonalTable:
    """Give a person's factors by their ratings; without ratings they are 1.

    Parameters
    ----------
    prior : Prior
        The population.
    ratings : iterable of Rating
        In any order.
    """
    listed = list(ratings)
    steps = np.linspace(-3.0, 3.0, GRID)
    widths, times = prior.width * steps, prior.time * steps
    normal = -(steps**2) / 2
    posterior = normal.copy()
    joint: dict[str, Floats] = {}
    counts: dict[str | None, int] = {}
    for preposition in dict.fromkeys(rating.preposition for rating in listed):
        own = [rating for rating in listed if rating.preposition == preposition]
        counts[preposition] = len(own)
        heard = np.zeros(1) if preposition is None else times
        # Log likelihood of shape (widths, times), with the prior of times.
        likelihood = sum((_log_likelihood(prior, rating, widths, heard) for rating in own), np.zeros(1))
        table = likelihood + (normal if heard.size > 1 else 0.0)
        posterior = posterior + _log_sum(table)
        if preposition is not None:
            joint[preposition] = table
    weights = _normed(posterior)
    cumulated = np.cumsum(weights)
    ends = [float(np.exp(np.interp(share, cumulated, widths))) for share in (0.025, 0.975)]
    factors = {}
    for preposition, table in joint.items():
        # What the other prepositions say of the width holds here as well.
        others = posterior - _log_sum(table)
        shares = _normed((table + others[:, None]).ravel()).reshape(table.shape).sum(axis=0)
        factors[preposition] = float(np.exp(shares @ times))
    return PersonalTable(
        width=float(np.exp(weights @ widths)),
        width_interval=(ends[0], ends[1]),
        times=factors,
        ratings=counts,
    )


def _log_likelihood(prior: Prior, rating: Rating, widths: Floats, times: Floats) -> Floats:
    """Log likelihood of one rating for factors' logarithms, of shape (widths, times)."""
    anchor = rating.t_spec
    moved = rating.start - anchor * (np.exp(times) - 1.0)
    # Where ψ of this person is looked up in the population's. Before now nothing can start.
    place = anchor + (moved[None, :] - anchor) / np.exp(widths)[:, None]
    value = rating.satisfaction(np.maximum(place, 0.0) if rating.start >= 0 else place)
    likelihood = np.zeros_like(value)
    if rating.score is not None:
        expected = 1.0 + (prior.points - 1) * value
        likelihood = likelihood - ((rating.score - expected) / prior.noise) ** 2 / 2
    best, acceptable = rating.satisfaction.best, rating.satisfaction.acceptable()
    if rating.direction is Direction.LATE and math.isfinite(best.high):
        scale = max(2 * (min(acceptable.high, best.high + 1e7) - best.high), 1.0) * prior.direction
        likelihood = likelihood - np.logaddexp(0.0, -(place - best.high) / scale)
    elif rating.direction is Direction.EARLY and math.isfinite(best.low):
        scale = max(2 * (best.low - max(acceptable.low, best.low - 1e7)), 1.0) * prior.direction
        likelihood = likelihood - np.logaddexp(0.0, -(best.low - place) / scale)
    return np.asarray(likelihood)


def _log_sum(table: Floats) -> Floats:
    """Sum of exponentials over the last axis, as a logarithm."""
    peak = table.max(axis=-1)
    return np.asarray(peak + np.log(np.exp(table - peak[..., None]).sum(axis=-1)))


def _normed(logs: Floats) -> Floats:
    weights = np.exp(logs - logs.max())
    return np.asarray(weights / weights.sum())


def shown(table: PersonalTable, prepositions: Sequence[str] = ()) -> str:
    """Say in a few lines what a person's table says; prepositions without a rating can be named too."""
    total = sum(table.ratings.values())
    low, high = table.width_interval
    lines = [
        f"{total} rating{'s' * (total != 1)}",
        f"width {table.width:.2f} of the population's (95 %: {low:.2f} to {high:.2f})",
    ]
    for preposition in (*table.times, *(name for name in prepositions if name not in table.times)):
        factor = table.times.get(preposition, 1.0)
        lines.append(f"{preposition}: times are heard as {factor:.2f} of what is said")
    return "\n".join(lines)
