"""How far above the bound labels are run next, and in how much room.

A threshold a little above the bound is cheap to prove, and doubles its distance when it is; one that labels
have no room for falls to half its distance, and is not tried again in the same room.
"""

import math
from dataclasses import dataclass

BYTES_PER_CELL = 16
"""Memory that a cell of labels takes."""

PROBING, PROVING = 16, 4
"""The share of the cells that labels have at first is one in so many; and after they proved something."""

WIDER = 6
"""So many times more sets a block has the next beam."""

LEAST = 0.05
"""Of the gap, a threshold is above the bound at least; where labels fail even so, the gap stays."""


@dataclass
class Reach:
    """What labels may do on one grid.

    Parameters
    ----------
    whole
        Cells of all labels, at most.
    cells
        Those that the next labels may have.
    width
        Sets a block in the next beam.
    delta
        How far above the bound the next threshold is, in cost.
    too_high
        A threshold below which there were too many labels.
    """

    whole: int
    cells: int
    width: int
    delta: float = 0.0
    too_high: float = math.inf

    @classmethod
    def within(cls, memory: int, width: int, *, is_solved: bool) -> "Reach":
        """Begin on a grid, with so much memory in bytes.

        One that follows a solved one has few starts, on more slots.
        """
        whole = memory // BYTES_PER_CELL
        return cls(whole, whole // (PROVING if is_solved else PROBING), width)

    def threshold(self, lower: float, best: float, known: float) -> float:
        """Give what labels must stay below: a little above the bound, or what the best schedule costs.

        That is where a schedule of the grid is known below that little: it would only be found again, and one
        run below the best tells all.

        Parameters
        ----------
        lower, best
            The bound, and what the best schedule costs.
        known
            What the best known schedule of the grid costs there.
        """
        above = min(best, lower + self.delta)
        return min(best if known < above else above, (lower + self.too_high) / 2)

    def prove(self, *, patiently: bool) -> None:
        """Go further, a threshold being proved.

        Labels that have proved something mostly come to an end in a little more room: they have it at once,
        unless patiently.
        """
        self.delta *= 2
        if not patiently:
            self.cells = max(self.cells, self.whole // PROVING)

    def widen(self) -> bool:
        """Take more room for labels and beams; tell whether there is more."""
        if self.cells >= self.whole:
            return False
        self.cells, self.width = 4 * self.cells, WIDER * self.width
        self.delta, self.too_high = self.delta / 2, math.inf
        return True

    def shorten(self, threshold: float, lower: float, best: float, known: float) -> bool:
        """Go half as far as to a threshold that needs too much room; tell whether that is far enough.

        Above what is known of the grid labels have nothing new to tell.
        """
        far = min(threshold, known) - lower
        if far <= LEAST * (best - lower):
            return False
        self.delta, self.too_high = far / 2, threshold
        return True
