"""A canvas of braille cells, two dots wide and four high, or of plain characters."""

import numpy as np
from numpy.typing import NDArray

BRAILLE = 0x2800
_DOTS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]])
_PLAIN = ((" ", "."), ("'", ":"))


class Canvas:
    """Dots on ``rows`` × ``columns`` characters; coordinates are shares from 0 to 1, up and to the right."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self.dots = np.zeros((rows * 4, columns * 2), bool)

    def curve(self, across: NDArray[np.float64], up: NDArray[np.float64]) -> None:
        """Draw a curve through points; a gap (NaN) interrupts it."""
        height, width = self.dots.shape
        x, y = across * (width - 1), (1 - up) * (height - 1)
        for first in range(len(x) - 1):
            ends = x[first], y[first], x[first + 1], y[first + 1]
            if not np.isfinite(ends).all():
                continue
            steps = int(max(abs(ends[2] - ends[0]), abs(ends[3] - ends[1]), 1)) + 1
            self._set(np.linspace(ends[0], ends[2], steps), np.linspace(ends[1], ends[3], steps))

    def points(self, across: NDArray[np.float64], up: NDArray[np.float64]) -> None:
        """Draw points."""
        height, width = self.dots.shape
        good = np.isfinite(across) & np.isfinite(up)
        self._set(across[good] * (width - 1), (1 - up[good]) * (height - 1))

    def vertical(self, across: float) -> None:
        """Draw a dotted line from bottom to top."""
        height, width = self.dots.shape
        rows = np.arange(0, height, 2)
        self._set(np.full(rows.size, across * (width - 1)), rows.astype(float))

    def _set(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> None:
        column, row = np.rint(x).astype(int), np.rint(y).astype(int)
        height, width = self.dots.shape
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        self.dots[row[inside], column[inside]] = True

    def lines(self, *, unicode: bool = True) -> list[str]:
        """Give the canvas as lines of text, top first."""
        cells = self.dots.reshape(self.rows, 4, self.columns, 2).transpose(0, 2, 1, 3)
        if unicode:
            codes = BRAILLE + (cells * _DOTS).sum(axis=(2, 3))
            return ["".join(map(chr, row)) for row in codes]
        upper = cells[:, :, :2].any(axis=(2, 3)).astype(int)
        lower = cells[:, :, 2:].any(axis=(2, 3)).astype(int)
        rows = range(self.rows)
        return ["".join(_PLAIN[upper[row, x]][lower[row, x]] for x in range(self.columns)) for row in rows]
