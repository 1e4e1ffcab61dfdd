"""The corpora of meanings and phrases, as rows for tests."""

from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Any

import yaml

from fuzzytime.language import Times
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
    found = []
    for name in MEANINGS:
        corpus = yaml.safe_load((FOLDER / f"{name}.yaml").read_text("utf-8"))
        for entry in corpus["rows"]:
            meaning = {key: value for key, value in entry.items() if key != "phrases"}
            found += [Row(str(phrase), instant(corpus["now"]), meaning) for phrase in entry["phrases"]]
    return found


def texts_without_time() -> list[str]:
    """Give the texts of the negative corpus."""
    return list(yaml.safe_load((FOLDER / "no_times.yaml").read_text("utf-8"))["texts"])


def instant(value: Any) -> datetime:
    """Give an instant that YAML read as a date, an instant or a text."""
    return datetime.fromisoformat(str(value))


def seconds(row: Row, value: Any) -> float:
    """Give an instant of a row in seconds from its now."""
    return seconds_between(row.now, instant(value))


def meant(row: Row, times: Times) -> list[str]:
    """Give what is wrong with the times found for a row: nothing, or one line a fault."""
    if not times.found:
        return ["no time was found"]
    first = times.found[0]
    requirement = first.requirement
    faults = []

    def compare(name: str, said: object, wanted: object) -> None:
        if said != wanted:
            faults.append(f"{name}: {said!r} instead of {wanted!r}")

    bounds = (requirement.earliest, requirement.latest)
    for key, value in row.meaning.items():
        match key:
            case "at":
                compare("at", bounds, (seconds(row, value),) * 2)
                compare("constraint", requirement.constraint.value, "at")
            case "before":
                compare("before", bounds, (None, seconds(row, value)))
                compare("constraint", requirement.constraint.value, "before")
            case "after":
                compare("after", bounds, (seconds(row, value), None))
                compare("constraint", requirement.constraint.value, "after")
            case "between":
                compare("between", bounds, tuple(seconds(row, end) for end in value))
                compare("constraint", requirement.constraint.value, "between")
            case "for":
                compare("for", first.duration, float(value))
            case "vague":
                compare("vague", (requirement.constraint.value, requirement.word), ("vague", value))
            case "word" | "preposition" | "number":
                compare(key, getattr(requirement, key), value)
            case "unit":
                compare("unit", requirement.unit, value)
            case "hedges":
                compare("hedges", requirement.fuzziness, tuple(value))
            case "duration":
                compare("duration", [g.duration for g in times.found if g.duration], [float(value)])
            case "every":
                compare("every", first.recurrence.interval if first.recurrence else 0, value)
            case "next":
                until = seconds(row, value[-1]) + (86400 if row.meaning.get("ends") else 0)
                said = first.recurrence.occurrences(until) if first.recurrence else ()
                compare("next", said, tuple(seconds(row, moment) for moment in value))
            case "ends":
                pass
            case _:
                faults.append(f"unknown key {key!r}")
    return faults
