"""Rules as they are written: patterns, and the plain rows of symbols that they stand for.

A rule says which pieces, side by side, make a larger piece, and what it means:

    @grammar.rule("clock", "half past? <hour>")
    def half_past(hour: Hour) -> Clock: ...

In a pattern ``<name>`` is a piece of that category, given to the function; other words stand for
themselves; ``a|b`` is a choice, and ``?`` after an element makes it optional (an optional piece that is
absent is given as None). A function may answer None: then the words do not make that piece ("the 31st of
April").
"""

import itertools
import re
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from typing import Any, NamedTuple

Action = Callable[..., Any]

_PART = re.compile(r"(?:<[^>]*>|[^\s<])+")
_BETWEEN_LITERALS = re.compile(r"(?:<[^>]*>|[\s|?])+")
_Element = tuple[bool, list[str | None]]
"""A part of a pattern: whether it is an argument, and what it may be; None where it may be absent."""


class Rule(NamedTuple):
    """One way to make a piece: a pattern unfolded to a plain row of symbols.

    ``slots`` gives, for each argument of the action, the position of its symbol, or None.
    """

    name: str
    category: str
    symbols: tuple[str, ...]
    slots: tuple[int | None, ...]
    action: Action
    weight: float


class Pattern(NamedTuple):
    """One pattern of a rule, as it is written."""

    name: str
    category: str
    text: str
    action: Action
    weight: float

    def rules(self) -> Iterator[Rule]:
        """Give the plain rows that it stands for."""
        for symbols, slots in unfolded(self.text):
            yield Rule(self.name, self.category, symbols, slots, self.action, self.weight)

    def firsts(self) -> list[str]:
        """Give the symbols that its rows may begin with, each once."""
        firsts: dict[str, None] = {}
        for _, choices in _elements(self.text):
            firsts |= dict.fromkeys(symbol for symbol in choices if symbol is not None)
            if None not in choices:
                break
        return list(firsts)


def literal(word: str) -> str:
    """Give the symbol of a word that stands for itself."""
    return f"'{word}"


def literals_in(patterns: Iterable[Pattern]) -> frozenset[str]:
    """Give the words that stand for themselves in some patterns."""
    texts = "\n".join(pattern.text for pattern in patterns)
    return frozenset(_BETWEEN_LITERALS.split(texts)) - {""}


@cache
def unfolded(pattern: str) -> tuple[tuple[tuple[str, ...], tuple[int | None, ...]], ...]:
    """Give the plain rows of symbols that a pattern stands for, and where their arguments are.

    >>> unfolded("half past? <hour>")
    ((("'half", "'past", 'hour'), (2,)), (("'half", 'hour'), (1,)))
    """
    elements = list(_elements(pattern))
    rows = []
    for row in itertools.product(*[choices for _, choices in elements]):
        symbols: list[str] = []
        slots: list[int | None] = []
        for symbol, (wanted, _) in zip(row, elements, strict=True):
            if wanted:
                slots.append(None if symbol is None else len(symbols))
            if symbol is not None:
                symbols.append(symbol)
        if symbols:
            rows.append((tuple(symbols), tuple(slots)))
    return tuple(rows)


def _elements(pattern: str) -> Iterator[_Element]:
    """Give the parts of a pattern as they are wanted: often nobody asks beyond the first."""
    for found in _PART.finditer(pattern):
        part = found[0]
        names = part.rstrip("?").split("|")
        wanted = part.startswith("<")
        choices: list[str | None] = [name[1:-1] if wanted else literal(name) for name in names]
        yield wanted, [*choices, None] if part.endswith("?") else choices
