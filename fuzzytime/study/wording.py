"""Numbers, and ranges of them, as people read them."""

import math


def number(value: float, digits: int) -> str:
    """Write a number for a table or a sentence, with a true minus; a dash where there is none.

    >>> number(-0.5, 2), number(float("nan"), 2)
    ('−0.50', '–')
    """
    return f"{value:.{digits}f}".replace("-", "−") if math.isfinite(value) else "–"


def between(low: float, high: float, digits: int, unit: str = "") -> str:
    """Write a range of numbers, which may be one.

    >>> between(0.1, 0.25, 2), between(0.1, 0.1, 2, "min"), between(float("nan"), float("nan"), 2)
    ('0.10 to 0.25', '0.10 min', '–')
    """
    first, last = number(low, digits), number(high, digits)
    return (first if first == last else f"{first} to {last}") + (f" {unit}" if unit else "")


def probability(value: float) -> str:
    """Write a p-value, which is never nothing.

    >>> probability(0.0604), probability(0.0001)
    ('= 0.060', '< 0.001')
    """
    return "< 0.001" if value < 0.0005 else f"= {value:.3f}"
