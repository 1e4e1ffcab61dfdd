"""Repetitions in the end of something that goes on: "baste it every twenty minutes for the last hour"."""

from dataclasses import dataclass

from fuzzytime.language.meaning.recurrences.recurrence import PlainRecurrence
from fuzzytime.requirement import Window


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
