"""What a plan takes for granted, in lines below it: notes, and durations that nobody said."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import groupby

from rich.text import Text

from fuzzytime.interpreter import Plan, Problem, ProblemKind
from fuzzytime.language import HALF_OF_DAY_ADVICE
from fuzzytime.times import format_duration
from fuzzytime_cli.render import plain

MOST_NOTES = 12
"""Notes that are told at most."""

MOST_TOGETHER = 8
"""Of notes that end in the same advice, so many are told."""

MOST_LENGTHS = 12
"""Durations that are told one by one at most."""

TWO = 2
"""Names that are joined by "and"."""

MOST_ROWS = 40
"""Rows of skills whose durations are told at most."""


def note_lines(plan: Plan, labels: Sequence[str], among: Collection[int] | None = None) -> Iterator[Text]:
    """Give the notes, and the durations that are assumed, of all skills or ``among`` some.

    ``labels`` name the skills, by position.
    """
    notes = _together([problem for problem in plan.problems if problem.kind is ProblemKind.NOTE])
    shown = notes if len(notes) <= MOST_NOTES + 1 else notes[:MOST_NOTES]
    for note in shown:
        yield Text(f"note: {note}", style="dim")
    if len(shown) < len(notes):
        yield Text(f"and {len(notes) - len(shown)} more notes: --format json has all", style="dim")
    assumed = [
        (position, format_duration(interpreted.skill.duration or interpreted.skill.time_until_done))
        for position, interpreted in enumerate(plan.skills)
        if interpreted.duration.assumed
        and interpreted.skill.until is None
        and (among is None or position in among)
    ]
    if assumed:
        turns = {position: one.wish.identifier for position, one in enumerate(plan.skills) if one.repeats}
        yield Text("durations assumed: " + ", ".join(_lengths(assumed, labels, turns)), style="dim")


def _together(notes: Sequence[Problem]) -> list[str]:
    """Give the sentences of notes; those that end in the same advice ("…: say am or pm") are one, and last.

    Others begin with the skill, or the line, that they are about; what is said of several is said once.
    """
    found: dict[tuple[str, str], dict[str, None]] = {}
    for problem in sorted(notes, key=lambda one: one.message.endswith(HALF_OF_DAY_ADVICE)):
        head, colon, advice = plain(problem.message).rpartition(": ")
        many = problem.message.endswith(HALF_OF_DAY_ADVICE)
        place = "" if problem.line is None or many else f"line {problem.line}"
        kind = (plain(problem.identifier) or place, f"{colon}{advice}")
        found.setdefault(kind, {})[head] = None
    sentences: dict[str, list[str]] = {}
    for (about, advice), heads in found.items():
        named = list(heads)
        more = f"; and {len(named) - MOST_TOGETHER} more" if len(named) > MOST_TOGETHER + 1 else ""
        told = "; ".join(named[:MOST_TOGETHER] if more else named)
        sentences.setdefault(f"{told}{more}{advice}", []).append(about)
    return [": ".join(filter(None, (_joined(about), told))) for told, about in sentences.items()]


def _joined(names: Sequence[str]) -> str:
    """Join the names of skills in a row: "s1 to s9"."""
    return f"{names[0]} to {names[-1]}" if len(names) > TWO else " and ".join(names)


def _lengths(
    assumed: Sequence[tuple[int, str]], labels: Sequence[str], turns: Mapping[int, str]
) -> Iterator[str]:
    """Tell how long skills take: each, or of several in a row that take the same: "s1 to s9 2 min".

    Those are the ``turns`` of a repetition, by position, or whatever stands in a row where there are many.
    """

    def row(entry: tuple[int, tuple[int, str]]) -> tuple[int | str, str]:
        index, (position, length) = entry
        return (position - index if len(assumed) > MOST_LENGTHS else turns.get(position, position)), length

    rows = [(length, list(entries)) for (_, length), entries in groupby(enumerate(assumed), key=row)]
    left = sum(len(entries) for _, entries in rows[MOST_ROWS:])
    for length, entries in rows[:MOST_ROWS]:
        names = [labels[position] for _, (position, _) in entries]
        yield f"{_joined(names)} {length}"
    if left:
        yield f"and {left} more: --format json has all"
