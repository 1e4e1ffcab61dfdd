"""Which known word was probably meant by one that is not known."""

import difflib
from collections.abc import Iterable


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
    folded: dict[str, str] = {}
    for choice in map(str, known):
        folded.setdefault(choice.casefold(), choice)
    close = difflib.get_close_matches(word.casefold(), folded, 1, cutoff)
    return folded[close[0]] if close else None
