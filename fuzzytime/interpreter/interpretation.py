"""A request understood: each wish as fuzzy skills, with everything that an explanation needs."""

from dataclasses import dataclass
from enum import StrEnum

from fuzzytime.interpreter.request import SpokenWish, Wish
from fuzzytime.language import Instruction, Operation, Reading
from fuzzytime.requirement import TimeRequirement
from fuzzytime.rulebook import OperationDuration, Resolution
from fuzzytime.skills import FuzzySkill, Precedence

WITHIN = "all of it should lie between the two: how long it takes was said, and it fits"
"""What an explanation notes of "between two and four, for an hour"; a plan says it of nobody."""


class ProblemKind(StrEnum):
    """Why something needs saying."""

    UNREADABLE = "unreadable"
    NOT_UNDERSTOOD = "not understood"
    UNRESOLVED = "unresolved reference"
    NOTHING_TO_DO = "nothing to do"
    REJECTED = "rejected"
    WAITS = "waits"
    NOTE = "note"


IN_THE_PLAN = frozenset({ProblemKind.NOTE, ProblemKind.REJECTED, ProblemKind.WAITS})
"""What a plan that is drawn shows by itself: nothing of it was misunderstood."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """Something that a person should know about a wish: a sentence, and the words at fault if any.

    ``line`` and ``text`` are those of the wish; ``span`` its first and one past last character at fault;
    ``identifier`` names the skill, where there is one.
    """

    kind: ProblemKind
    message: str
    line: int | None = None
    text: str = ""
    span: tuple[int, int] | None = None
    identifier: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Interpreted:
    """A skill to schedule, and where it comes from.

    Parameters
    ----------
    identifier
        Unique in the request: s1, s2, …, or as the wish says.
    wish
        What was asked.
    reading, instruction
        How its words were read; None for a skill without words.
    requirements, resolutions
        What it says about the start, and which table rows and rules gave each a ψ; same length.
    duration
        Where its durations come from.
    skill
        The fuzzy skill, ψ over seconds from the request's now.
    reason
        Why ψ is 0 everywhere; empty where it is not.
    waits
        Whether that is so only because nobody has told yet what it waits for: it has no time so far.
    follows
        Identifiers of the skills that it asked to come after; without them it makes no sense.
    in_order
        Whether it follows what was said before it because steps are done in the order said.
    tied_to
        Identifiers of what happens at a moment by which its time is told: it has that time.
    told_by
        Identifiers of the wishes that told anew of it, the latest last: its wish is that one.
    cancelled
        Whether it was told that it will not happen.
    """

    identifier: str
    wish: Wish
    skill: FuzzySkill
    duration: OperationDuration
    reading: Reading | None = None
    instruction: Instruction | None = None
    requirements: tuple[TimeRequirement, ...] = ()
    resolutions: tuple[Resolution, ...] = ()
    reason: str = ""
    waits: bool = False
    follows: tuple[str, ...] = ()
    in_order: bool = False
    tied_to: tuple[str, ...] = ()
    told_by: tuple[str, ...] = ()
    cancelled: bool = False

    @property
    def operation(self) -> Operation | None:
        """What is done, where words said it."""
        return None if self.instruction is None else self.instruction.operation

    @property
    def words(self) -> str | None:
        """What was said; None for a skill without words."""
        return self.wish.text if isinstance(self.wish, SpokenWish) else None

    @property
    def attended(self) -> bool:
        """Whether it is something that who speaks goes to: a workshop, a meeting."""
        return self.operation is not None and self.operation.attended

    @property
    def keeps_hands(self) -> float:
        """Seconds for which it leaves nobody's hands free: work, and what who speaks attends to its end."""
        return self.skill.time_until_done if self.attended else self.skill.duration

    @property
    def repeats(self) -> bool:
        """Whether it is done again and again."""
        return any(part.recurrence is not None for part in self.requirements)

    @property
    def stated(self) -> bool:
        """Whether words tell that it happens, and ask nobody to do it."""
        return self.operation is not None and self.operation.stated

    @property
    def asked(self) -> bool:
        """Whether words ask for something to be done."""
        return self.operation is not None and not self.operation.stated


@dataclass(frozen=True, slots=True, kw_only=True)
class Interpretation:
    """All wishes understood: skills in order, what binds them, what was not understood, how far ahead.

    ``order`` binds what is done in the order said, as long as that keeps nothing from its own time.
    ``waiting`` is set apart, and nothing binds it: it has no time until somebody tells what it waits for.
    """

    skills: tuple[Interpreted, ...]
    waiting: tuple[Interpreted, ...] = ()
    precedences: tuple[Precedence, ...] = ()
    order: tuple[Precedence, ...] = ()
    problems: tuple[Problem, ...] = ()
    horizon: float = 0.0

    @property
    def everything(self) -> tuple[Interpreted, ...]:
        """The skills to schedule, and behind them what waits."""
        return (*self.skills, *self.waiting)
