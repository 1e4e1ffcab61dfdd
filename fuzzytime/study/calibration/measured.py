"""What is read off a study's medians before laws are made of it: trapezoids, and the flanks in sight."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study.analysis.fitting import Fit, Model, fit
from fuzzytime.study.answers.participants import Answers
from fuzzytime.study.asking.questions import StudyInstruction

WIDTH_PREPOSITION = "in"
"""The preposition whose trapezoids say how wide w is."""


@dataclass(frozen=True, slots=True)
class Measured:
    """An instruction, the trapezoid fitted to its median, and which flanks the timeline shows.

    Corners, and the timeline's start and end, are in seconds.
    """

    instruction: StudyInstruction
    fit: Fit
    corners: tuple[float, float, float, float]
    start: float
    end: float

    @property
    def rises(self) -> bool:
        """Whether the plateau begins on the timeline."""
        return self.corners[1] > self.start

    @property
    def rise_seen(self) -> bool:
        """Whether the whole rise is on the timeline."""
        return self.corners[0] >= self.start and self.rises

    @property
    def falls(self) -> bool:
        """Whether the plateau ends on the timeline."""
        return self.corners[2] < self.end

    @property
    def peak(self) -> float:
        """Seconds from the time named to the middle of the plateau."""
        return (self.corners[1] + self.corners[2]) / 2 - self.instruction.t_spec

    @property
    def seen(self) -> tuple[bool, bool, bool, bool]:
        """Which corners the timeline shows."""
        return self.rise_seen, self.rises, self.falls, self.falls

    @property
    def says_width(self) -> bool:
        """Whether the width law is read off this: "in" without a hedge, which falls on the timeline."""
        plain = self.instruction.preposition == WIDTH_PREPOSITION and self.instruction.fuzziness is None
        return plain and self.falls and self.half_base > 0

    @property
    def half_base(self) -> float:
        """The mean of the half-bases on the sides that are seen, in seconds; 0 where none is."""
        t = self.instruction.t_spec
        sides = [self.corners[3] - t] if self.falls else []
        sides += [t - self.corners[0]] if self.rise_seen else []
        return sum(sides) / len(sides) if sides else 0.0


def measured(answers: Answers, group: str | None = None) -> list[Measured]:
    """Fit trapezoids to the medians of a group, or of all; those that are 0 everywhere are left out.

    Raises
    ------
    FuzzytimeError
        If nobody counts.
    """
    found = []
    for instruction, drawn in zip(
        answers.design.instructions, answers.subjective(group).values(), strict=True
    ):
        if not drawn.median.any():
            continue
        best = fit(drawn.times, drawn.median, Model.TRAPEZOID)
        if isinstance(best.function, Trapezoid):
            ends = float(drawn.times[0]), float(drawn.times[-1])
            found.append(Measured(instruction, best, best.function.corners, *ends))
    return found


@dataclass(frozen=True, slots=True)
class WidthLaw:
    """The half-base w of "in" by the time that is named: by points, ascending; both in seconds.

    >>> law = WidthLaw({0.0: 110.0, 600.0: 130.0, 1800.0: 170.0})
    >>> law(300.0), round(law(2400.0))
    (120.0, 190)
    """

    points: Mapping[float, float]

    @classmethod
    def of(cls, entries: Iterable[Measured]) -> "WidthLaw":
        """Read the law off the instructions that say it."""
        found = {entry.instruction.t_spec: entry.half_base for entry in entries if entry.says_width}
        return cls(dict(sorted(found.items())))

    def __call__(self, t_spec: float) -> float:
        """Give w: linear between the points, and beyond the last with its slope; 0 without points."""
        times, values = list(self.points), list(self.points.values())
        if not times:
            return 0.0
        if len(times) == 1 or t_spec <= times[0]:
            return values[0]
        after = next((i for i in range(1, len(times)) if t_spec <= times[i]), len(times) - 1)
        slope = (values[after] - values[after - 1]) / (times[after] - times[after - 1])
        return values[after] + slope * (t_spec - times[after])
