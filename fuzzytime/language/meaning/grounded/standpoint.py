"""Where one stands when a time is said: what the same words mean depends on it."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from datetime import datetime

from fuzzytime.language.meaning.calendar import Today
from fuzzytime.language.meaning.expressions import Time, Wall
from fuzzytime.language.meaning.instants import Instants
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.language.policy import Policy


@dataclass(frozen=True, slots=True)
class Standpoint(ABC):
    """The moment of an instruction, on the wall clock, the policy, and what was said before.

    Parameters
    ----------
    now : datetime
        Without a zone: wall-clock arithmetic is done here, zones are applied by the caller.
    policy : Policy
        What decides.
    lasting : float
        Seconds that what is asked for was said to last, 0 where nothing was said.
    day : datetime, optional
        The day that was said before.
    since : datetime, optional
        The clock time that was said before in the same text.
    listed : bool
        Whether it was said for the same thing to be done.
    follows : bool
        Whether what is asked for comes after it.
    carried : bool
        Whether another text said it.
    in_order : bool
        Whether the texts so far go through a day in its order.
    opened : datetime, optional
        The earliest clock time of several texts so far.
    ends : bool
        Whether it is a deadline, which is not now: nothing can be done by then.
    opens : bool
        Whether it is a deadline where what it names begins, which is to come: "before winter".
    due : datetime, optional
        When that happens which is to be prepared.
    usual : bool
        Whether the plausible hours are those at which people do what is asked for.
    early : bool
        Whether the hours on days to come that are named are plausible on those that are not, too.
    leads : Clock, optional
        The clock time of what follows with the same thing.
    onto : bool
        Whether this is what follows.
    overnight : Half, optional
        Whether it is the evening, or the morning behind it, of what is so overnight.
    past : bool
        Whether it is over: the time is the last before now.
    night : tuple of datetime, optional
        From when to when what was said before goes on over midnight, which begins soon or goes on now.
    window : tuple of datetime, optional
        From when to when all is that a line above holds for, at most a day.
    """

    now: datetime
    policy: Policy
    lasting: float = 0.0
    since: datetime | None = None
    day: datetime | None = None
    listed: bool = False
    follows: bool = False
    carried: bool = False
    in_order: bool = False
    opened: datetime | None = None
    ends: bool = False
    opens: bool = False
    due: datetime | None = None
    usual: bool = False
    early: bool = False
    leads: Clock | None = None
    onto: bool = False
    overnight: Half | None = None
    past: bool = False
    night: tuple[datetime, datetime] | None = None
    window: tuple[datetime, datetime] | None = None

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
