"""Repetitions so long behind others ("lock up, and set the alarm an hour later"), or at their ends."""

from dataclasses import dataclass, replace
from typing import Self

from fuzzytime.language.meaning.recurrences.recurrence import PlainRecurrence
from fuzzytime.requirement import Recurrence, Window


@dataclass(frozen=True, slots=True)
class DelayedRecurrence:
    """Each occurrence of another repetition, so many seconds later.

    >>> from fuzzytime.language.meaning.recurrences.recurrence import EvenRecurrence
    >>> DelayedRecurrence(EvenRecurrence(step=3600, first=3600), 600).occurrences(7800)
    (4200, 7800)
    """

    of: Recurrence
    by: float

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences, None where they are not evenly spaced."""
        return self.of.interval

    @property
    def endless(self) -> bool:
        """Whether no end of the repetition is named."""
        return self.of.endless

    @property
    def closing(self) -> float | None:
        """Seconds at the end of what goes on in which it lies."""
        return self.of.closing

    @property
    def spans(self) -> bool:
        """Whether words say where each occurrence begins and where it is over."""
        return self.of.spans

    @property
    def all_day(self) -> bool:
        """Whether nothing but a day bounds it."""
        return self.of.all_day

    def occurrences(self, until: float) -> tuple[float, ...]:
        """Give the times from 0 to ``until``, in seconds from when the instruction was given."""
        return tuple(time + self.by for time in self.of.occurrences(until - self.by))

    def spaced(self, length: float) -> Self:
        """Give the same for what goes on that many seconds."""
        return replace(self, of=self.of.spaced(length))

    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the same with their ends."""
        return self._delayed(self.of.windows(until - self.by))

    def coming(self, count: int) -> tuple[Window, ...]:
        """Give the next occurrences, at most so many."""
        return self._delayed(self.of.coming(count))

    def _delayed(self, windows: tuple[Window, ...]) -> tuple[Window, ...]:
        return tuple((begin + self.by, end + self.by) for begin, end in windows)


@dataclass(frozen=True, slots=True, kw_only=True)
class ClosingRecurrence(PlainRecurrence):
    """Every so many seconds of the last so many seconds of what goes on; when that is, it does not know.

    >>> ClosingRecurrence(step=1200, stretch=3600).windows(86400)
    ()
    """

    step: float
    stretch: float

    @property
    def closing(self) -> float:
        """Seconds at the end of what goes on."""
        return self.stretch

    @property
    def endless(self) -> bool:
        """False: it ends with what goes on."""
        return False

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences."""
        return self.step

    def windows(self, until: float) -> tuple[Window, ...]:  # noqa: ARG002 - nothing tells when it is
        """Give no times: they count from what goes on."""
        return ()

    def coming(self, count: int) -> tuple[Window, ...]:  # noqa: ARG002 - as above
        """Give no times either."""
        return ()
