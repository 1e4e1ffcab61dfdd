"""Marks in front of a line of a list that say how urgent it is, or where it belongs: "!high", "(A)", "p1"."""

import re
from collections.abc import Iterator, Sequence

from fuzzytime.language.instruction import Remark, RemarkKind, Span

BOX = r"(?:[-*+•]\s+)?(?:\[\s?\]\s+)?"
TAG = re.compile(
    rf"^\s*{BOX}(?P<tag>\([A-F]\)|!+[^\W\d]*\d?|[pP][1-4]|\#[^\W\d]\w*)(?=:?\s+\w):?", re.MULTILINE
)
"""A mark in front of what is asked for, with the box before it."""


def leading_tags(text: str) -> list[Span]:
    """Give the stretches of such marks.

    >>> leading_tags("!high call the bank at nine")
    [(0, 5)]
    """
    return [found.span("tag") for found in TAG.finditer(text)]


def remarks_of_tags(text: str, tags: Sequence[Span]) -> Iterator[Remark]:
    """Say that they are not used."""
    for span in tags:
        yield Remark(RemarkKind.POLICY, span, f"{text[slice(*span)]!r} is not used")
