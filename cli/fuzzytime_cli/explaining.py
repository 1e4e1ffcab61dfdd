"""An instruction explained: tree, requirement, rows and rules, ψ, and why it is planned when it is."""

import math
import textwrap
from collections.abc import Iterable
from itertools import groupby

import numpy as np

from fuzzytime.context import symbol
from fuzzytime.interpreter import Interpreted, Plan
from fuzzytime.language import Reading, Token
from fuzzytime.requirement import Reference, TimeRequirement
from fuzzytime.rulebook import Resolution, Share, Trace
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime.times import format_duration
from fuzzytime_cli.drawing.chart import Chart, Curve, Mark, Panel, satisfaction_panel, window_of
from fuzzytime_cli.drawing.terminal import chart_lines
from fuzzytime_cli.formats.clock import Clock
from fuzzytime_cli.formats.reasons import why_sentences
from fuzzytime_cli.render import fitted, plain, width_of

INDENT = "  "


def tree_lines(reading: Reading) -> list[str]:
    """Give the dependency tree, a word a line, each under its head, with tag and the paper's relation."""
    children: dict[int, list[int]] = {}
    roots = []
    for position, token in enumerate(reading.tokens):
        if token.head == position:
            roots.append(position)
        else:
            children.setdefault(token.head, []).append(position)
    lines: list[str] = []
    for root in roots:
        _branch(reading.tokens, children, root, "", "", lines)
    return lines


def _branch(
    tokens: tuple[Token, ...],
    children: dict[int, list[int]],
    position: int,
    before: str,
    below: str,
    lines: list[str],
) -> None:
    """Draw a word and what hangs on it; depth is bounded by the length of an instruction."""
    stack = [(position, before, below)]
    while stack:
        here, head, tail = stack.pop()
        token = tokens[here]
        label = f"{head}{plain(token.text)}"
        lines.append(f"{label}{' ' * max(1, 34 - width_of(label))}{token.tag:<6} {token.relation}")
        inner = children.get(here, [])
        for index in reversed(range(len(inner))):
            last = index == len(inner) - 1
            stack.append((inner[index], tail + ("└─ " if last else "├─ "), tail + ("   " if last else "│  ")))


def strict_line(reading: Reading) -> str:
    """Give the paper's own reading in one line: verb ← oblique temporal modifier ← what hangs on it.

    For example: place ← minutes (oblique temporal) ← four (number), about (hedge), in (preposition).
    """
    strict, tokens = reading.strict, reading.tokens
    if strict.verb is None or strict.modifier is None:
        return "the paper's strict reading finds no oblique temporal modifier of the root verb"
    parts = [
        f"{plain(tokens[position].text.lower())} ({name})"
        for position, name in (
            (strict.number, "number"),
            (strict.fuzziness, "hedge"),
            (strict.preposition, "preposition"),
        )
        if position is not None
    ]
    verb, modifier = (plain(tokens[p].text.lower()) for p in (strict.verb, strict.modifier))
    return f"{verb} ← {modifier} (oblique temporal)" + (f" ← {', '.join(parts)}" if parts else "")


def requirement_lines(requirement: TimeRequirement, clock: Clock) -> list[str]:
    """Give one time requirement: its words and what they mean."""
    facts = [f"{requirement.constraint.value}", f"about the {requirement.reference.value}"]
    if requirement.reference.value == "throughout":
        facts[1] = "throughout the execution"
    for name, value in (
        ("preposition", requirement.preposition),
        ("word", requirement.word),
        ("hedge", " ".join(requirement.fuzziness)),
        ("number", f"{requirement.number:g}" if requirement.number is not None else None),
        ("unit", requirement.unit.value if requirement.unit is not None else None),
    ):
        if value:
            facts.append(f"{name} {plain(value)}")
    if requirement.t_spec is not None:
        facts.append(f"t_spec {format_duration(requirement.t_spec)} ({clock.of(requirement.t_spec)})")
    elif requirement.earliest is not None or requirement.latest is not None:
        ends = [
            clock.of(end) if end is not None else "…" for end in (requirement.earliest, requirement.latest)
        ]
        facts.append(f"from {ends[0]} to {ends[1]}")
    if requirement.condition is not None:
        facts.append(f"condition {plain(requirement.condition.text)!r}")
    return [f"{plain(requirement.text)!r}: {', '.join(facts)}"]


def resolution_lines(resolution: Resolution) -> list[str]:
    """Give the rows and rules behind one ψ, with degrees and readings."""
    lines = []
    for share in resolution.shares:
        lines += _share_lines(share)
    for hedge in resolution.hedges:
        lines.append(f"hedge {plain(hedge.name)} × {hedge.factor:g}  {plain(hedge.source)}")
    numbers = ", ".join(
        f"{plain(name)} = {_quantity(value)}" for name, value in resolution.parameters.items()
    )
    of = "" if resolution.reference is Reference.START else f" of the {resolution.reference.value}"
    lines.append(f"model {plain(resolution.model)}{of}" + (f" with {numbers}" if numbers else ""))
    if resolution.reason:
        lines.append(f"no start satisfies: {plain(resolution.reason)}")
    lines += [f"note: {plain(note)}" for note in resolution.notes]
    return lines


def _quantity(value: float) -> str:
    return format_duration(value) if np.isfinite(value) else "open"


def _share_lines(share: Share) -> list[str]:
    factors = ", ".join(f"{name} × {factor:.2f}" for name, factor in share.scale.items())
    line = f"{plain(share.name):<24} {plain(share.source):<28} {factors or f'share {share.share:.2f}'}"
    if share.degree.low != 1 or share.degree.high != 1:
        line += f"  holds {_between(share.degree.low, share.degree.high)}"
    lines = [line]
    for atom in share.atoms:
        reading = (
            "no reading"
            if atom.reading is None
            else f"reading {atom.reading:g} {plain(atom.unit or '')}".rstrip()
        )
        lines.append(f"{INDENT}{plain(atom.text)}: {_between(atom.degree.low, atom.degree.high)} ({reading})")
    return lines


def _between(low: float, high: float) -> str:
    return f"{low:.2f}" if abs(high - low) < 0.005 else f"between {low:.2f} and {high:.2f}"


def chart_of(interpreted: Interpreted, plan: Plan, position: int | None = None) -> Chart:
    """Draw what there is: readings, forecast and μ of a condition, then ψ with the planned start."""
    function: SatisfactionFunction = interpreted.skill.satisfaction
    start, end = window_of(function)
    panels: list[Panel] = []
    for resolution in interpreted.resolutions:
        if resolution.trace is not None:
            trace = resolution.trace
            shown = trace.times[trace.satisfaction > 0] if (trace.satisfaction > 0).any() else trace.times
            firsts = [signal.reading_times[0] for signal in trace.signals if signal.reading_times.size]
            start = min([start, *map(float, firsts)])
            end = (
                max(end, float(shown[-1]) * 1.05)
                if (trace.satisfaction > 0).any()
                else min(float(trace.times[-1]), 3600)
            )
            panels += _trace_panels(trace, start, end)
    panels.append(satisfaction_panel(function, start, end, "ψ: satisfaction with a start at that time"))
    marks: tuple[Mark, ...] = (Mark(0.0, "now"),) if start < 0 else ()
    if position is not None and not plan.schedule.rejected[position]:
        when = plan.schedule.start_times[position]
        planned = f"planned, satisfaction {plan.schedule.satisfactions[position]:.2f}"
        marks = (*marks, Mark(when, planned))
        end = max(end, when * 1.05)
    return Chart(tuple(panels), start, end, plan.request.now, marks)


def _trace_panels(trace: Trace, start: float, end: float) -> list[Panel]:
    panels = []
    for signal in trace.signals:
        readings = Curve("readings", signal.reading_times, signal.reading_values, dots=True)
        forecast = Curve(
            "forecast",
            signal.forecast_times,
            signal.forecast_median,
            band=(signal.forecast_low, signal.forecast_high),
        )
        inside = (signal.forecast_times >= start) & (signal.forecast_times <= end)
        seen = np.concatenate([signal.reading_values, signal.forecast_median[inside]])
        seen = seen[np.isfinite(seen)]
        low, high = (float(seen.min()), float(seen.max())) if seen.size else (0.0, 1.0)
        margin = 0.05 * (high - low) or 1.0
        unit = f" in {symbol(signal.unit)}" if signal.unit else ""
        title = f"{signal.name}{unit}" + (f": {signal.outlook}" if signal.outlook else "")
        panels.append(Panel(title, (readings, forecast), *_rounded(low - margin, high + margin)))
    if trace.atoms:
        curves = tuple(Curve(text, trace.times, values) for text, values in trace.atoms)
        panels.append(Panel("μ: " + ", ".join(text for text, _ in trace.atoms), curves))
    return panels


def _rounded(low: float, high: float) -> tuple[float, float]:
    """Give limits of an axis with as few digits as tell them apart."""
    unit = 10.0 ** math.floor(math.log10(high - low) - 1)
    return math.floor(low / unit) * unit, math.ceil(high / unit) * unit


def explanation_lines(plan: Plan, position: int, width: int, *, unicode: bool = True) -> list[str]:
    """Explain one skill of a plan, from its words to its start."""
    interpreted = plan.skills[position]
    given = interpreted.wish.given
    clock = Clock(given, with_seconds=bool(given.second))
    lines = [f"{interpreted.identifier}: {plain(getattr(interpreted.wish, 'text', interpreted.skill.name))}"]
    reading = interpreted.reading
    if reading is not None:
        lines += _section("tree", tree_lines(reading))
        lines += _section("the paper's reading", [strict_line(reading)])
    asked = [
        line for requirement in interpreted.requirements for line in requirement_lines(requirement, clock)
    ]
    lines += _section("left", left_lines(reading) if reading is not None else [])
    behind = [line for part in interpreted.resolutions for line in resolution_lines(part)]
    inner = width - len(INDENT)
    asked = asked or ["no words about time: any time from now on satisfies"]
    lines += _section("time", _wrapped(asked, inner))
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


def reading_lines(reading: Reading, width: int) -> list[str]:
    """Explain a text that gives no skill: its tree, what was found, and what was left."""
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
        *_section("tree", tree_lines(reading)),
        *_section("the paper's reading", [strict_line(reading)]),
        *_section("time", _wrapped(found or ["no words about time"], width - len(INDENT))),
        *_section("left", left_lines(reading)),
    ]


def rules_lines(plan: Plan, width: int, *, unicode: bool = True) -> list[str]:
    """Give rows, rules and ψ of the skills of a plan; of a repetition those of its first occurrence."""
    lines = []
    clock = Clock(plan.request.now, with_seconds=bool(plan.request.now.second))
    for _, occurrences in groupby(plan.skills, lambda interpreted: interpreted.instruction):
        first, *others = occurrences
        for requirement, resolution in zip(first.requirements, first.resolutions, strict=False):
            lines += _wrapped(requirement_lines(requirement, clock), width)
            lines += [INDENT + line for line in _wrapped(resolution_lines(resolution), width - len(INDENT))]
        lines += chart_lines(chart_of(first, plan), width, unicode=unicode)
        lines += [f"and {len(others)} more occurrences like it"] * bool(others)
    return lines


def left_lines(reading: Reading) -> list[str]:
    """Give the words that were not understood, or decided by policy, with marks under them."""
    lines = []
    for remark in reading.remarks:
        start, end = remark.span
        before, words = plain(reading.text[:start]), plain(reading.text[start:end])
        lines += [
            f"{before}{words}{plain(reading.text[end:])}",
            f"{fitted('', width_of(before))}{'^' * max(1, width_of(words))} {plain(remark.message)}",
        ]
    return lines
