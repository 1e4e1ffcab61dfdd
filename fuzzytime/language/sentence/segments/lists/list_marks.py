"""Marks of numbered lists, which say an order and no time: "1. Chop the onions", "2) Fry", "Step 3: …"."""

import re
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span

MARK = re.compile(
    r"\b(?:step|stage)\s+(?P<step>\d{1,2}|[a-z]+)\s*(?:[:.)]|-\s)\s*"
    r"|(?P<first>(?<![\w.,:])\(?)(?P<number>\d{1,2})[.)]\s+(?=[^\W\d]|(?P<timed>\d))",
    re.IGNORECASE,
)
"""A number with a full stop or a bracket before a word, or "step" and a number."""

HOUR = r"(?:\d{1,2}(?:[:.h]\d\d)?\s?(?:[ap]m\b)?|\d{4})"
CLOCK = r"\d{1,2}[:h]\d\d"
TIMED = re.compile(
    rf"{HOUR}(?:\s?(?:[-–]|to|till)\s?{HOUR})?(?:\s[-–—|>=→/(\[]|:)?\s+(?:[^\W\d]|[(\[]\d)"
    rf"|{CLOCK}(?:\s?(?:[-–]|to|till)\s?{CLOCK})?\s+\d",
    re.IGNORECASE,
)
"""The clock time that an item begins with, and what is then: "1. 10:00 call Bob", "2) 9:30 2 calls"."""

BEGINS = re.compile(r"[\s>*•+-]*\Z")
"""What may stand in a line before its mark."""


@dataclass(frozen=True, slots=True)
class ListMark:
    """A mark that begins an item: its stretch and its number."""

    span: Span
    number: int


def list_marks(text: str, lexicon: Lexicon) -> list[ListMark]:
    """Give the marks of a text in order: where a line begins, and those that count on behind them."""
    marks: list[ListMark] = []
    for match in MARK.finditer(text):
        number = _number(match, lexicon)
        if number is None or _is_date(text, match, lexicon):
            continue
        line = text.rfind("\n", 0, match.start()) + 1
        begins = BEGINS.match(text[line : match.start()]) is not None
        counts_on = bool(marks) and number == marks[-1].number + 1
        if match["timed"] and TIMED.match(text[match.end() :]) is None:
            continue
        if begins or counts_on:
            marks.append(ListMark(match.span(), number))
    return marks


def without_marks(text: str, marks: list[ListMark]) -> str:
    """Give a text of the same length without its marks; one inside a line ends what stands before it."""
    for mark in marks:
        first, end = mark.span
        blank = " " * (end - first)
        if text[:first].strip():
            blank = ";" + blank[1:]
        text = text[:first] + blank + text[end:]
    return text


def _number(match: re.Match[str], lexicon: Lexicon) -> int | None:
    said = (match["step"] or match["number"]).lower()
    return int(said) if said.isdecimal() else lexicon.numbers.get(said)


def _is_date(text: str, match: re.Match[str], lexicon: Lexicon) -> bool:
    """Whether a name of a month stands behind a number: "2. March"."""
    if match["step"]:
        return False
    word = re.match(r"\w+", text[match.end() :])
    entries = lexicon.entries.get(word.group().lower(), ()) if word is not None else ()
    return any(entry.category == "month" for entry in entries)
