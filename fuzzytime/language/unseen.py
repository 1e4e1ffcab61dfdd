"""What a text holds that nobody reads: codes that colour a terminal, and other marks that are not seen."""

import re

UNSEEN = re.compile(
    r"""
      (?:\x1b\[|\x9b) [0-?]* [ -/]* [@-~]                      # colours, the place of the cursor
    | (?:\x1b\]|\x9d) [^\x07\x1b\x9c]* (?:\x07|\x1b\\|\x9c)  # titles, and what words link to
    | \x1b [ -/]* [0-~]                                     # whatever else an escape begins
    | [\x00-\x08\x0e-\x1f\x7f-\x9f]                         # characters that only steer; tabs and lines stay
    | (?<!\w) [\u200b\u200e\u200f\u202a-\u202e\u2060\u2066-\u2069\ufeff]
    | [\u200b\u200e\u200f\u202a-\u202e\u2060\u2066-\u2069\ufeff] (?!\w)  # but inside of words they stay
    """,
    re.VERBOSE,
)
"""Control sequences (ECMA-48), and at the edges of words marks of Unicode that order or join what is seen."""


def without_unseen(text: str) -> str:
    r"""Put spaces in place of what is not seen, so that all else stays in its place.

    >>> without_unseen("call \x1b[1mmum\x1b[0m at noon")
    'call     mum     at noon'
    """
    if text.isprintable():
        return text
    return UNSEEN.sub(lambda found: " " * len(found[0]), text)
