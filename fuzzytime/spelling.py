"""Which known word was probably meant by one that is not known."""

import difflib
from collections.abc import Iterable
from heapq import nsmallest

MOST = 150
"""Known words that a word is compared with at most."""


def suggestion(word: str, known: Iterable[str]) -> str:
    """Say which known word was meant, or which there are, as the tail of a message."""
    choices = sorted({str(choice) for choice in known})
    close = nearest(word, choices)
    if close is not None:
        return f" (did you mean {close!r}?)"
    if not choices:
        return ""
    listed = ", ".join(choices[:12]) + (", …" if len(choices) > 12 else "")
    return f" (known: {listed})"


def nearest(word: str, known: Iterable[str], cutoff: float = 0.65) -> str | None:
    """Give the known word that is most like a word, whatever their case; None where none is.

    >>> nearest("abuot", ["about", "exactly"]), nearest("sine", ["hold", "linear"])
    ('about', None)
    """
    said = word.casefold()
    folded: dict[str, str] = {}
    for choice in map(str, known):
        folded.setdefault(choice.casefold(), choice)
    # The likeliest of very many: comparing takes time, and files may be hostile.
    likely = nsmallest(
        MOST, folded, key=lambda choice: (choice[:1] != said[:1], abs(len(choice) - len(said)))
    )
    close = difflib.get_close_matches(said, likely, 1, cutoff)
    return folded[close[0]] if close else None
