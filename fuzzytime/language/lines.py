"""Lines of a text: where one ends a sentence though no mark says so."""

import re
from collections.abc import Set as AbstractSet

BREAK = re.compile(
    r"(?P<before>[^\W_]+)[ \t\r]*(?P<end>\n)\s*(?P<bullet>[-*•+]\s+)?(?=[^\W\d_])(?P<after>\w)"
)
"""A word, the end of its line, and the letter that the next line begins with, behind a bullet if any."""

HEADING = re.compile(r"[^\n]*:[ \t\r]*\n")
"""A first line that ends with a colon."""

FIRST = re.compile(r"[^\W\d_]+")
"""The first word of a line."""

STOP = ";"
"""The mark that stands for the end of a line: it ends a sentence also where no space follows."""


def with_stops(text: str, function_words: AbstractSet[str]) -> str:
    r"""Put a mark at the ends of lines that end a sentence; all else stays in its place.

    A line goes on where the next one begins small ("call Bob\nat one"), or where it ends in a word that
    wants another ("the parcel for\nAnna"). Below a heading, lines that begin small are others too.

    >>> with_stops("Call Bob at one\nCall Joe at two", frozenset())
    'Call Bob at one;Call Joe at two'
    >>> with_stops("Call Bob\nat one", frozenset())
    'Call Bob\nat one'
    """
    if "\n" not in text:
        return text
    found = list(text)
    below = HEADING.match(text) is not None
    for match in BREAK.finditer(text):
        first = FIRST.match(text, match.start("after"))
        listed = below and first is not None and first[0].lower() not in function_words
        begins = (match["after"].isupper() or listed) and match["before"].lower() not in function_words
        if begins or match["bullet"] is not None:
            found[match.start("end")] = STOP
    return "".join(found)
