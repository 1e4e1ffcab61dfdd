"""From a study's answers to the rule table that plans by them.

Each instruction's median curve is fitted by a trapezoid. Instructions with "in" and without a hedge give the
width law w(t_spec); every preposition gives a model whose corners are sums of t, w and constants; hedged
instructions give the factor by which their hedge widens w; groups that differ give factors for actors.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.analysis.compare import compare
from fuzzytime.study.analysis.fitting import POOR, Fit
from fuzzytime.study.answers.participants import Answers
from fuzzytime.study.asking.questions import StudyInstruction
from fuzzytime.study.calibration.breakpoints import AT_TIME, NEVER_ENDS, ZERO, Breakpoint, explained
from fuzzytime.study.calibration.measured import Measured, WidthLaw, measured

SIGNIFICANCE = 0.05
"""From this p-value down, groups are taken to differ."""

Corners = tuple[Breakpoint, Breakpoint, Breakpoint, Breakpoint]


@dataclass(frozen=True, slots=True)
class CalibratedModel:
    """A preposition's model, and the largest distance of its corners from the fitted ones, in seconds."""

    breakpoints: Corners
    fits: tuple[Fit, ...]
    missed: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Calibration:
    """What a study says about lookup and adapt.

    Parameters
    ----------
    answers
        What it was made of.
    measured
        The trapezoids that were fitted to the medians.
    widths
        The half-base w by t_spec; without points where the study has no "in".
    models
        By preposition.
    hedges
        Factors of w by hedge.
    words
        By the word that stands for preposition and number: the instruction, and its own corners where the
        preposition's model with its hedge would miss them.
    actors
        For each group, factors of w by t_spec.
    groups_p
        The p-value of the difference between two groups; None where there are not two.
    """

    answers: Answers
    measured: tuple[Measured, ...]
    widths: WidthLaw
    models: Mapping[str, CalibratedModel]
    hedges: Mapping[str, float]
    words: Mapping[str, tuple[StudyInstruction, Corners | None]]
    actors: Mapping[str, Mapping[float, float]]
    groups_p: float | None

    @property
    def poor(self) -> tuple[str, ...]:
        """The instructions whose medians no trapezoid fits, among those that the table is made of."""
        return tuple(entry.instruction.key for entry in self.measured if entry.fit.poor)

    @property
    def left_out(self) -> tuple[str, ...]:
        """The instructions whose medians are 0 everywhere, of which nothing could be made."""
        made = {entry.instruction.key for entry in self.measured}
        return tuple(entry.key for entry in self.answers.design.instructions if entry.key not in made)

    @property
    def cautions(self) -> tuple[str, ...]:
        """What to know before the table is used, in sentences."""
        said = []
        if self.left_out:
            said.append(f"the median is 0 everywhere, and left out, for: {', '.join(self.left_out)}")
        if self.poor:
            said.append(f"a trapezoid fits the median badly (R² below {POOR:g}) for: {', '.join(self.poor)}")
        return tuple(said)


def calibrate(answers: Answers, *, seed: int = 0) -> Calibration:
    """Make a rule table's numbers of a study's answers.

    Parameters
    ----------
    answers : Answers
        At least one participant who counts.
    seed : int
        Of the test that says whether groups differ.

    Raises
    ------
    FuzzytimeError
        If nobody counts, or no median is above 0.
    """
    entries = measured(answers)
    if not entries:
        raise FuzzytimeError("all median curves are 0 everywhere: there is nothing to calibrate")
    widths = WidthLaw.of(entries)
    step = answers.design.timeline.step
    plain = [entry for entry in entries if entry.instruction.fuzziness is None]
    models = {
        preposition: _model([e for e in plain if e.instruction.preposition == preposition], widths, step)
        for preposition in dict.fromkeys(entry.instruction.preposition for entry in plain)
    }
    hedges = _hedges(entries, models, widths)
    p_value = _difference(answers, seed)
    differ = p_value is not None and p_value <= SIGNIFICANCE
    return Calibration(
        answers=answers,
        measured=tuple(entries),
        widths=widths,
        models=models,
        hedges=hedges,
        words={
            entry.instruction.word: (entry.instruction, _own_corners(entry, models, hedges, widths, step))
            for entry in entries
            if entry.instruction.word is not None
        },
        actors={
            group: (_factors(answers, group, widths) if differ else {}) or {0.0: 1.0}
            for group in answers.design.groups
            if p_value is not None and widths.points
        },
        groups_p=p_value,
    )


def _model(entries: Sequence[Measured], width: WidthLaw, step: float) -> CalibratedModel:
    """Explain the corners at several times; a side that most curves do not show is open."""

    def part(chosen: Sequence[Measured], length: Callable[[Measured], float]) -> Breakpoint:
        """Explain a length, which counts outward from the time named."""
        widths = [width(entry.instruction.t_spec) for entry in chosen]
        allowed = max(step, 0.03 * max(widths, default=0.0))
        return explained([length(entry) for entry in chosen], widths, allowed)

    rising = [e for e in entries if e.rises]
    falling = [e for e in entries if e.falls]
    later = [e for e in entries if e.instruction.t_spec > e.start]
    open_left = not rising or 2 * len(rising) < len(later)
    open_right = not falling or 2 * len(falling) < len(entries)
    full_start, full_end = ZERO, NEVER_ENDS
    if not open_left:
        full_start = AT_TIME.plus(part(rising, lambda e: e.instruction.t_spec - e.corners[1]), -1.0)
    if not open_right:
        full_end = AT_TIME.plus(part(falling, lambda e: e.corners[2] - e.instruction.t_spec))
    if not open_left and full_end.constant < full_start.constant:
        # Explained apart, the plateau's ends have crossed: then it is a peak.
        full_start = full_end = AT_TIME.plus(Breakpoint(float(np.mean([e.peak for e in entries]))))
    rise_start, fall_end = full_start, full_end
    if not open_left:
        seen = [e for e in rising if e.rise_seen] or rising
        rise_start = full_start.plus(part(seen, lambda e: e.corners[1] - e.corners[0]), -1.0)
    if not open_right:
        fall_end = full_end.plus(part(falling, lambda e: e.corners[3] - e.corners[2]))
    corners = (rise_start, full_start, full_end, fall_end)
    missed = 0.0
    for entry in entries:
        t, w = entry.instruction.t_spec, width(entry.instruction.t_spec)
        for corner, fitted in zip(corners, entry.corners, strict=True):
            value = corner.value(t, w)
            if entry.start < fitted < entry.end and entry.start < value < entry.end:
                missed = max(missed, abs(value - fitted))
    return CalibratedModel(corners, tuple(entry.fit for entry in entries), missed)


def _hedges(
    entries: Sequence[Measured], models: Mapping[str, CalibratedModel], width: WidthLaw
) -> dict[str, float]:
    """Find for each hedge the factor of w with which the models come nearest to the hedged corners."""
    sums: dict[str, list[float]] = {}
    spoken = [entry for entry in entries if entry.instruction.word is None]
    for entry in spoken:
        hedge, model = entry.instruction.fuzziness, models.get(entry.instruction.preposition)
        if hedge is None or model is None:
            continue
        t, w = entry.instruction.t_spec, width(entry.instruction.t_spec)
        for corner, fitted, visible in zip(model.breakpoints, entry.corners, entry.seen, strict=True):
            share = corner.width * w
            if visible and share:
                product, square = sums.setdefault(hedge, [0.0, 0.0])
                sums[hedge] = [
                    product + share * (fitted - corner.value(t, 0.0)),
                    square + share**2,
                ]
    return {hedge: product / square for hedge, (product, square) in sums.items() if product > 0}


def _own_corners(
    entry: Measured,
    models: Mapping[str, CalibratedModel],
    hedges: Mapping[str, float],
    width: WidthLaw,
    step: float,
) -> Corners | None:
    """Give a word's corners as constants, None where the model of its preposition comes near enough."""
    t, hedge = entry.instruction.t_spec, entry.instruction.fuzziness
    model = models.get(entry.instruction.preposition)
    if model is not None and (hedge is None or hedge in hedges):
        w = width(t) * hedges.get(hedge or "", 1.0)
        near = 2 * max(step, 0.03 * w)
        pairs = zip(model.breakpoints, entry.corners, entry.seen, strict=True)
        if all(abs(corner.value(t, w) - fitted) <= near for corner, fitted, visible in pairs if visible):
            return None
    own = (max(corner, entry.start) for corner in entry.corners[2:])
    rise_start, full_start, full_end, fall_end = map(Breakpoint, (*entry.corners[:2], *own))
    rise = (rise_start, full_start) if entry.rises else (ZERO, ZERO)
    fall = (full_end, fall_end) if entry.falls else (NEVER_ENDS, NEVER_ENDS)
    return (*rise, *fall)


def _difference(answers: Answers, seed: int) -> float | None:
    """Give the p-value of the difference between two groups of at least two people each."""
    groups = list(answers.design.groups)
    if len(groups) != 2 or min(len(answers.members(group)) for group in groups) < 2:
        return None
    first, second = (list(answers.subjective(group).values()) for group in groups)
    try:
        return compare(first, second, seed=seed).p_value
    except FuzzytimeError:
        return None


def _factors(answers: Answers, group: str, widths: WidthLaw) -> dict[float, float]:
    """Give a group's widths over everybody's, by t_spec."""
    own = WidthLaw.of(measured(answers, group)).points
    return {time: value / widths.points[time] for time, value in own.items() if time in widths.points}
