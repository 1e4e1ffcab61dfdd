"""What is understood of words: the tree, those that say when, time requirements, and what is in doubt."""

from fuzzytime.language import Reading, Token
from fuzzytime.requirement import Comparison, TimeRequirement
from fuzzytime.times import format_duration
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import fitted, plain, width_of


def tree_lines(reading: Reading, width: int) -> list[str]:
    """Give the dependency tree, a word a line, each under its head, with tag and the paper's relation."""
    children: dict[int, list[int]] = {}
    roots = []
    for position, token in enumerate(reading.tokens):
        if token.head == position:
            roots.append(position)
        else:
            children.setdefault(token.head, []).append(position)
    lines: list[str] = []
    column = min(34, max(14, width - 16))
    for root in roots:
        _branch(reading.tokens, children, root, column, lines)
    return lines


def _branch(
    tokens: tuple[Token, ...],
    children: dict[int, list[int]],
    root: int,
    column: int,
    lines: list[str],
) -> None:
    """Draw a word and what hangs on it; depth is bounded by the length of an instruction."""
    stack = [(root, "", "")]
    while stack:
        here, head, tail = stack.pop()
        token = tokens[here]
        label = f"{head}{plain(token.text)}"
        lines.append(f"{label}{' ' * max(1, column - width_of(label))}{token.tag:<6} {token.relation}")
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
        return "none by the paper's rule: no time hangs on the main verb (oblique temporal modifier)"
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
        facts += [_compared(comparison) for comparison in requirement.condition.comparisons]
    joint = "or " if requirement.alternative else ""
    return [f"{joint}{plain(requirement.text)!r}: {', '.join(facts)}"]


def _compared(comparison: Comparison) -> str:
    """Give the number of a clause, and its side: "above about 150"."""
    until = f" and {comparison.until:g}" if comparison.until is not None else ""
    return " ".join(
        (comparison.side.value, *map(plain, comparison.fuzziness), f"{comparison.number:g}{until}")
    )


def doubt_lines(reading: Reading) -> list[str]:
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
