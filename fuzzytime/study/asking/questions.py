"""What a study asks: on which timeline, which instructions, what about the participant, and how directly."""

from dataclasses import dataclass

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats


@dataclass(frozen=True, slots=True)
class Timeline:
    """The times over which people draw: ``samples`` of them from ``start``, one per ``step``, in seconds."""

    start: float
    end: float
    samples: int

    @property
    def step(self) -> float:
        """Seconds from one sample to the next; the last one stands a step before the end."""
        return (self.end - self.start) / self.samples

    @property
    def times(self) -> Floats:
        """The samples' times, of shape (samples,)."""
        return self.start + self.step * np.arange(self.samples, dtype=float)


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyInstruction:
    """An instruction to draw for, and what it says about time: what the rulebook calls a requirement.

    ``t_spec`` is in seconds; ``word`` stands for preposition and number together ("now", "soon").
    """

    key: str
    text: str
    preposition: str
    t_spec: float
    fuzziness: str | None = None
    word: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """A question about the participant: one of several answers, a whole number, or a short text."""

    key: str
    ask: str
    choices: tuple[str, ...] = ()
    whole: tuple[int, int] | None = None
    length: int = 0

    def checked(self, answer: str) -> str:
        """Give the answer without space around it; an empty one is no answer.

        Raises
        ------
        FuzzytimeError
            If it is none of the answers asked for.
        """
        bare = answer.strip()
        if not bare:
            return bare
        if not is_writable(bare):
            raise FuzzytimeError(f"{self.key} must be a text, got {bare[:40]!r}")
        if self.choices and bare not in self.choices:
            raise FuzzytimeError(f"{self.key} must be one of {', '.join(self.choices)}, got {bare!r}")
        if self.whole is not None:
            low, high = self.whole
            if not (bare.isascii() and bare.isdigit() and len(bare) < 10 and low <= int(bare) <= high):
                raise FuzzytimeError(
                    f"{self.key} must be a whole number from {low} to {high}, got {bare[:40]!r}"
                )
        if self.length and len(bare) > self.length:
            raise FuzzytimeError(f"{self.key} must not be longer than {self.length} characters")
        return bare


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlQuestion:
    """A direct question on a Likert scale from 1 to ``points``: a start ``late`` seconds after ``t_spec``."""

    text: str
    t_spec: float
    late: float
    points: int
    lowest: str
    highest: str


def is_writable(text: str) -> bool:
    r"""Tell whether a text can be written to a file: JSON may hold half of a character.

    >>> is_writable("köttbullar"), is_writable("\ud800")
    (True, False)
    """
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True
