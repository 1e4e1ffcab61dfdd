"""What is quoted in a text: words that are said, sent or written, and ask for nothing."""

import re

from fuzzytime.language.instruction import Span

QUOTED = re.compile(
    r"""(?<![^\s(\[,:;-])(?:"[^"\n]+"|“[^”\n]+”|«[^»\n]+»|'(?!(?:till?|cause|cos|em)\b)[^'\n]+'|‘[^’\n]+’)"""
    r"""(?![^\s.,;:!?)\]])"""
)
"""Words between quotation marks that stand apart; not the inches of a 5" pipe, nor the mark of 'til."""


def quotes_in(text: str) -> list[Span]:
    """Give the stretches of a text that are quoted, with their marks; none where nothing else is said.

    >>> quotes_in('text Jo "back at six" at five')
    [(8, 21)]
    >>> quotes_in('"call mum at six"')
    []
    """
    found = [match.span() for match in QUOTED.finditer(text)]
    rest = QUOTED.sub("", text)
    return found if any(character.isalnum() for character in rest) else []


def is_quoted(text: str) -> bool:
    """Whether a text is words between quotation marks."""
    return QUOTED.fullmatch(text) is not None
