"""A skill of a plan explained, from its words to its start; a text that gives none; words about time."""

import textwrap
from collections.abc import Iterable
from itertools import groupby

from fuzzytime.interpreter import Interpreted, Plan
from fuzzytime.language import Reading
from fuzzytime.times import format_duration
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.drawing.terminal import chart_lines
from fuzzytime_cli.explaining.charts import chart_of
from fuzzytime_cli.explaining.origins import resolution_lines
from fuzzytime_cli.explaining.words import doubt_lines, requirement_lines, strict_line, tree_lines
from fuzzytime_cli.formats.reasons import why_sentences
from fuzzytime_cli.render import plain, width_of

INDENT = "  "
UNTIMED = "no words about time: any time from now on satisfies"


def explanation_lines(
    plan: Plan, position: int, width: int, *, unicode: bool, text_shown: bool = False
) -> list[str]:
    """Explain one skill of a plan, from its words to its start.

    Where ``text_shown``, what holds for the whole text was told with another of its skills.
    """
    interpreted = plan.everything[position]
    given = interpreted.wish.given
    clock = Clock(given, with_seconds=bool(given.second))
    inner = width - len(INDENT)
    named = interpreted.skill.name if text_shown else interpreted.words or interpreted.skill.name
    lines = _wrapped([f"{interpreted.identifier}: {plain(named)}"], width)
    reading = None if text_shown else interpreted.reading
    if reading is not None:
        lines += _section("tree", tree_lines(reading, inner))
        lines += _section("words that say when", _wrapped([strict_line(reading)], inner))
    asked = [
        line for requirement in interpreted.requirements for line in requirement_lines(requirement, clock)
    ]
    behind = [line for part in interpreted.resolutions for line in resolution_lines(part)]
    asked = asked or [UNTIMED]
    lines += _section("time", _wrapped(asked, inner))
    lines += _section("in doubt", doubt_lines(reading) if reading is not None else [])
    lines += _section("rows and rules", _wrapped(behind, inner))
    lines += _section("duration", _wrapped([_duration_line(interpreted)], inner))
    chart = chart_of(interpreted, plan, position)
    lines += _section("satisfaction", chart_lines(chart, inner, unicode=unicode))
    lines += _section("why then", _wrapped(why_sentences(plan, position), inner))
    return lines


def _duration_line(interpreted: Interpreted) -> str:
    duration = interpreted.duration
    busy, done = format_duration(duration.hands_on), format_duration(duration.elapsed)
    until = "" if duration.elapsed == duration.hands_on else f", done after {done}"
    origin = f"assumed, {plain(duration.source)}" if duration.assumed else plain(duration.source)
    return f"busy {busy}{until} ({origin})"


def reading_lines(reading: Reading, width: int) -> list[str]:
    """Explain a text that gives no skill: its tree, what was found, and what is in doubt."""
    inner = width - len(INDENT)
    clock = Clock(reading.now, with_seconds=False) if reading.now is not None else None
    found = [
        line
        for instruction in reading.instructions
        for requirement in instruction.requirements
        for line in (
            requirement_lines(requirement, clock) if clock is not None else [plain(requirement.text)]
        )
    ]
    return [
        *_section("tree", tree_lines(reading, inner)),
        *_section("words that say when", _wrapped([strict_line(reading)], inner)),
        *_section("time", _wrapped(found or ["no words about time"], inner)),
        *_section("in doubt", doubt_lines(reading)),
    ]


def rules_lines(plan: Plan, width: int, *, unicode: bool) -> list[str]:
    """Give rows, rules and ψ of the skills of a plan; of a repetition those of its first occurrence."""
    lines = []
    clock = Clock(plan.request.now, with_seconds=bool(plan.request.now.second))
    for _, occurrences in groupby(plan.everything, lambda interpreted: interpreted.instruction):
        first, *others = occurrences
        if not first.requirements:
            lines.append(UNTIMED)
            continue
        for requirement, resolution in zip(first.requirements, first.resolutions, strict=False):
            lines += _wrapped(requirement_lines(requirement, clock), width)
            lines += [INDENT + line for line in _wrapped(resolution_lines(resolution), width - len(INDENT))]
        lines += chart_lines(chart_of(first, plan), width, unicode=unicode)
        lines += [f"and {len(others)} more occurrences like it"] * bool(others)
    return lines


def _wrapped(lines: Iterable[str], width: int) -> list[str]:
    """Break lines that are too long between words; what follows is indented."""
    return [
        part
        for line in lines
        for part in (
            [line]
            if width_of(line) <= width
            else textwrap.wrap(line, max(width, 20), subsequent_indent=2 * INDENT)
        )
    ]


def _section(title: str, lines: list[str]) -> list[str]:
    return ["", title, *(INDENT + line for line in lines)] if lines else []
