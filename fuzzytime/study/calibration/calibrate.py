"""From a study's answers to the rule table that plans by them.

Each instruction's median curve is fitted by a trapezoid. Instructions with "in" and without a hedge give the
width law w(t_spec); every preposition gives a model whose corners are sums of t, w and constants; hedged
instructions give the factor by which their hedge widens w; groups that differ give factors for actors.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study.analysis.compare import compare
from fuzzytime.study.analysis.fitting import Fit, Model, fit
from fuzzytime.study.answers.participants import Answers
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction
from fuzzytime.study.asking.questions import StudyInstruction
from fuzzytime.study.calibration.breakpoints import AT_TIME, NEVER_ENDS, ZERO, Breakpoint, explained

WIDTH_PREPOSITION = "in"
"""The preposition whose trapezoids say how wide w is."""

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
    widths
        Half-base w by t_spec, both in seconds; empty where the study has no "in".
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
    widths: Mapping[float, float]
    models: Mapping[str, CalibratedModel]
    hedges: Mapping[str, float]
    words: Mapping[str, tuple[StudyInstruction, Corners | None]]
    actors: Mapping[str, Mapping[float, float]]
    groups_p: float | None

    def width(self, t_spec: float) -> float:
        """Give w at a time: linear between the points, and beyond the last with its slope."""
        times, values = list(self.widths), list(self.widths.values())
        if not times:
            return 0.0
        if len(times) == 1 or t_spec <= times[0]:
            return values[0]
        after = next((i for i in range(1, len(times)) if t_spec <= times[i]), len(times) - 1)
        slope = (values[after] - values[after - 1]) / (times[after] - times[after - 1])
        return values[after] + slope * (t_spec - times[after])


@dataclass(frozen=True, slots=True)
class _Measured:
    """An instruction, the trapezoid fitted to its median, and which flanks the timeline shows."""

    instruction: StudyInstruction
    fit: Fit
    corners: tuple[float, float, float, float]
    start: float
    end: float

    @property
    def rises(self) -> bool:
        return self.corners[1] > self.start

    @property
    def rise_seen(self) -> bool:
        return self.corners[0] >= self.start and self.rises

    @property
    def falls(self) -> bool:
        return self.corners[2] < self.end

    @property
    def half_base(self) -> float:
        """The mean of the half-bases on the sides that are seen."""
        t = self.instruction.t_spec
        sides = [self.corners[3] - t] if self.falls else []
        sides += [t - self.corners[0]] if self.rise_seen else []
        return sum(sides) / len(sides)


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
        If nobody counts, or a median curve is 0 everywhere.
    """
    measured = _measured(answers, answers.subjective())
    plain = [entry for entry in measured if entry.instruction.fuzziness is None]
    ahead = [entry for entry in plain if entry.instruction.preposition == WIDTH_PREPOSITION]
    widths = {
        entry.instruction.t_spec: entry.half_base
        for entry in sorted(ahead, key=lambda entry: entry.instruction.t_spec)
        if entry.falls and entry.half_base > 0
    }
    unfinished = Calibration(
        answers=answers, widths=widths, models={}, hedges={}, words={}, actors={}, groups_p=None
    )
    models = {
        preposition: _model([e for e in plain if e.instruction.preposition == preposition], unfinished)
        for preposition in dict.fromkeys(entry.instruction.preposition for entry in plain)
    }
    p_value = _difference(answers, seed)
    hedges = _hedges(measured, models, unfinished)
    actors = {group: _actor(answers, group, widths, p_value) for group in answers.design.groups}
    return Calibration(
        answers=answers,
        widths=widths,
        models=models,
        hedges=hedges,
        words={
            entry.instruction.word: (entry.instruction, _own_corners(entry, models, hedges, unfinished))
            for entry in measured
            if entry.instruction.word is not None
        },
        actors=actors if p_value is not None and widths else {},
        groups_p=p_value,
    )


def _measured(answers: Answers, subjective: Mapping[str, SubjectiveSatisfaction]) -> list[_Measured]:
    found = []
    for instruction in answers.design.instructions:
        drawn = subjective[instruction.key]
        if not drawn.median.any():
            raise FuzzytimeError(f"the median curve of {instruction.key!r} is 0 everywhere: nothing to fit")
        best = fit(drawn.times, drawn.median, Model.TRAPEZOID)
        if isinstance(best.function, Trapezoid):
            ends = float(drawn.times[0]), float(drawn.times[-1])
            found.append(_Measured(instruction, best, best.function.corners, *ends))
    return found


def _model(entries: Sequence[_Measured], calibration: Calibration) -> CalibratedModel:
    """Explain the corners at several times; a side that most curves do not show is open."""
    tolerance = calibration.answers.design.timeline.step

    def part(chosen: Sequence[_Measured], lengths: Sequence[float]) -> Breakpoint:
        widths = [calibration.width(entry.instruction.t_spec) for entry in chosen]
        allowed = max(tolerance, 0.03 * max(widths, default=0.0))
        return explained(lengths, widths, allowed)

    times = {entry.instruction.key: entry.instruction.t_spec for entry in entries}
    rising = [e for e in entries if e.rises]
    falling = [e for e in entries if e.falls]
    later = [e for e in entries if e.instruction.t_spec > e.start]
    rise_start = full_start = ZERO
    full_end = fall_end = NEVER_ENDS
    if rising and 2 * len(rising) >= len(later):
        seen = [e for e in rising if e.rise_seen] or rising
        full_start = AT_TIME.plus(part(rising, [e.corners[1] - times[e.instruction.key] for e in rising]))
        rise_start = full_start.plus(part(seen, [e.corners[1] - e.corners[0] for e in seen]), -1.0)
    if falling and 2 * len(falling) >= len(entries):
        full_end = AT_TIME.plus(part(falling, [e.corners[2] - times[e.instruction.key] for e in falling]))
        fall_end = full_end.plus(part(falling, [e.corners[3] - e.corners[2] for e in falling]))
    corners = (rise_start, full_start, full_end, fall_end)
    missed = 0.0
    for entry in entries:
        t, w = entry.instruction.t_spec, calibration.width(entry.instruction.t_spec)
        for corner, fitted in zip(corners, entry.corners, strict=True):
            value = corner.value(t, w)
            if entry.start < fitted < entry.end and entry.start < value < entry.end:
                missed = max(missed, abs(value - fitted))
    return CalibratedModel(corners, tuple(entry.fit for entry in entries), missed)


def _hedges(
    measured: Sequence[_Measured], models: Mapping[str, CalibratedModel], calibration: Calibration
) -> dict[str, float]:
    """Find for each hedge the factor of w with which the models come nearest to the hedged corners."""
    sums: dict[str, list[float]] = {}
    spoken = [entry for entry in measured if entry.instruction.word is None]
    for entry in spoken:
        hedge, model = entry.instruction.fuzziness, models.get(entry.instruction.preposition)
        if hedge is None or model is None:
            continue
        t, w = entry.instruction.t_spec, calibration.width(entry.instruction.t_spec)
        seen = (entry.rise_seen, entry.rises, entry.falls, entry.falls)
        for corner, fitted, visible in zip(model.breakpoints, entry.corners, seen, strict=True):
            share = corner.width * w
            if visible and share:
                product, square = sums.setdefault(hedge, [0.0, 0.0])
                sums[hedge] = [
                    product + share * (fitted - corner.value(t, 0.0)),
                    square + share**2,
                ]
    return {hedge: product / square for hedge, (product, square) in sums.items() if product > 0}


def _own_corners(
    entry: _Measured,
    models: Mapping[str, CalibratedModel],
    hedges: Mapping[str, float],
    calibration: Calibration,
) -> Corners | None:
    """Give a word's corners as constants, None where the model of its preposition comes near enough."""
    t, hedge = entry.instruction.t_spec, entry.instruction.fuzziness
    model = models.get(entry.instruction.preposition)
    if model is not None and (hedge is None or hedge in hedges):
        w = calibration.width(t) * hedges.get(hedge or "", 1.0)
        near = 2 * max(calibration.answers.design.timeline.step, 0.03 * w)
        seen = (entry.rise_seen, entry.rises, entry.falls, entry.falls)
        pairs = zip(model.breakpoints, entry.corners, seen, strict=True)
        if all(abs(corner.value(t, w) - fitted) <= near for corner, fitted, visible in pairs if visible):
            return None
    rise_start, full_start, full_end, fall_end = map(Breakpoint, entry.corners)
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


def _actor(
    answers: Answers, group: str, widths: Mapping[float, float], p_value: float | None
) -> dict[float, float]:
    """Give a group's widths over everybody's; 1 throughout where groups do not differ."""
    if p_value is None or p_value > SIGNIFICANCE or not widths:
        return {0.0: 1.0}
    own = {
        entry.instruction.t_spec: entry.half_base / widths[entry.instruction.t_spec]
        for entry in _measured(answers, answers.subjective(group))
        if entry.instruction.fuzziness is None
        and entry.instruction.preposition == WIDTH_PREPOSITION
        and entry.instruction.t_spec in widths
        and entry.falls
    }
    return dict(sorted(own.items())) or {0.0: 1.0}
