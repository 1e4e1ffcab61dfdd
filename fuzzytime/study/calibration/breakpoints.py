"""How a trapezoid's corners depend on the time that was named: the sums of a rule table's models.

What is read off curves at a few times becomes the simplest sum that explains it: a constant, a share of the
width w, or both. Core and flanks are explained apart, so that a flank that is always equally long stays so.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Floats

HARDLY = 0.1
"""Widths differ hardly where they lie within this share of the largest."""


@dataclass(frozen=True, slots=True)
class Breakpoint:
    """constant + named · t + width · w, in seconds; constant may be infinite, and then stands alone.

    >>> Breakpoint(-10.09, 1.0, 0.2).text
    't + 0.2w - 10.09 s'
    """

    constant: float
    named: float = 0.0
    width: float = 0.0

    def value(self, t: float, w: float) -> float:
        """Give the corner for a time and a width."""
        return self.constant + self.named * t + self.width * w

    def plus(self, other: "Breakpoint", factor: float = 1.0) -> "Breakpoint":
        """Add a multiple of another sum."""
        return Breakpoint(
            self.constant + factor * other.constant,
            self.named + factor * other.named,
            self.width + factor * other.width,
        )

    @property
    def text(self) -> str:
        """The sum as rule tables write it."""
        if not np.isfinite(self.constant):
            return "inf" if self.constant > 0 else "-inf"
        parts = [
            (self.named, "t", 3),
            (self.width, "w", 3),
            (self.constant, " s", 2),
        ]
        text = ""
        for number, unit, digits in parts:
            size = f"{abs(number):.{digits}f}".rstrip("0").rstrip(".")
            if size == "0":
                continue
            shown = unit if size == "1" and unit in "tw" else size + unit
            sign = "-" if number < 0 else "+"
            text = f"{text} {sign} {shown}" if text else f"-{shown}" if number < 0 else shown
        return text or "0 s"


ZERO = Breakpoint(0.0)
AT_TIME = Breakpoint(0.0, 1.0)
NEVER_ENDS = Breakpoint(float("inf"))


def explained(lengths: Sequence[float], widths: Sequence[float], tolerance: float) -> Breakpoint:
    """Explain lengths in seconds by widths w in seconds, as simply as the tolerance allows.

    Tried are 0, then a constant or a share of w (the better of both), then their sum. No share is below 0:
    lengths count outward, and whoever is more lenient does not mean less. Where widths hardly differ nobody
    can tell a share from a constant, and there is no sum.
    """
    measured, w = np.array(lengths, float), np.array(widths, float)

    def missed(sum_: Breakpoint) -> Floats:
        return np.asarray(np.abs(sum_.constant + sum_.width * w - measured))

    if missed(ZERO).max() <= tolerance / 2:
        return ZERO
    constant = Breakpoint(float(measured.mean()))
    if not w.any():
        return constant
    share = Breakpoint(0.0, 0.0, max(0.0, float(measured @ w / (w @ w))))
    # One length alone is explained by either: then as a share, which grows where people grow lenient.
    best = min((share, constant), key=lambda sum_: float((missed(sum_) ** 2).sum()))
    if missed(best).max() <= tolerance or np.ptp(w) < HARDLY * w.max():
        return best
    growth = max(0.0, float(np.polyfit(w, measured, 1)[0]))
    return Breakpoint(float((measured - growth * w).mean()), 0.0, growth)
