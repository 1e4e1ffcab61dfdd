"""Rules of a grammar, and the chart that applies them: the same machinery for every language.

A rule says which pieces, side by side, make a larger piece, and what it means:

    @grammar.rule("clock", "half past? <hour>")
    def half_past(hour: Hour) -> Clock: ...

In a pattern ``<name>`` is a piece of that category, given to the function; other words stand for themselves;
``a|b`` is a choice, and ``?`` after an element makes it optional (an optional piece that is absent is given as
None). A function may answer None: then the words do not make that piece ("the 31st of April").

The chart is filled from the last word to the first; so, when a rule meets a piece, everything that can follow it
is already there. For one category and stretch of words only the reading with the highest weight is kept, which
bounds the work: no input makes it explode.
"""

import itertools
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from fuzzytime.language.grammar.words import Word, joins

LONGEST = 28
"""Words that one piece may span at most: longer ones are not said."""

Action = Callable[..., Any]

_ELEMENT = re.compile(r"(?:<[^>]*>|[^\s<])+")


@dataclass(frozen=True, slots=True)
class Rule:
    """One way to make a piece: its pattern unfolded to a plain row of symbols.

    ``slots`` gives, for each argument of the action, the position of its symbol, or None.
    """

    name: str
    category: str
    symbols: tuple[str, ...]
    slots: tuple[int | None, ...]
    action: Action
    weight: float


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch of words with a category and a meaning; ``start`` and ``end`` count words."""

    category: str
    start: int
    end: int
    value: Any
    weight: float
    rule: str


Cell = dict[str, dict[int, Piece]]
"""What starts at one word: by category, then by end."""


def literal(word: str) -> str:
    """Give the symbol of a word that stands for itself."""
    return f"'{word}"


class Grammar:
    """The rules of a language."""

    def __init__(self) -> None:
        self.rules: list[Rule] = []
        self._first: dict[str, list[Rule]] = {}

    def rule(self, category: str, *patterns: str, weight: float = 0.0) -> Callable[[Action], Action]:
        """Give a decorator that adds a rule by its patterns; weight decides between readings of the same words."""

        def added(action: Action) -> Action:
            for pattern in patterns:
                for symbols, slots in unfolded(pattern):
                    rule = Rule(action.__name__, category, symbols, slots, action, weight)
                    self.rules.append(rule)
                    self._first.setdefault(symbols[0], []).append(rule)
            return action

        return added

    def include(self, other: "Grammar") -> None:
        """Add the rules of another grammar."""
        for rule in other.rules:
            self.rules.append(rule)
            self._first.setdefault(rule.symbols[0], []).append(rule)

    @property
    def literals(self) -> frozenset[str]:
        """The words that rules name."""
        return frozenset(s[1:] for rule in self.rules for s in rule.symbols if s[0] == "'")

    def parse(self, words: Sequence[Word], lexical: Mapping[int, Iterable[Piece]]) -> list[Cell]:
        """Fill the chart.

        Parameters
        ----------
        words
            The text's words.
        lexical
            By the word where they start, the pieces that word tables and shapes of numbers give.
        """
        chart: list[Cell] = [{} for _ in range(len(words) + 2)]
        literals = self.literals_set()
        for start in range(len(words) - 1, -1, -1):
            agenda = list(lexical.get(start, ()))
            word = words[start].text
            if word in literals:
                agenda.append(Piece(literal(word), start, start + 1, word, 0.0, "word"))
            if agenda:
                self._close(chart, start, agenda, words)
        return chart

    def literals_set(self) -> frozenset[str]:
        """Give `literals`, computed once all rules are there."""
        if not hasattr(self, "_literals"):
            self._literals = self.literals
        return self._literals

    def _close(self, chart: list[Cell], start: int, agenda: list[Piece], words: Sequence[Word]) -> None:
        """Add pieces that start at one word, and all that they begin."""
        cell = chart[start]
        while agenda:
            piece = agenda.pop()
            known = cell.setdefault(piece.category, {})
            held = known.get(piece.end)
            if held is not None and held.weight >= piece.weight:
                continue
            known[piece.end] = piece
            for rule in self._first.get(piece.category, ()):
                self._extend(chart, rule, (piece,), agenda, words)

    def _extend(
        self,
        chart: list[Cell],
        rule: Rule,
        found: tuple[Piece, ...],
        agenda: list[Piece],
        words: Sequence[Word],
    ) -> None:
        """Match the rest of a rule's symbols behind the pieces found."""
        end = found[-1].end
        if len(found) == len(rule.symbols):
            values = [None if slot is None else found[slot].value for slot in rule.slots]
            value = rule.action(*values)
            if value is not None:
                weight = rule.weight + sum(piece.weight for piece in found)
                agenda.append(Piece(rule.category, found[0].start, end, value, weight, rule.name))
            return
        symbol = rule.symbols[len(found)]
        following = chart[end].get(symbol)
        if following is not None:
            for piece in tuple(following.values()):
                if piece.end - found[0].start <= LONGEST:
                    self._extend(chart, rule, (*found, piece), agenda, words)
        # A hyphen that joins two words ("five-thirty", "early-morning") may be passed over.
        if end + 1 < len(words) and joins(words, end):
            following = chart[end + 1].get(symbol)
            if following is not None:
                for piece in tuple(following.values()):
                    if piece.end - found[0].start <= LONGEST:
                        self._extend(chart, rule, (*found, piece), agenda, words)


def unfolded(pattern: str) -> list[tuple[tuple[str, ...], tuple[int | None, ...]]]:
    """Give the plain rows of symbols that a pattern stands for, and where their arguments are.

    >>> unfolded("half past? <hour>")
    [(("'half", "'past", 'hour'), (2,)), (("'half", 'hour'), (1,))]
    """
    rows = []
    parts = _ELEMENT.findall(pattern)
    elements = [(part.rstrip("?").split("|"), part.endswith("?")) for part in parts]
    choices = [[*names, None] if optional else list(names) for names, optional in elements]
    argument = [names[0].startswith("<") for names, _ in elements]
    for row in itertools.product(*choices):
        symbols: list[str] = []
        slots: list[int | None] = []
        for name, wanted in zip(row, argument, strict=True):
            if wanted:
                slots.append(None if name is None else len(symbols))
            if name is not None:
                symbols.append(name[1:-1] if wanted else literal(name))
        if symbols:
            rows.append((tuple(symbols), tuple(slots)))
    return rows
