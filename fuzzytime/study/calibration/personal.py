"""Personal calibration: ratings of start times move a person's own table away from the population's.

A person is described by how wide they take all times (a factor of w), and how they hear times: as a factor of
t for each preposition ("in ten minutes" is meant as nine) and for each word ("soon"). Each has the
population's value as its prior, so that few ratings move little: their posterior mean, over a grid, is what
the person's table says.
"""

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.rating import Cue, CueKind, Direction, Rating
from fuzzytime.study.calibration.prior import Prior

REACH = 4.0
"""How far from the population a person is sought, in standard deviations: five times as wide, or a fifth."""

GRID = 81
"""Values tried of each number within `REACH`."""


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
        Factors of t by cue.
    ratings
        How many ratings there are, by cue; None counts those that speak of the width only.
    """

    width: float
    width_interval: tuple[float, float]
    times: Mapping[Cue, float]
    ratings: Mapping[Cue | None, int]

    @property
    def yaml(self) -> str:
        """The table as a rule file, to be laid over the population's."""
        low, high = self.width_interval
        total = _counted(sum(self.ratings.values()))
        lines = [
            "# A person's own table, to be laid over the population's.",
            "fuzzytime: 1",
            f"source: {json.dumps(f'personal: {total}')}",
            "rules:",
            "  - name: personal width",
            f"    then: {{scale: {{w: {self.width:.4g}}}}}",
            f"    source: {json.dumps(f'personal: {total}; 95 % interval {low:.3g} to {high:.3g}')}",
        ]
        for cue, factor in self.times.items():
            name = json.dumps(cue.text, ensure_ascii=False)
            # A clock time is heard as it is said: only spoken durations have these units.
            units = ", unit: [second, minute, hour]" if cue.kind is CueKind.PREPOSITION else ""
            kind = "word " if cue.kind is CueKind.WORD else ""
            title = json.dumps(f"personal {kind}{cue.text!r}", ensure_ascii=False)
            lines += [
                f"  - name: {title}",
                f"    on: {{{cue.kind}: {name}{units}}}",
                f"    then: {{scale: {{t: {factor:.4g}}}}}",
                f"    source: {json.dumps(f'personal: {_counted(self.ratings[cue])}')}",
            ]
        return "\n".join(lines) + "\n"

    @property
    def lines(self) -> tuple[str, ...]:
        """The table in a few sentences."""
        low, high = self.width_interval
        return (
            f"your wishes are {self.width:.2f} times as wide as others' (95 %: {low:.2f} to {high:.2f})",
            *(
                f"{cue.text!r}: times are heard as {factor:.2f} of others'"
                for cue, factor in self.times.items()
            ),
        )


def _counted(ratings: int) -> str:
    return f"{ratings} rating{'s' * (ratings != 1)}"


def personal_table(prior: Prior, ratings: Iterable[Rating]) -> PersonalTable:
    """Give a person's factors by their ratings; without ratings they are 1.

    Parameters
    ----------
    prior : Prior
        The population.
    ratings : iterable of Rating
        In any order.
    """
    by_cue: dict[Cue | None, list[Rating]] = {}
    for rating in ratings:
        by_cue.setdefault(rating.cue, []).append(rating)
    steps = np.linspace(-REACH, REACH, GRID)
    widths, normal = prior.width * steps, -(steps**2) / 2
    posterior = normal.copy()
    joint: dict[Cue, tuple[Floats, Floats]] = {}
    for cue, own in by_cue.items():
        if cue is None:
            posterior = posterior + _likelihood(prior, own, widths, np.zeros(1))[:, 0]
            continue
        times = steps * (prior.word if cue.kind is CueKind.WORD else prior.time)
        table = _likelihood(prior, own, widths, times) + normal
        posterior = posterior + _log_sum(table)
        joint[cue] = (times, table)
    weights = _normed(posterior)
    cumulated = np.cumsum(weights)
    low, high = (float(np.exp(np.interp(share, cumulated, widths))) for share in (0.025, 0.975))
    factors = {}
    for cue, (times, table) in joint.items():
        # What the other cues say of the width holds here as well.
        others = posterior - _log_sum(table)
        shares = _normed(table + others[:, None]).sum(axis=0)
        factors[cue] = float(np.exp(shares @ times))
    return PersonalTable(
        width=float(np.exp(weights @ widths)),
        width_interval=(low, high),
        times=factors,
        ratings={cue: len(own) for cue, own in by_cue.items()},
    )


def _likelihood(prior: Prior, ratings: Iterable[Rating], widths: Floats, times: Floats) -> Floats:
    """Log likelihood of ratings of one cue for factors' logarithms, of shape (widths, times)."""
    total = np.zeros((widths.size, times.size))
    for rating in ratings:
        place = _place(rating, widths, times)
        if rating.score is not None:
            expected = 1.0 + (prior.points - 1) * rating.satisfaction(_to_blame(rating, place))
            total -= ((rating.score - expected) / prior.noise) ** 2 / 2
        if rating.direction is not None:
            agreed = -np.logaddexp(0.0, -_beyond(rating, place) / prior.direction)
            total += np.logaddexp(math.log(prior.lapse), math.log1p(-prior.lapse) + agreed)
    return total


def _to_blame(rating: Rating, place: Floats) -> Floats:
    """Give where the flank is that a score speaks of: a start that is too late has no rise to blame."""
    best = rating.satisfaction.best
    if rating.direction is Direction.LATE:
        return np.maximum(place, best.low)
    return np.minimum(place, best.high) if rating.direction is Direction.EARLY else place


def _place(rating: Rating, widths: Floats, times: Floats) -> Floats:
    """Give where ψ of a person is looked up in the population's, of shape (widths, times)."""
    if rating.cue is not None and rating.cue.kind is CueKind.WORD:
        # A word's model is stretched as a whole, and has no width beside its time.
        place = np.broadcast_to(rating.start / np.exp(times), (widths.size, times.size))
    else:
        moved = rating.start - rating.t_spec * (np.exp(times) - 1.0)
        place = rating.t_spec + (moved[None, :] - rating.t_spec) / np.exp(widths)[:, None]
    # Before now nothing can start.
    return np.asarray(np.maximum(place, 0.0) if rating.start >= 0 else place)


def _beyond(rating: Rating, place: Floats) -> Floats:
    """Give how far a place lies beyond the plateau on the side of a direction, in widths of its flank.

    Where there is no flank it is in widths of the plateau; where the side is open, nowhere lies beyond.
    """
    best, acceptable = rating.satisfaction.best, rating.satisfaction.acceptable()
    late = rating.direction is Direction.LATE
    edge, half = (best.high, acceptable.high) if late else (best.low, acceptable.low)
    if not math.isfinite(edge):
        return np.zeros_like(place)
    flank = 2 * abs(half - edge) if math.isfinite(half) else 0.0
    scale = flank if flank >= 1.0 else max(best.length if math.isfinite(best.length) else 1.0, 1.0)
    return np.asarray((place - edge) / scale if late else (edge - place) / scale)


def _log_sum(table: Floats) -> Floats:
    """Sum of exponentials over the last axis, as a logarithm."""
    peak = table.max(axis=-1)
    return np.asarray(peak + np.log(np.exp(table - peak[..., None]).sum(axis=-1)))


def _normed(logs: Floats) -> Floats:
    weights = np.exp(logs - logs.max())
    return np.asarray(weights / weights.sum())
