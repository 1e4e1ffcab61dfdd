"""Repetitions in the end of something that goes on: "baste it every twenty minutes for the last hour"."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class ClosingRecurrence:
    """Every so many seconds of the last so many seconds of what goes on; when that is, it does not know.

    >>> ClosingRecurrence(step=1200, closing=3600).windows(86400)
    ()
    """

    step: float
    closing: float

    @property
    def endless(self) -> bool:
        """False: it ends with what goes on."""
        return False

    @property
    def spans(self) -> bool:
        """Whether words say where each occurrence begins and where it is over."""
        return False

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences."""
        return self.step

    def occurrences(self, until: float) -> tuple[float, ...]:  # noqa: ARG002 - nothing tells when it is
        """Give no times: they count from what goes on."""
        return ()

    def windows(self, until: float) -> tuple[tuple[float, float], ...]:  # noqa: ARG002 - as above
        """Give no times either."""
        return ()

    def spaced(self, length: float) -> "ClosingRecurrence":  # noqa: ARG002 - how often is said
        """Give the same."""
        return self
