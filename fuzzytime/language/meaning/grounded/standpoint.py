"""Where one stands when a time is said: what the same words mean depends on it."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from datetime import datetime
from typing import Generic, TypeVar

from fuzzytime.language.meaning.calendar import Today
from fuzzytime.language.meaning.expressions import Time, Wall
from fuzzytime.language.meaning.instants import Instants
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.language.policy import Policy

At = TypeVar("At", float, datetime)
"""How a clue says when: in seconds from when the instruction was given, or on the wall clock."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Clues(Generic[At]):
    """What the words around a time tell of which of several is meant, as far as they do.

    Parameters
    ----------
    since, day
        The clock time, and the day, that was said before in the same text.
    released
        The clock time before it, where it is only a deadline of a line before.
    event
        The day of what was told last to happen.
    ahead
        The day that those before it count from, as the days of a countdown do: that of its event.
    listed
        Whether it was said for the same thing to be done: "at eight and nine".
    follows
        Whether what is asked for comes after it.
    carried
        Whether another text said it, given at the same time: the line before.
    in_order
        Whether the lines so far go through a day in its order.
    begun
        Whether the day that the lines go through may have begun, so that it may be a little while ago.
    opened
        The earliest clock time that several lines so far said.
    due
        When that happens which is to be prepared: "the bus leaves at 8:05, so be there by 8".
    usual
        Whether the hours of the policy are those at which people do what is asked for.
    early
        Whether this is so of those on days to come.
    leads
        The clock time of what follows in the same sentence with the same thing: "open it at eight and close
        it at six".
    onto
        Whether this is what follows.
    overnight
        Whether it is the evening, or the morning that follows, of what is so overnight: "close it at eight,
        open it at seven".
    past
        Whether it is over: "her last turn was at six".
    night
        From when to when a line said that a shift goes on over midnight.
    window
        From when to when a line above says that all is, at most a day.
    """

    since: At | None = None
    day: At | None = None
    released: At | None = None
    event: At | None = None
    ahead: At | None = None
    listed: bool = False
    follows: bool = False
    carried: bool = False
    in_order: bool = False
    begun: bool = False
    opened: At | None = None
    due: At | None = None
    usual: bool = False
    early: bool = False
    leads: Clock | None = None
    onto: bool = False
    overnight: Half | None = None
    past: bool = False
    night: tuple[At, At] | None = None
    window: tuple[At, At] | None = None


@dataclass(frozen=True, slots=True)
class Standpoint(Clues[datetime], ABC):
    """The moment of an instruction, on the wall clock, the policy, and what was said before.

    Parameters
    ----------
    now : datetime
        Without a zone: wall-clock arithmetic is done here, zones are applied by the caller.
    policy : Policy
        What decides.
    lasting : float
        Seconds that what is asked for was said to last, 0 where nothing was said.
    ends : bool
        Whether it is a deadline, which is not now: nothing can be done by then.
    behind : bool
        Whether something is to be after it, which now is not.
    opens : bool
        Whether it is a deadline where what it names begins, which is to come: "before winter".
    """

    now: datetime
    policy: Policy
    lasting: float = 0.0
    ends: bool = False
    behind: bool = False
    opens: bool = False

    @property
    def today(self) -> Today:
        """The day of the instruction."""
        return Today(self.now.date(), self.policy)

    @abstractmethod
    def instants(self, said: Time) -> Instants:
        """Ground a time.

        Raises
        ------
        UngroundedError
            If the words name no time.
        """

    @abstractmethod
    def wall(self, wall: Wall) -> Instants:
        """Ground a time on the wall: a day, a part of it, a clock time."""
