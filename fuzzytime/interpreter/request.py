"""What a person asks for, before it is understood: wishes in words or as skills, and what surrounds them.

A task file, lines of text, and a session in the terminal all become a `Request`; planning knows nothing else.
"""

from dataclasses import dataclass, field, replace
from datetime import datetime

from fuzzytime.context import Context
from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime.skills import Busy

MAX_HORIZON = 3660 * 86400.0
"""How far a plan looks ahead at most, in seconds, unless a horizon is given: ten years."""

WITHOUT_END = 48 * 3600.0
"""How far it looks, in seconds, for what names no end: open wishes, repetitions, conditions."""


@dataclass(frozen=True, slots=True)
class Moved:
    """How a wish was moved after it was said: "push it back by ten minutes".

    Parameters
    ----------
    by
        Seconds by which all that it says of its time is moved: later above 0, earlier below.
    to
        The start that it is moved to; none sooner satisfies, or none later where it is moved to be earlier.
        None binds nothing, as for what has several starts.
    """

    by: float
    to: datetime | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Wish:
    """What words and direct skills share.

    Parameters
    ----------
    given
        The moment from which its times count.
    line
        Its line in the input, from 1; None where it has none.
    identifier
        A name for references; empty for its number among the wishes (s1, s2, …), as `Request.named` gives it.
    hands_on, elapsed
        Durations in seconds that override what words and tables say; None where not given.
    priority, agent
        As in `FuzzySkill`.
    after
        Identifiers of what must be done before.
    moved
        How it was moved after it was said; None where it was not.
    """

    given: datetime
    line: int | None = None
    identifier: str = ""
    hands_on: float | None = None
    elapsed: float | None = None
    priority: float = 1.0
    agent: int | None = None
    after: tuple[str, ...] = ()
    moved: Moved | None = None

    def __post_init__(self) -> None:
        if self.hands_on is not None and self.elapsed is not None and self.elapsed < self.hands_on:
            raise FuzzytimeError(
                "elapsed time must not be shorter than hands-on time, "
                f"got {self.elapsed:g} s and {self.hands_on:g} s"
            )


@dataclass(frozen=True, slots=True, kw_only=True)
class SpokenWish(Wish):
    """An instruction in words.

    ``parts`` are the numbers by which the several things are called that it asks for, in their order, where
    it once asked for others too; empty where they are called by their places.
    """

    text: str
    parts: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class DirectWish(Wish):
    """A skill given by its satisfaction function, without words."""

    name: str
    satisfaction: SatisfactionFunction


@dataclass(frozen=True, slots=True, kw_only=True)
class Started:
    """A skill of an earlier plan that has started, and so stays where it is; times in seconds from now.

    ``done`` is infinite for one that failed: what asked to come after it cannot be done either.
    """

    identifier: str
    start: float
    end: float
    done: float
    agent: int = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """Everything that planning needs to know.

    Parameters
    ----------
    now
        The plan's moment zero.
    wishes
        In the order in which they were given.
    agents
        How many can work at once.
    context
        Readings, in seconds relative to ``now``.
    busy
        Times that are taken, in seconds relative to ``now``.
    horizon
        Seconds ahead; None looks past the last window, at most `MAX_HORIZON`, and `WITHOUT_END` for what
        has none.
    started
        Skills of these wishes that have started.
    in_order
        Whether wishes in words are steps, each after the one before unless words say another order. A
        numbered list is so by itself.
    unread
        Sentences about what of this could not be read, such as an event of a calendar: a plan's problems.
    awaits_readings
        Whether readings may still come that tell of a condition: then nothing is assumed of it.
    """

    now: datetime
    wishes: tuple[Wish, ...]
    agents: int = 1
    context: Context = field(default_factory=Context)
    busy: tuple[Busy, ...] = ()
    horizon: float | None = None
    started: tuple[Started, ...] = ()
    in_order: bool = False
    unread: tuple[str, ...] = ()
    awaits_readings: bool = False

    def named(self) -> "Request":
        """Give the request with every wish named: as it is, or s1, s2, … by its place among the wishes."""
        taken = {wish.identifier for wish in self.wishes}
        wishes = []
        for number, wish in enumerate(self.wishes, 1):
            name = wish.identifier
            if not name:
                name = f"s{number}"
                while name in taken:
                    name += "'"
                taken.add(name)
            wishes.append(replace(wish, identifier=name))
        return replace(self, wishes=tuple(wishes))
