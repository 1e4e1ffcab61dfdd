"""What an instruction says about time: the value that language hands to the rulebook.

Times are seconds from the moment the instruction was given. A requirement keeps the words it came from, so
that every later answer can point at them.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Protocol


class Reference(StrEnum):
    """Which moment of the execution is meant; indicator verbs choose it (the paper's section III-A)."""

    START = "start"
    FINISH = "finish"
    THROUGHOUT = "throughout"


class Constraint(StrEnum):
    """How the words bind that moment."""

    AT = "at"
    BEFORE = "before"
    AFTER = "after"
    BETWEEN = "between"
    WHEN = "when"
    VAGUE = "vague"
    FOR = "for"
    EVERY = "every"


BOUNDS = frozenset({Constraint.BEFORE, Constraint.AFTER})
"""How times bind that bound what is done on one side."""

MOMENTS = frozenset({None, Constraint.AT})
"""How times bind that say when, with a preposition or without."""

SAID_WHEN = frozenset({Constraint.AT, Constraint.BETWEEN})
"""What says when something begins, and not only when at the latest or at the earliest."""

STRETCHES = frozenset({Constraint.BEFORE, Constraint.AFTER, Constraint.BETWEEN})
"""How times bind that leave a stretch to do something in: from a bound on, up to one, or between two."""


class Unit(StrEnum):
    """Units of time in speech; as a grain, the finest one that a wall-clock expression names."""

    SECOND = "second"
    MINUTE = "minute"
    HOUR = "hour"
    DAY = "day"
    WEEK = "week"
    MONTH = "month"
    QUARTER = "quarter"
    YEAR = "year"


class Edge(StrEnum):
    """A moment of another skill: its start, when hands are free of it, when its result is there."""

    START = "start"
    FREE = "free"
    END = "end"


@dataclass(frozen=True, slots=True)
class Lasting:
    """How long a condition must have held: "hot for about two minutes"."""

    number: float
    unit: Unit
    fuzziness: tuple[str, ...] = ()


class Side(StrEnum):
    """On which side of a number something must be; ``at`` comes from either."""

    ABOVE = "above"
    AT_LEAST = "at least"
    AT = "at"
    AT_MOST = "at most"
    BELOW = "below"
    BETWEEN = "between"


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """A number that a clause measures something by: "above about 150 degrees".

    ``text`` is how it is said, without what is counted or measured in, which is the first of the words
    ``behind`` it. ``until`` is the second number of "between 150 and 180", None elsewhere.
    """

    text: str
    side: Side
    number: float
    until: float | None = None
    fuzziness: tuple[str, ...] = ()
    behind: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Condition:
    """A clause such as "when the pan is very hot": what must hold before the skill starts.

    ``subject`` is the noun without its determiner ("frying pan"), ``word`` what is said of it ("hot"),
    ``hedges`` the words between ("very"); a clause that does not have this form keeps its text only.
    ``comparisons`` are the numbers in it, in the order of the words. ``target`` is the position of the
    instruction that makes it so ("warm up the printer"), which counts where no reading tells; ``about`` that
    of the latest that is about the same thing ("paint the door", where the paint is dry). ``takes`` is how
    many seconds it takes then to become so, where that is said. ``goes_on`` says that something is so for a
    time and is waited for no longer than until it begins: "while the bread bakes". ``excepted`` says that
    words leave out the time when it is so, and wait for nothing: "unless it rains", "not while Ann sleeps".
    ``contrary`` says that what ``text`` says must not be so: "if it rains, take the bus, otherwise walk".
    """

    text: str
    subject: str | None = None
    word: str | None = None
    hedges: tuple[str, ...] = ()
    negated: bool = False
    lasting: Lasting | None = None
    comparisons: tuple[Comparison, ...] = ()
    target: int | None = None
    about: int | None = None
    takes: float | None = None
    goes_on: bool = False
    excepted: bool = False
    contrary: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Anchor:
    """Another instruction, or an event, to measure from: "five minutes before you serve the soup".

    ``target`` is the position of that instruction among all given so far, from 0, or None for an event or
    a reference that could not be resolved. ``lag`` is in seconds, negative before the anchor; ``exact`` says
    that the lag is wished for ("five minutes before"), not only its sign ("before"); it counts from ``edge``,
    or from the ``share`` of its length that is over then ("halfway through"). ``lasting`` and
    ``comparisons`` are those of a state that is measured from ("after the oven is above 150 degrees").
    ``assumed`` says that nothing tells of such a state, and that the target is only about the same thing.
    ``turn`` is which occurrence of a repetition is meant, from 0, and None where that is not said; ``each``
    are the positions of all instructions that words name, where every occurrence of each is meant ("after
    each milking", "between milkings").
    """

    text: str
    verb: str | None = None
    object: str | None = None
    target: int | None = None
    edge: Edge = Edge.END
    lag: float = 0.0
    exact: bool = False
    share: float | None = None
    lasting: Lasting | None = None
    comparisons: tuple[Comparison, ...] = ()
    assumed: bool = False
    turn: int | None = None
    each: tuple[int, ...] = ()


Window = tuple[float, float]
"""Where an occurrence begins, and where it is over, in seconds; a moment where the two are one."""


class Recurrence(Protocol):
    """A repetition: "every twenty minutes", "on weekdays at nine"."""

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences, None where they are not evenly spaced."""
        ...

    @property
    def endless(self) -> bool:
        """Whether no end of the repetition is named."""
        ...

    @property
    def closing(self) -> float | None:
        """Seconds at the end of what goes on in which it lies: "every ten minutes for the last hour"."""
        ...

    @property
    def spans(self) -> bool:
        """Whether words say where each occurrence begins and where it is over: "every day from 9 to 10"."""
        ...

    @property
    def all_day(self) -> bool:
        """Whether nothing but a day bounds it: "on thursday every hour"."""
        ...

    def occurrences(self, until: float) -> tuple[float, ...]:
        """Give the occurrences' times from 0 to ``until``, in seconds from when the instruction was given."""
        ...

    def spaced(self, length: float) -> "Recurrence":
        """Give the same for what goes on that many seconds, where gaps are said and not the times."""
        ...

    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the same with their ends: of "every morning", where each begins and is over."""
        ...

    def coming(self, count: int) -> tuple[Window, ...]:
        """Give the next occurrences with their ends, however far ahead, at most so many."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class TimeRequirement:
    """One temporal specification of an instruction, in the paper's terms and with its words.

    Parameters
    ----------
    text, span
        The words as typed, and their first and one past last character in the instruction.
    constraint, reference
        How they bind which moment of the execution.
    denied
        Whether the words say when not: of "don't open it before six" the constraint is ``after``.
    reference_said
        Whether the words name that moment ("start cooking by six"); where they do not, tables may choose it.
    preposition
        The preposition in lower case, None where there is none ("now", "tomorrow").
    word
        The time word that needs no number ("now", "soon", "later"), in its dictionary form; None elsewhere.
    fuzziness
        Hedges in lower case, in the order said: ``("about",)``; ``("shortly before",)`` beside an anchor.
    number, unit
        As said: "in about two minutes" has 2 and minute, "at six" has neither.
    grain
        The finest unit that a wall-clock expression names: "tomorrow" day, "at 6:30" minute; None for others.
    t_spec
        The time that the words name, in seconds: the goal (at), the deadline (before), the release (after).
        None where no single time is named (between, vague, when, every).
    earliest, latest
        The same as bounds, in seconds; None on a side that is open.
    condition, anchor, recurrence
        For constraint ``when``; for times that depend on another instruction; for ``every``.
    alternative
        Whether it may be kept instead of the one before it: the second of "at seven or at eight".
    """

    text: str
    span: tuple[int, int]
    constraint: Constraint
    reference: Reference = Reference.START
    denied: bool = False
    reference_said: bool = False
    preposition: str | None = None
    word: str | None = None
    fuzziness: tuple[str, ...] = ()
    number: float | None = None
    unit: Unit | None = None
    grain: Unit | None = None
    t_spec: float | None = None
    earliest: float | None = None
    latest: float | None = None
    condition: Condition | None = None
    anchor: Anchor | None = None
    recurrence: Recurrence | None = None
    alternative: bool = False

    @property
    def asked(self) -> str:
        """The words as they ask for a time: "not before six" where they say when not."""
        return f"not {self.text}" if self.denied else self.text

    def shifted(self, by: float) -> "TimeRequirement":
        """Give the same requirement on a timeline whose origin is ``by`` seconds earlier."""

        def moved(time: float | None) -> float | None:
            return None if time is None else time + by

        return replace(
            self, t_spec=moved(self.t_spec), earliest=moved(self.earliest), latest=moved(self.latest)
        )


def asked_words(requirements: Iterable[TimeRequirement], joint: str = ", ") -> str:
    """Give the words of requirements as they ask for times: "at six or at eight, for ten minutes"."""
    words = ""
    last: TimeRequirement | None = None
    for requirement in requirements:
        again = last is not None and requirement.span == last.span
        if last is not None and again and (requirement.alternative or requirement.text == last.text):
            # "One evening this week" is one time of several, and "once both are done" binds to two.
            continue
        last = requirement
        between = "" if not words else " or " if requirement.alternative else joint
        words += between + requirement.asked
    return words
