"""Synthetic participants with a known truth, so that the road from answers to a table can be tested.

Each participant has a width of their own: a factor about the specified time, the same in all instructions.
The factors are the quantiles of a log-normal distribution in random order, so that the median participant
of every sample stands exactly for its population; groups are random halves of it. The hand then wobbles in
time and in satisfaction, and leaves the canvas alone where there is nothing to draw.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats, SatisfactionFunction
from fuzzytime.study.answers.participants import Answers, Origin, Participant
from fuzzytime.study.asking.design import Design
from fuzzytime.study.asking.questions import Question, StudyInstruction

Truth = Callable[[StudyInstruction, str], SatisfactionFunction]
"""ψ of the median participant, for an instruction and a group."""

INVENTED_TEXTS = ("northern", "southern", "eastern", "western")
"""What synthetic participants answer where a text is asked for."""

RESOLUTION = 1 / 300
"""The finest step in satisfaction: a pixel of a canvas."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Hand:
    """How a drawn curve misses the one that was meant.

    Parameters
    ----------
    time
        Standard deviation of the error in time, in seconds: two pixels of a canvas that shows 15 min.
    satisfaction
        Standard deviation of the error in satisfaction: three pixels of a canvas.
    smoothness
        Seconds over which errors stay alike.
    margin
        Seconds on both sides of what is meant over which the hand draws along the bottom, at most.
    """

    time: float = 2.0
    satisfaction: float = 0.01
    smoothness: float = 15.0
    margin: float = 30.0

    def __post_init__(self) -> None:
        for name in ("time", "satisfaction", "margin"):
            if not 0 <= getattr(self, name) < np.inf:
                raise FuzzytimeError(
                    f"a hand's error in {name} must be at least 0 and finite, got {getattr(self, name)}"
                )
        if not 0 < self.smoothness < np.inf:
            raise FuzzytimeError(f"a hand's smoothness must be above 0 and finite, got {self.smoothness}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Population:
    """How participants differ.

    Parameters
    ----------
    individual
        Standard deviation of the logarithm of their widths.
    group_widths
        Width of each group over that of all, for those that differ: ``{"person": 1.5}``.
    inattentive
        How many, of all, draw nothing near the time of one instruction.
    hand
        How they draw.
    """

    individual: float = 0.2
    group_widths: Mapping[str, float] | None = None
    inattentive: int = 0
    hand: Hand = Hand()

    def __post_init__(self) -> None:
        if not 0 <= self.individual < np.inf:
            raise FuzzytimeError(
                f"the spread of individual widths must be at least 0 and finite, got {self.individual}"
            )
        for group, width in (self.group_widths or {}).items():
            if not 0 < width < np.inf:
                raise FuzzytimeError(f"the width of group {group!r} must be above 0 and finite, got {width}")
        if self.inattentive < 0:
            raise FuzzytimeError(
                f"the number of inattentive participants must be at least 0, got {self.inattentive}"
            )


def simulate(
    design: Design,
    truth: Truth | Mapping[str, SatisfactionFunction],
    participants: int = 32,
    *,
    seed: int = 0,
    population: Population | None = None,
) -> Answers:
    """Draw a study's answers.

    Parameters
    ----------
    design : Design
        What is asked.
    truth : callable or mapping
        ψ of the median participant for an instruction and a group, or by an instruction's key alone.
    participants : int
        How many; groups are as equal as can be.
    seed : int
        The same seed gives the same answers.
    population : Population, optional
        How participants differ.

    Raises
    ------
    FuzzytimeError
        If the truth lacks an instruction, the population names a group that is not there, or there is
        nobody to draw.
    """
    people = population or Population()
    _check(design, truth, participants, people)
    meant = (lambda instruction, _group: truth[instruction.key]) if isinstance(truth, Mapping) else truth
    generator = np.random.default_rng(seed)
    groups = generator.permutation([*design.groups] * -(-participants // len(design.groups)))[:participants]
    quantiles = norm_quantiles((np.arange(participants) + 0.5) / participants)
    widths = np.exp(people.individual * generator.permutation(quantiles))
    distracted = set(generator.permutation(participants)[: people.inattentive].tolist())
    drawn = []
    for position, group in enumerate(groups.tolist()):
        width = float(widths[position]) * (people.group_widths or {}).get(group, 1.0)
        draw = _Draw(design, meant, group, width, people.hand, generator)
        drawn.append(draw.participant(f"s{seed}-{position + 1:03d}", attentive=position not in distracted))
    return Answers(design, tuple(drawn))


def norm_quantiles(probabilities: Floats) -> Floats:
    """Give standard normal quantiles."""
    normal = NormalDist()
    return np.array([normal.inv_cdf(probability) for probability in probabilities.tolist()])


def _check(
    design: Design,
    truth: Truth | Mapping[str, SatisfactionFunction],
    participants: int,
    population: Population,
) -> None:
    if participants < 1:
        raise FuzzytimeError(f"a study needs at least one participant, got {participants}")
    unknown = sorted((population.group_widths or {}).keys() - design.groups.keys())
    if unknown:
        raise FuzzytimeError(f"a group must be one of {', '.join(design.groups)}, got {unknown[0]!r}")
    if isinstance(truth, Mapping):
        missing = [entry.key for entry in design.instructions if entry.key not in truth]
        if missing:
            raise FuzzytimeError(f"the truth must give ψ for every instruction, got none for {missing[0]!r}")


@dataclass(frozen=True, slots=True)
class _Draw:
    """One participant at work."""

    design: Design
    truth: Truth
    group: str
    width: float
    hand: Hand
    generator: np.random.Generator

    def participant(self, name: str, *, attentive: bool) -> Participant:
        order = [entry.key for entry in self.design.instructions]
        self.generator.shuffle(order)
        curves = {entry.key: self._curve(entry) for entry in self.design.instructions}
        if not attentive:
            curves[order[-1]] = np.zeros(self.design.timeline.samples)
        answers = {question.key: self._answer(question) for question in self.design.demographics}
        return Participant(
            name=name,
            group=self.group,
            order=tuple(order),
            curves=curves,
            demographics={key: answer for key, answer in answers.items() if answer},
            control=self._control(),
            origin=Origin.SIMULATED,
        )

    def _meant(self, instruction: StudyInstruction, times: Floats) -> Floats:
        """Give what this participant means: the truth, as wide about its time as they are lenient.

        Of a plateau that is under way when the timeline begins only the end is theirs to choose.
        """
        truth, anchor = self.truth(instruction, self.group), instruction.t_spec
        scaled = anchor + (times - anchor) / self.width
        if truth(self.design.timeline.start) >= 1:
            scaled = np.where(times < anchor, times, scaled)
        return truth(scaled)

    def _curve(self, instruction: StudyInstruction) -> Floats:
        """Draw what the hand makes of what is meant."""
        times = self.design.timeline.times
        margins = self.generator.uniform(0.0, self.hand.margin, 2)
        late = self.hand.time * self._wobble()
        lift = self.hand.satisfaction * self._wobble()
        drawn = np.clip(self._meant(instruction, np.maximum(times + late, times[0])) + lift, 0.0, 1.0)
        there = np.flatnonzero(self._meant(instruction, times) > 0)
        if not there.size:
            return np.full(times.shape, self.design.default)
        touched = (times >= times[there[0]] - margins[0]) & (times <= times[there[-1]] + margins[1])
        return np.where(touched, np.round(drawn / RESOLUTION) * RESOLUTION, self.design.default)

    def _wobble(self) -> Floats:
        """Smooth noise of unit variance, of shape (samples,)."""
        samples = self.design.timeline.samples
        frequency = np.fft.rfftfreq(samples, self.design.timeline.step)
        response = np.exp(-((2 * np.pi * frequency * self.hand.smoothness) ** 2) / 4)
        noise = np.fft.irfft(np.fft.rfft(self.generator.standard_normal(samples)) * response, samples)
        return np.asarray(noise / np.sqrt((response**2).mean()))

    def _answer(self, question: Question) -> str:
        """Answer as a convenience sample does; one answer in sixteen is left open."""
        if self.generator.random() < 1 / 16:
            return ""
        if question.choices:
            return str(self.generator.choice(question.choices))
        if question.whole is not None:
            low, high = question.whole
            return str(self.generator.integers(max(low, min(21, high)), min(high, max(35, low)) + 1))
        return str(self.generator.choice(INVENTED_TEXTS))[: question.length]

    def _control(self) -> int | None:
        """Answer by the satisfaction meant for that late a start, give or take one point."""
        control = self.design.control
        if control is None:
            return None
        alike = [entry for entry in self.design.instructions if entry.t_spec == control.t_spec]
        start = np.array(control.t_spec + control.late)
        meant = float(self._meant(alike[0], start)) if alike else 0.5
        answer = 1 + (control.points - 1) * meant + 0.8 * self.generator.standard_normal()
        return int(np.clip(round(answer), 1, control.points))
