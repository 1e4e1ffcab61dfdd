"""Tables of Markdown files that show what words mean, read again: so that each row is what the program does.

A table whose second heading is one of `SHOWN` is such a table. Its rows are said on Wednesday, 4 March 2026,
at nine in the morning. Lines of one text are parted by ``<br>``; ways to say the same, by `` · ``.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import datetime, timedelta
from functools import cache
from pathlib import Path

from fuzzytime.interpreter import Interpreter, Request, SpokenWish, plan
from fuzzytime.language import Instruction, Reading
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import format_duration, instant_after

NOW = datetime.fromisoformat("2026-03-04T09:00")
COMING = 3
"""So many occurrences of a repetition are shown."""

MOST = 6
"""So many entries of a plan."""

WAYS = " · "
LINES = "<br>"
NOTHING = "nothing"

_ROW = re.compile(r"^\| (?P<said>.+?) \| (?P<shown>.*?) \|$")


@dataclass(frozen=True)
class Row:
    """One row of a table: what is said, and what is shown beside it under which heading."""

    path: Path
    line: int
    heading: str
    said: str
    shown: str

    def __str__(self) -> str:
        return f"{self.path.name}:{self.line}: {self.said}"

    @property
    def written(self) -> str:
        """What the program makes of it today; ways to say the same that differ are all shown."""
        found = [SHOWN[self.heading](said.replace(LINES, "\n")) for said in self.said.split(WAYS)]
        return WAYS.join(dict.fromkeys(found))


def rows_of(path: Path) -> Iterator[Row]:
    """Give the rows of all tables of a file that show what words mean."""
    heading = ""
    for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
        row = _ROW.match(line)
        if row is None:
            # The line of dashes leaves the heading as it is.
            heading = heading if line.startswith("|") else ""
        elif row["shown"] in SHOWN:
            heading = row["shown"]
        elif heading:
            yield Row(path, number, heading, row["said"], row["shown"])


def with_meanings(path: Path) -> str:
    """Give a file with every row as the program reads it today."""
    lines = path.read_text("utf-8").split("\n")
    for row in rows_of(path):
        lines[row.line - 1] = f"| {row.said} | {row.written} |"
    return "\n".join(lines)


@cache
def _interpreter() -> Interpreter:
    return Interpreter.shipped()


def _read(text: str) -> Reading:
    return _interpreter().language.read(text, now=NOW)


def _times(text: str) -> str:
    return _joined(_read(text).instructions) or NOTHING


def _operations(text: str) -> str:
    """Give what is to be done, each with its times."""
    found = []
    for instruction in _read(text).instructions:
        operation, times = instruction.operation, _joined((instruction,))
        if operation is not None:
            told = "told: " if operation.stated else "not: " if operation.negated else ""
            found.append(f"{told}{operation.name}" + (f" ({times})" if times else ""))
    return "; ".join(found) or NOTHING


def _remarks(text: str) -> str:
    return "; ".join(remark.message for remark in _read(text).remarks).replace("|", r"\|") or NOTHING


def _planned(text: str) -> str:
    """Give when each thing starts."""
    lines = enumerate(text.split("\n"), 1)
    wishes = tuple(SpokenWish(text=line, given=NOW, line=number) for number, line in lines)
    made = plan(Request(now=NOW, wishes=wishes), _interpreter())
    placed = zip(made.schedule.skills, made.schedule.rejected, strict=True)
    starts = sorted(
        (skill.start, place, skill.name) for place, (skill, none) in enumerate(placed) if not none
    )
    told = [f"{_instant(start)} {name}" for start, _, name in starts[:MOST]]
    return ", ".join((*told, "…") if len(starts) > MOST else told) or NOTHING


SHOWN: dict[str, Callable[[str], str]] = {
    "it means": _times,
    "to do": _operations,
    "the plan": _planned,
    "the answer": _remarks,
}
"""What a column shows, by its heading."""


def _joined(instructions: tuple[Instruction, ...]) -> str:
    words = ""
    for instruction in instructions:
        for requirement in instruction.requirements:
            between = "" if not words else " or " if requirement.alternative else ", "
            words += between + _meaning(requirement, instruction.duration)
    return words


def _meaning(requirement: TimeRequirement, duration: float | None) -> str:
    if requirement.recurrence is not None:
        coming = requirement.recurrence.coming(COMING + 1)
        ends = ", …" if len(coming) > COMING else ""
        return ", ".join(_stretch(*ends_of) for ends_of in coming[:COMING]) + ends
    first, last = requirement.earliest, requirement.latest
    if requirement.anchor is not None or requirement.condition is not None:
        return requirement.text
    if requirement.constraint is Constraint.FOR:
        return requirement.text if duration is None else f"for {format_duration(duration)}"
    if first is None and last is None:
        return f"{requirement.constraint}: {requirement.word}"
    if first is None:
        return f"before {_instant(last)}"
    return f"after {_instant(first)}" if last is None else _stretch(first, last)


def _stretch(first: float, last: float) -> str:
    start, end = instant_after(NOW, first), instant_after(NOW, last)
    if start == end:
        return _instant(first)
    whole = start.hour == end.hour == start.minute == end.minute == 0
    if whole:
        last_day = end - timedelta(days=1)
        return _day(start) + ("" if last_day == start else f" to {_day(last_day)}")
    if end == start.replace(hour=0, minute=0) + timedelta(days=1):
        return f"{_instant(first)} to 24:00"
    return f"{_instant(first)} to " + (f"{end:%H:%M}" if end.date() == start.date() else _instant(last))


def _instant(seconds: float | None) -> str:
    assert seconds is not None
    instant = instant_after(NOW, seconds)
    clock = f"{instant:%H:%M:%S}".removesuffix(":00")
    return clock if instant.date() == NOW.date() else f"{_day(instant)} {clock}"


def _day(instant: datetime) -> str:
    year = f" {instant.year}" if instant.year != NOW.year else ""
    return f"{instant:%a} {instant.day} {instant:%b}{year}"
