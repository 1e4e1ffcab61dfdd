"""Marks in front of a line of a list that say how urgent it is, or what: "!high", "(A)", "reminder:"."""

import re
from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Remark, Span, blanked

BOX = r"(?:[-*+•]\s+)?(?:\[\s?\]\s+)?"
TAG = re.compile(
    rf"^\s*{BOX}(?P<tag>\([A-F]\)|!+[^\W\d]*\d?|[pP][1-4]|\#[^\W\d]\w*)(?=:?\s+\w):?", re.MULTILINE
)
"""A mark in front of what is asked for, with the box before it."""

BULLET = re.compile(r"^[ \t]*(?P<bullet>[-*+•–])(?=[ \t]+\w)", re.MULTILINE)
"""A mark of a list at the start of a line, which is no word of it."""

LABEL = re.compile(rf"^\s*{BOX}(?P<label>[^\W\d][\w.]*(?:[ -]\w+)?)(?:[ \t]+-|:)[ \t]+(?=\w)", re.MULTILINE)
"""A word with a colon or a dash behind it, or two, before more on the same line."""


def leading_tags(text: str) -> list[Span]:
    """Give the stretches of such marks that may say something.

    >>> leading_tags("!high call the bank at nine")
    [(0, 5)]
    """
    return [found.span("tag") for found in TAG.finditer(text)]


def without_bullets(text: str) -> str:
    """Give a text of the same length without the bullets of its lines.

    >>> without_bullets("- tea 5.30")
    '  tea 5.30'
    """
    return blanked(text, (bullet.span("bullet") for bullet in BULLET.finditer(text)))


def leading_labels(text: str, lexicon: Lexicon) -> list[Span]:
    """Give the stretches of labels, which say nothing: "reminder: call the bank at nine"."""
    labels = (label for label in LABEL.finditer(text) if label["label"].lower() in lexicon.doing.labels)
    return [(label.start("label"), label.end()) for label in labels]


def remarks_of_tags(text: str, tags: Sequence[Span]) -> Iterator[Remark]:
    """Say that they are not used."""
    for span in tags:
        yield Remark.noted(text, span, "is not used")
