"""Mutations of a text: one character, word, number or line after the other, and rarely a byte."""

import random
import re
from collections.abc import Callable, Sequence

NASTY = (
    "", "~", "null", "true", "on", "0", "-1", "1e999", "-1e308", "1e-320", "nan", ".inf", "9" * 400, "1:30",
    "[", "]", "{", "}", "{}", "[]", ":", "- ", "? ", "| ", "> ", "#", "'", '"', "\t", "\r", "\n", "\x00",
    "\x85", "\u2028", "\ufeff", "\ud800", "é", "日本", "🕒", "\x1b[31m", "*a", "&a ", "!!python/name:os.x ",
    "<<: ", "---\n", "...\n", "%YAML 9\n", "t", "w", "1000000t", "1 h", "99999999 h", "-5 min", "300 d",
    "inf", "-inf", "not ", "and ", "(", ")" * 50, "(" * 50, "very " * 50, "is", "in the last 5 min",
    "__import__('os').system('ls')",
)  # fmt: skip
"""What is put in anywhere."""

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
