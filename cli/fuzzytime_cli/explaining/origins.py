"""What a satisfaction function comes of: rows, rules with degrees and readings, hedges, the model."""

import numpy as np

from fuzzytime.requirement import Reference
from fuzzytime.rulebook import Resolution, Share
from fuzzytime.times import format_duration
from fuzzytime_cli.render import plain


def resolution_lines(resolution: Resolution) -> list[str]:
    """Give the rows and rules behind one ψ, with degrees and readings."""
    lines = []
    for share in resolution.shares:
        lines += _share_lines(share)
    for hedge in resolution.hedges:
        lines.append(_row(f"hedge {plain(hedge.name)}", plain(hedge.source), f"× {hedge.factor:g}"))
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


def _row(name: str, source: str, weight: str) -> str:
    """Give what came into ψ, where it is written, and how it counts, each in its column."""
    return f"{name:<24} {source:<28} {weight}"


def _share_lines(share: Share) -> list[str]:
    factors = ", ".join(f"{name} × {factor:.2f}" for name, factor in share.scale.items())
    line = _row(plain(share.name), plain(share.source), factors or f"share {share.share:.2f}")
    if share.degree.low != 1 or share.degree.high != 1:
        line += f"  holds {_between(share.degree.low, share.degree.high)}"
    lines = [line]
    for atom in share.atoms:
        evidence = f" ({plain(atom.evidence)})" if atom.evidence else ""
        lines.append(f"  {plain(atom.text)}: {_between(atom.degree.low, atom.degree.high)}{evidence}")
        if atom.meaning:
            lines.append(f"    {plain(atom.meaning)}")
    return lines


def _between(low: float, high: float) -> str:
    return f"{low:.2f}" if abs(high - low) < 0.005 else f"between {low:.2f} and {high:.2f}"
