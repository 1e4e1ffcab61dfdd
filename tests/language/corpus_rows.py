"""The corpora of meanings and phrases, as rows for tests."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from fuzzytime.language import Times
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.patterns import Action, Pattern
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.requirement import Constraint
from fuzzytime.times import seconds_between

FOLDER = Path(__file__).parent / "corpus"
MEANINGS = ("durations", "clocks", "days", "repetitions")


@dataclass(frozen=True)
class Row:
    """A phrase, when it is said, and what it means."""

    phrase: str
    now: datetime
    meaning: dict[str, Any] = field(compare=False)

    def __str__(self) -> str:
        return self.phrase


def rows() -> list[Row]:
    """Give every phrase of every corpus."""
    return [row for name in MEANINGS for row in rows_in(FOLDER / f"{name}.yaml")]


def rows_in(path: Path) -> list[Row]:
    """Give every phrase of one corpus."""
    found = []
    corpus = _read(path)
    for entry in corpus["rows"]:
        meaning = {key: value for key, value in entry.items() if key != "phrases"}
        found += [Row(str(phrase), instant(corpus["now"]), meaning) for phrase in entry["phrases"]]
    return found


def idle_rules(grammar: Grammar, lexicon: Lexicon, texts: Iterable[str]) -> list[str]:
    """Give the rules of a grammar that make no piece of any text."""
    made: Counter[str] = Counter()

    def counting(pattern: Pattern) -> Action:
        def action(*values: object) -> object:
            found = pattern.action(*values)
            made[pattern.name] += found is not None
            return found

        return action

    counted = Grammar()
    for pattern in grammar.patterns:
        counted.add(pattern._replace(action=counting(pattern)))
    idle = {pattern.name for pattern in grammar.patterns}
    for text in texts:
        Scanned.of(text, counted, lexicon)
        idle.difference_update(name for name, count in made.items() if count)
        if not idle:
            break
    return sorted(idle)


@cache
def sentences() -> list[dict[str, Any]]:
    """Give the corpus of sentences: texts, and the instructions that they give.

    Each has ``do``, the operation in words; ``times`` with their words, constraint, and any of the seconds of
    their t_spec, their reference and what they count from; ``next`` or ``first``, when occurrences begin.
    """
    files = sorted((FOLDER / "sentences").glob("*.yaml"))
    return [row for file in files for row in _read(file)]


def texts_without_time() -> list[str]:
    """Give the texts of the negative corpus."""
    return list(_read(FOLDER / "no_times.yaml")["texts"])


def _read(path: Path) -> Any:  # noqa: ANN401 - as YAML has it
    """Read YAML, by the reader in C: that in Python takes seconds."""
    return yaml.load(path.read_text("utf-8"), yaml.CSafeLoader)


def instant(value: object) -> datetime:
    """Give an instant that YAML read as a date, an instant or a text."""
    return datetime.fromisoformat(str(value))


def seconds(row: Row, value: object) -> float:
    """Give an instant of a row in seconds from its now."""
    return seconds_between(row.now, instant(value))


def meant(row: Row, times: Times) -> list[str]:
    """Give what is wrong with the times found for a row: nothing, or one line a fault."""
    if not times.found:
        return ["no time was found"]
    pairs = ((key, _said(key, row, times), _wanted(key, value, row)) for key, value in row.meaning.items())
    return [f"{key}: {said!r} instead of {wanted!r}" for key, said, wanted in pairs if said != wanted]


def _wanted(key: str, value: Any, row: Row) -> object:  # noqa: ANN401 - as YAML has it
    """Give what a row says, in the terms of a requirement."""
    match key:
        case "at":
            return "at", seconds(row, value), seconds(row, value)
        case "before":
            return "before", None, seconds(row, value)
        case "after":
            return "after", seconds(row, value), None
        case "between":
            return ("between", *(seconds(row, end) for end in value))
        case "hedges":
            return tuple(value)
        case "next":
            return tuple(seconds(row, moment) for moment in value)
        case _:
            return value


def _said(key: str, row: Row, times: Times) -> object:
    """Give the same of the time that was found."""
    first = times.found[0]
    requirement = first.requirement
    match key:
        case "at" | "before" | "after" | "between":
            return requirement.constraint.value, requirement.earliest, requirement.latest
        case "for":
            return first.duration
        case "duration":
            return next((found.duration for found in times.found if found.duration is not None), None)
        case "vague":
            return requirement.word if requirement.constraint is Constraint.VAGUE else None
        case "hedges":
            return requirement.fuzziness
        case "every":
            return first.recurrence.interval if first.recurrence is not None else 0
        case "next":
            last = seconds(row, row.meaning["next"][-1]) + (86400 if row.meaning.get("ends") else 0)
            return first.recurrence.occurrences(last) if first.recurrence is not None else ()
        case "ends":
            return True
        case _:
            return getattr(requirement, key)
