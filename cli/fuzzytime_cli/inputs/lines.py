"""Instructions a line, with headings, ``#`` comments and the boxes of lists of things to do."""

import re
from datetime import datetime

from fuzzytime.errors import DocumentError, Mistake
from fuzzytime.interpreter import SpokenWish
from fuzzytime_cli.bounds import MAX_INSTRUCTIONS
from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.inputs.source import Source

COMMAND = re.compile(r":[a-z][a-z-]*(?=\s|$)")
"""What begins a line for the conversation: ``:rate 1 4``."""


REMARK = re.compile(r"\s#\s.*")
"""A comment behind an instruction; "#12" is no comment."""

STAMP = re.compile(
    r"^(?:\[[\d/.-]{6,10},?\s+\d{1,2}[:.]\d\d(?:[:.]\d\d)?(?:\s?[AaPp][Mm])?\]"
    r"|[\d/.]{6,10},?\s+\d{1,2}[:.]\d\d(?:\s?[AaPp][Mm])?\s+-)\s+(?=[^\W\d][^:]{,30}:\s)"
)
"""When a message was sent, in front of who wrote it: "[07/03/2026, 08:41] Kate: keys at 10"."""

HEADING = re.compile(r"(?P<marks>#{1,6})\s+[*_]*(?P<named>[^\W_].*?)[\s:#*_]*")
"""A heading of Markdown; with one mark it may be a comment."""

DATE = re.compile(r"\d{1,2}(?:st|nd|rd|th)?|the|of")
"""What stands beside a month in a date."""

MARKDOWN = (".md", ".markdown")

BOX = re.compile(
    r"""
      (?: [-*+•]\s+ )? (?: \[ (?P<tick>[ xX/>-]?) \] | (?P<sign>[☐☑☒✓✔✗✘]) ) \s+
    | (?: [-*+•]\s+ )? (?P<done> (?: DONE | CANCELL?ED )\b :? | x (?= \s+ \d{4}-\d\d-\d\d \s) ) \s+
    | (?: [‣◦▪] \s* | •(?=\S) )
    """,
    re.VERBOSE,
)
"""What an item of a list of things to do begins with; it is done, or dropped, unless the box is empty.

``done`` are the marks of lists in plain text (Org, todo.txt).
"""

OPEN = frozenset({None, "", " ", "/", "☐"})
"""The boxes of what is to be done; "/" is begun."""

STRUCK = re.compile(r"(?:[-*+•]\s+)?(?:\[ ?\]\s+)?~~(?=\S)[^~]+~~[.\s]*")
"""A line of which all is struck out."""

DIVIDER = re.compile(r"(?:[-*_=]\s*){3,}|```.*|<!--.*-->")
"""A line that only divides others, or is a comment of Markdown."""

FIELD = re.compile(r"[\w-]+:(?:\s.*)?|\s*-\s.*|\s+\S.*")
"""A line of what stands in front of a page of Markdown, between two dividers: "title: Saturday"."""

CELLS = re.compile(r"\s*\|\s*|\s*\t\s*")
"""What stands between the cells of a row of a table."""

RULE = re.compile(r"[|\s]*:?-{2,}[-:|\s]*\|[-:|\s]*")
"""The row of a table below its heads."""

NUMBER = re.compile(r"\d[\d.:\s–-]*[^\W\d]{,2}(?:\s?[–—-]\s?\d[\d.:]*[^\W\d]{,2})?")
"""A cell that is an hour: "9.15 - 10", "8pm", "8am – 6pm"."""

_TIME = r"\d{1,2}(?:[:.]\d\d)?(?:\s?[ap]\.?m\.?)?"
HOUR = re.compile(rf"(?=.*(?:[:.]\d|m)){_TIME}(?P<until>\s?[–—-]\s?{_TIME})?", re.IGNORECASE)
"""A line that is an hour, or from when to when, and nothing else: what is then stands below it."""

BULLET = re.compile(r"[-*+•]\s+")
"""What a line of a list may begin with."""


def said_in(line: str, *, marked: bool = False) -> str:
    """Give what a line asks for, without its box: nothing where it is a comment, or ticked off.

    >>> said_in("# for tonight"), said_in("- [x] feed the cat"), said_in("- [ ] water the plants")
    ('', '', 'water the plants')
    >>> said_in("## Saturday"), said_in("# Sat 7 March")
    ('Saturday:', 'Sat 7 March:')
    >>> said_in("[07/03/2026, 08:41] Kate: keys at 10")
    'Kate: keys at 10'
    """
    words = STAMP.sub("", line.strip())
    if DIVIDER.fullmatch(words) or STRUCK.fullmatch(words):
        return ""
    heading = HEADING.fullmatch(words)
    if heading is not None and (marked or len(heading["marks"]) > 1 or _is_date(heading["named"])):
        return f"{heading['named']}:"
    box = BOX.match(words)
    if words.startswith("#") or (box is not None and not {box["tick"], box["sign"], box["done"]} <= OPEN):
        return ""
    return words if box is None else words[box.end() :]


def _front(lines: list[str]) -> int:
    """Give how many lines at the beginning are about a page of Markdown, and none of it.

    >>> _front(["---", "title: Saturday", "---", "feed the cat"]), _front(["---", "feed the cat", "---"])
    (3, 0)
    """
    marks = [place for place, line in enumerate(lines) if line.strip() == "---"]
    if len(marks) == 1 or marks[:1] != [0]:
        return 0
    end = marks[1]
    return end + 1 if all(FIELD.fullmatch(line) for line in lines[1:end]) else 0


def _is_date(words: str) -> bool:
    """Whether words name a weekday, its date perhaps, and nothing else."""
    from fuzzytime.language import shipped_lexicon

    lexicon = shipped_lexicon()
    first, *others = words.lower().replace(",", " ").split()
    dated = all(lexicon.means(word, "month") or DATE.fullmatch(word) for word in others)
    return lexicon.means(first, "weekday") and dated


def without_cells(line: str) -> str:
    """Give a row of a table as a line: what is done and when; where and by whom in brackets.

    Cells of which none is only a number are entries of a line.

    >>> without_cells("| 9.45 | Line check, 20 min | Ash |")
    '9.45 Line check, 20 min (Ash)'
    >>> without_cells("10am vet | 12 lunch")
    '10am vet | 12 lunch'
    """
    cells = [cell for cell in CELLS.split(line.strip()) if cell]
    numbers = [NUMBER.fullmatch(cell) is not None for cell in cells]
    if not any(numbers) and not line.lstrip().startswith("|"):
        return line
    first = max(1, numbers.index(False) if False in numbers else 0) + 1
    return " ".join((*cells[:first], *(f"({cell})" for cell in cells[first:])))


def is_ticked_off(line: str) -> bool:
    """Whether a line is of a list of things to do, and what it names is done.

    >>> is_ticked_off("- [x] feed the cat"), is_ticked_off("- [ ] feed the cat")
    (True, False)
    >>> is_ticked_off("DONE feed the cat"), is_ticked_off("- ~~feed the cat~~")
    (True, True)
    """
    words = line.strip()
    return (BOX.match(words) or STRUCK.fullmatch(words)) is not None and not said_in(line)


def _is_then(words: str, hour: re.Match[str]) -> bool:
    """Whether a line is what is at the hour above it; marked lines in a stretch may all be."""
    listed = hour["until"] is not None and BULLET.match(words) is not None
    return not (words[0].isdigit() or words.endswith(":") or listed)


def wishes_of(source: Source, now: datetime) -> tuple[SpokenWish, ...]:
    """Give the instructions of a text, with their lines.

    Raises
    ------
    NoInputError
        If there are only comments.
    DocumentError
        If there are more than `MAX_INSTRUCTIONS`, or a line is a command of the conversation.
    """
    wishes: list[SpokenWish] = []
    mistakes: list[Mistake] = []
    hour: re.Match[str] | None = None
    lines = source.text.split("\n")
    front = _front(lines)
    lines[:front] = [""] * front
    marked = source.name.endswith(MARKDOWN) or any(line.startswith("## ") for line in lines)
    for number, (line, below) in enumerate(zip(lines, [*lines[1:], ""], strict=True), 1):
        words = said_in(without_cells(REMARK.sub("", line)), marked=marked)
        if not words or RULE.fullmatch(line) or ("|" in line and RULE.fullmatch(below)):
            continue
        if hour is not None and _is_then(words, hour):
            # "4.30 pm", and below it "Portraits"
            words = f"{hour[0]} {BULLET.sub('', words, count=1)}"
            wishes.pop()
        hour = HOUR.fullmatch(words)
        if len(wishes) == MAX_INSTRUCTIONS:
            rule = (
                f"a plan must hold at most {MAX_INSTRUCTIONS:,} instructions (for several files, see: batch)"
            )
            raise DocumentError((Mistake(source.name, number, 1, "", rule, line),))
        command = COMMAND.match(words)
        if command is not None:
            rule = f"{command.group()!r} is a command of the conversation (see: fuzzytime repl)"
            mistakes.append(Mistake(source.name, number, line.index(":") + 1, "", rule, line))
        wishes.append(SpokenWish(text=words, given=now, line=number))
    if mistakes:
        raise DocumentError(tuple(mistakes))
    if not wishes:
        raise NoInputError(
            f"{source.name}: the input must hold at least one instruction, and all are comments or ticked off"
        )
    return tuple(wishes)
