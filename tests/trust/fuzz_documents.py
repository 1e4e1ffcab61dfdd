"""Mutate rule files and context files: each is valid, or refused with a place; nothing else may happen.

    PYTHONPATH=. python tests/trust/fuzz_documents.py --files 100000 --seed 1

Prints how many files were mutated, how many were refused, and every failure. A file that is still valid is
used as well: a few requirements are resolved by it, and every ψ must lie in [0, 1].
"""

import argparse
import random
import re
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from fuzzytime.context import Context, read_context_lines
from fuzzytime.errors import DocumentError, FuzzytimeError
from fuzzytime.requirement import Condition, Constraint, TimeRequirement, Unit
from fuzzytime.rulebook import Profile, Rulebook
from fuzzytime.rulebook.documents import read_over
from fuzzytime.yaml_nodes import Reader

RULES = Path(__file__).with_name("fuzzed_rules.yaml").read_text(encoding="utf-8")
READINGS = Path(__file__).with_name("fuzzed_readings.jsonl").read_text(encoding="utf-8")

NASTY = (
    "", "~", "null", "true", "on", "0", "-1", "1e999", "-1e308", "1e-320", "nan", ".inf", "9" * 400, "1:30",
    "[", "]", "{", "}", "{}", "[]", ":", "- ", "? ", "| ", "> ", "#", "'", '"', "\t", "\r", "\n", "\x00",
    "\x85", "\u2028", "\ufeff", "\ud800", "é", "日本", "🕒", "\x1b[31m", "*a", "&a ", "!!python/name:os.x ",
    "<<: ", "---\n", "...\n", "%YAML 9\n", "t", "w", "1000000t", "1 h", "99999999 h", "-5 min", "300 d",
    "inf", "-inf", "not ", "and ", "(", ")" * 50, "(" * 50, "very " * 50, "is", "in the last 5 min",
    "__import__('os').system('ls')",
)  # fmt: skip
"""What is put in anywhere."""

REQUIREMENTS = (
    TimeRequirement(text="soon", span=(0, 4), constraint=Constraint.VAGUE, word="soon"),
    TimeRequirement(
        text="in about ten minutes",
        span=(0, 20),
        constraint=Constraint.AT,
        preposition="in",
        fuzziness=("about",),
        number=10,
        unit=Unit.MINUTE,
        t_spec=600.0,
    ),
    TimeRequirement(text="by noon", span=(0, 7), constraint=Constraint.BEFORE, preposition="by", t_spec=1e4),
    TimeRequirement(
        text="when the pan is hot",
        span=(0, 19),
        constraint=Constraint.WHEN,
        preposition="when",
        condition=Condition(text="when the pan is hot", subject="pan", word="hot"),
    ),
)
CONTEXTS = (
    Context.empty,
    Context.of({"heat": [(-60.0, 80.0), (0.0, 120.0)], "load": 3.0, "bell": None}),
)
TIMES = np.linspace(0.0, 7200.0, 50)

Mutation = Callable[[random.Random, str], str]


def _spans(text: str) -> list[tuple[int, int]]:
    """Where the words and signs of a text stand."""
    spans, start = [], 0
    for i, character in enumerate(text):
        if not (character.isalnum() or character in "_."):
            if start < i:
                spans.append((start, i))
            spans.append((i, i + 1))
            start = i + 1
    return [*spans, (start, len(text))]


def replace_word(chance: random.Random, text: str) -> str:
    start, end = chance.choice(_spans(text))
    return text[:start] + chance.choice(NASTY) + text[end:]


def change_number(chance: random.Random, text: str) -> str:
    numbers = [match.span() for match in re.finditer(r"\d+(\.\d+)?", text)]
    if not numbers:
        return text
    start, end = chance.choice(numbers)
    number = chance.choice(
        (chance.randrange(10), chance.randrange(1000), round(chance.random(), 3), 1e-9, 10**7)
    )
    return f"{text[:start]}{number}{text[end:]}"


def swap_words(chance: random.Random, text: str) -> str:
    (a, b), (c, d) = sorted((chance.choice(_spans(text)), chance.choice(_spans(text))))
    return text if c < b else text[:a] + text[c:d] + text[b:c] + text[a:b] + text[d:]


def put_in(chance: random.Random, text: str) -> str:
    at = chance.randrange(len(text) + 1)
    return text[:at] + chance.choice(NASTY) + text[at:]


def cut(chance: random.Random, text: str) -> str:
    start = chance.randrange(len(text) + 1)
    return text[:start] + text[start + chance.randrange(1, 40) :]


def cut_off(chance: random.Random, text: str) -> str:
    return text[: chance.randrange(len(text) + 1)]


def double(chance: random.Random, text: str) -> str:
    start = chance.randrange(len(text) + 1)
    end = start + chance.randrange(1, 200)
    return text[:end] + text[start:end] + text[end:]


def change_character(chance: random.Random, text: str) -> str:
    at = chance.randrange(len(text)) if text else 0
    return text[:at] + chr(chance.choice((chance.randrange(128), chance.randrange(0x3000)))) + text[at + 1 :]


def move_line(chance: random.Random, text: str) -> str:
    lines = text.split("\n")
    line = lines.pop(chance.randrange(len(lines)))
    lines.insert(chance.randrange(len(lines) + 1), line)
    return "\n".join(lines)


def indent_line(chance: random.Random, text: str) -> str:
    lines = text.split("\n")
    at = chance.randrange(len(lines))
    lines[at] = " " * chance.randrange(1, 9) + lines[at] if chance.random() < 0.5 else lines[at].lstrip()
    return "\n".join(lines)


MUTATIONS: Sequence[Mutation] = (
    *[replace_word] * 2,
    *[change_number] * 4,
    swap_words,
    put_in,
    cut,
    cut_off,
    double,
    change_character,
    move_line,
    indent_line,
)


def mutated(chance: random.Random, text: str) -> bytes:
    """Mutate a text a few times, and rarely its bytes too."""
    for _ in range(chance.choice((1, 1, 1, 2, 3, 6))):
        text = chance.choice(MUTATIONS)(chance, text)
    raw = bytearray(text.encode("utf-8", "surrogatepass"))
    if raw and chance.random() < 0.1:
        raw[chance.randrange(len(raw))] = chance.randrange(256)
    return bytes(raw)


def try_rules(raw: bytes, shipped: Rulebook, chance: random.Random) -> None:
    """Read a rule file, and use it where it is valid.

    Raises
    ------
    DocumentError
        If it is not.
    """
    tables, mistakes = read_over(shipped.tables, [Reader("fuzzed.yaml", raw)], Profile.EVERYDAY)
    if mistakes:
        raise DocumentError(mistakes)
    rulebook = Rulebook(tables)
    rulebook.duration_of("boil", "the eggs")
    for requirement in chance.sample(REQUIREMENTS, 2):
        context = chance.choice(CONTEXTS)
        try:
            context.admitted(rulebook.signals)
        except FuzzytimeError:
            context = Context.empty  # the table declared these signals away, or other limits
        values = rulebook.resolve(requirement, context, verb="flip", elapsed=300.0).satisfaction(TIMES)
        if not ((values >= 0) & (values <= 1)).all():
            message = f"ψ must lie in [0, 1], got {values.min()} to {values.max()}"
            raise AssertionError(message)


def try_readings(raw: bytes, shipped: Rulebook) -> None:
    """Read a context file, and use it where it is valid.

    Raises
    ------
    DocumentError
        If it is not.
    """
    context = read_context_lines(raw, "fuzzed.jsonl", None, shipped.signals)
    shipped.resolve(REQUIREMENTS[3], context)


def run(files: int, seed: int, report: Callable[[str], None]) -> Counter[str]:
    """Mutate so many files, every tenth a context file; count what came of them, and report failures."""
    shipped = Rulebook.shipped()
    counts: Counter[str] = Counter()
    for number in range(files):
        chance = random.Random(f"{seed}-{number}")
        of_rules = number % 10 != 0
        kind = "rule files" if of_rules else "context files"
        raw = mutated(chance, RULES if of_rules else READINGS)
        try:
            if of_rules:
                try_rules(raw, shipped, chance)
            else:
                try_readings(raw, shipped)
            counts[f"{kind} still valid, and used"] += 1
        except DocumentError as error:
            placed = all(mistake.line >= 1 and mistake.column >= 1 for mistake in error.mistakes)
            counts[f"{kind} refused with places" if placed and str(error) else "failures"] += 1
        except Exception as error:  # noqa: BLE001 - whatever it is, it is what is looked for
            counts["failures"] += 1
            report(f"failure at seed {seed}, file {number}: {type(error).__name__}: {error}\n{raw!r}")
    return counts


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    options.add_argument("--files", type=int, default=100_000)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    started = time.perf_counter()
    counts = run(chosen.files, chosen.seed, print)
    print(f"{chosen.files:,} mutated files in {time.perf_counter() - started:.0f} s, seed {chosen.seed}")
    for kind, count in sorted(counts.items()):
        print(f"{count:9,}  {kind}")
    raise SystemExit(1 if counts["failures"] else 0)


if __name__ == "__main__":
    main()
