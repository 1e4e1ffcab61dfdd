"""A calibration as a rule file: YAML that ``rules check`` accepts and ``plan --rules`` uses."""

import json
from collections.abc import Mapping, Sequence
from decimal import Decimal

from fuzzytime.study.analysis.fitting import Fit
from fuzzytime.study.calibration.calibrate import Calibration
from fuzzytime.study.wording import between, probability
from fuzzytime.times import DAY, MINUTE

CONSTRAINTS = {"in": "at", "before": "before", "after": "after"}
"""What a preposition's model can express, where rule tables must know."""

ACTORS = ("robot", "person")
"""Groups that rule tables have a factor for."""


def rule_table(calibration: Calibration) -> str:
    """Write a calibration as a rule file, every number with its source."""
    answers = calibration.answers
    study = f"study {answers.design.name}, {answers.head_count}"
    lines = [
        f"# Rules calibrated from the {_comment(study)}.",
        *([f"# {len(answers.set_aside)} more were set aside."] if answers.set_aside else []),
        "# A model's corners are sums of t, the time named, and w, the width at that time.",
        *(f"# Caution: {_comment(caution)}." for caution in calibration.cautions),
        "fuzzytime: 1",
        f"source: {_text(study)}",
    ]
    widths = calibration.widths
    if widths.points:
        source = f"{study}: half-bases of the trapezoids for 'in'"
        points = dict(widths.points)
        if widths(max(points) + 1.0) < points[max(points)]:
            # A slope below 0 would end in no width at all: beyond what was asked it stays as it is.
            points[max(points) + DAY] = points[max(points)]
        lines += ["width:", f"  points: {_points(points, ' s')}", f"  source: {_text(source)}"]
    lines.append("models:")
    for preposition, model in calibration.models.items():
        corners = ", ".join(corner.text for corner in model.breakpoints)
        constraint = CONSTRAINTS.get(preposition)
        source = f"{study}: trapezoids, {_errors(model.fits)}; corners within {model.missed:.1f} s"
        lines += [f"  {_text(preposition)}:", f"    breakpoints: [{corners}]"]
        lines += [f"    constraint: {constraint}"] if constraint else []
        lines.append(f"    source: {_text(source)}")
    lines.append("prepositions:")
    lines += [f"  {_text(name)}: {{model: {_text(name)}}}" for name in calibration.models]
    lines += _words(calibration, study)
    lines += _hedges(calibration, study)
    lines += _actors(calibration, study)
    return "\n".join(lines) + "\n"


def _words(calibration: Calibration, study: str) -> list[str]:
    rows = []
    for word, (entry, corners) in calibration.words.items():
        if corners is not None:
            row = f"breakpoints: [{', '.join(corner.text for corner in corners)}]"
        else:
            row = f"model: {_text(entry.preposition)}, t: {entry.t_spec:g} s"
            row += f", hedge: {_text(entry.fuzziness)}" if entry.fuzziness is not None else ""
        rows.append(f"  {_text(word)}: {{{row}, source: {_text(study)}}}")
    return ["words:", *rows] if rows else []


def _hedges(calibration: Calibration, study: str) -> list[str]:
    if not calibration.hedges:
        return []
    rows = []
    for hedge, factor in calibration.hedges.items():
        asked = ", ".join(
            entry.key
            for entry in calibration.answers.design.instructions
            if entry.fuzziness == hedge and entry.word is None
        )
        rows.append(f"    {_text(hedge)}: {{widen: {factor:.4g}, source: {_text(f'{study}: {asked}')}}}")
    return ["hedges:", "  time:", *rows]


def _actors(calibration: Calibration, study: str) -> list[str]:
    rows = []
    p_value = probability(calibration.groups_p) if calibration.groups_p is not None else ""
    for group, factors in calibration.actors.items():
        if group in ACTORS:
            found = "no difference found" if factors == {0.0: 1.0} else "groups differ"
            source = f"{study}: {found}, permutation test p {p_value}"
            rows.append(f"  {group}: {{width: {_points(factors, '')}, source: {_text(source)}}}")
    return ["actors:", *rows] if rows else []


def _points(points: Mapping[float, float], unit: str) -> str:
    return "{" + ", ".join(f"{_time(time)}: {_digits(value)}{unit}" for time, value in points.items()) + "}"


def _digits(value: float) -> str:
    """Write four significant digits, never as a power of ten, which no duration has."""
    return format(Decimal(f"{value:.4g}"), "f")


def _time(seconds: float) -> str:
    minutes = seconds / MINUTE
    return f"{minutes:g} min" if seconds and minutes == round(minutes) else f"{seconds:g} s"


def _errors(fits: Sequence[Fit]) -> str:
    errors = [fit.sse for fit in fits]
    return f"prediction error (SSE) {between(min(errors), max(errors), 3)}"


def _text(text: str) -> str:
    """Quote a text where YAML might read it otherwise; JSON strings are YAML."""
    plain = text.replace(" ", "").isascii() and text.replace(" ", "").isalpha()
    return text if plain and text.lower() not in _WORDS else json.dumps(text, ensure_ascii=False)


_WORDS = {"on", "off", "yes", "no", "true", "false", "null", "y", "n"}


def _comment(text: str) -> str:
    return " ".join(text.split())
