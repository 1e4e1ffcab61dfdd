"""The rules of a grammar, and the chart that applies them: the same machinery for every language.

The chart is filled from the last word to the first; so, when a rule meets a piece, everything that can follow
it is already there. For one category and stretch of words only the reading with the highest weight is kept,
which bounds the work: no input makes it explode.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar

from fuzzytime.language.grammar.patterns import Action, Pattern, Rule, literal, literals_in
from fuzzytime.language.grammar.words import Word, joins

LONGEST = 28
"""Words that one piece may span at most: longer ones are not said."""

_Action = TypeVar("_Action", bound=Action)


class Piece(NamedTuple):
    """A stretch of words with a category and a meaning; ``start`` and ``end`` count words."""

    category: str
    start: int
    end: int
    value: Any
    weight: float
    rule: str


Cell = dict[str, dict[int, Piece]]
"""What starts at one word: by category, then by end."""


@dataclass(frozen=True, slots=True)
class _Beginning:
    """The rules that begin with one symbol: those of no other, and by their second symbol those of more.

    With these stands their third symbol, None where they have no more.
    """

    single: list[Rule]
    longer: Mapping[str, list[tuple[str | None, Rule]]]

    @classmethod
    def of(cls, rules: Iterable[Rule]) -> "_Beginning":
        single: list[Rule] = []
        longer: dict[str, list[tuple[str | None, Rule]]] = {}
        for rule in rules:
            if len(rule.symbols) == 1:
                single.append(rule)
            else:
                second, *more = rule.symbols[1:]
                longer.setdefault(second, []).append((next(iter(more), None), rule))
        return cls(single, longer)


class _Index:
    """Patterns by the symbols that may begin them, unfolded when a text first has one: few texts have all."""

    def __init__(self, patterns: Sequence[Pattern]) -> None:
        self._patterns: dict[str, list[Pattern]] = {}
        self._beginnings: dict[str, _Beginning] = {}
        for pattern in patterns:
            for first in pattern.firsts():
                self._patterns.setdefault(first, []).append(pattern)
        self.literals = literals_in(patterns)

    def beginning(self, first: str) -> _Beginning:
        """Give the rules that begin with a symbol."""
        if first not in self._beginnings:
            rules = (rule for pattern in self._patterns.get(first, ()) for rule in pattern.rules())
            self._beginnings[first] = _Beginning.of(rule for rule in rules if rule.symbols[0] == first)
        return self._beginnings[first]


class Grammar:
    """The rules of a language."""

    def __init__(self) -> None:
        self.patterns: list[Pattern] = []
        self._index: _Index | None = None

    @property
    def literals(self) -> frozenset[str]:
        """The words that stand for themselves in a rule."""
        return self._indexed().literals

    def rule(self, category: str, *patterns: str, weight: float = 0.0) -> Callable[[_Action], _Action]:
        """Give a decorator that adds a rule; the weight decides between readings of the same words."""

        def added(action: _Action) -> _Action:
            name = f"{action.__module__.rpartition('.')[2]}.{action.__name__}"
            for text in patterns:
                self.add(Pattern(name, category, text, action, weight))
            return action

        return added

    @classmethod
    def of(cls, *others: "Grammar") -> "Grammar":
        """Give the rules of others in one."""
        whole = cls()
        for other in others:
            whole.patterns += other.patterns
        return whole

    def add(self, pattern: Pattern) -> None:
        """Add a rule."""
        self.patterns.append(pattern)
        self._index = None

    def _indexed(self) -> "_Index":
        """Give the rules by their first symbols: only a grammar that parses needs them so."""
        if self._index is None:
            self._index = _Index(self.patterns)
        return self._index

    def parse(self, words: Sequence[Word], lexical: Mapping[int, Iterable[Piece]]) -> list[Cell]:
        """Fill the chart.

        Parameters
        ----------
        words
            The text's words.
        lexical
            By the word where they start, the pieces that word tables and shapes of numbers give.
        """
        index = self._indexed()
        chart = Chart(words)
        for start in range(len(words) - 1, -1, -1):
            agenda = list(lexical.get(start, ()))
            word = words[start].text
            if word in index.literals:
                agenda.append(Piece(literal(word), start, start + 1, word, 0.0, "word"))
            if agenda:
                _close(index, chart, start, agenda)
        return chart.cells


def _close(index: _Index, chart: "Chart", start: int, agenda: list[Piece]) -> None:
    """Add pieces that start at one word, and all that they begin."""
    cell = chart.cells[start]
    while agenda:
        piece = agenda.pop()
        known = cell.setdefault(piece.category, {})
        held = known.get(piece.end)
        if held is not None and held.weight >= piece.weight:
            continue
        known[piece.end] = piece
        beginning = index.beginning(piece.category)
        for rule in beginning.single:
            _make(rule, (piece,), piece.weight, cell, agenda)
        if not beginning.longer:
            continue
        for place in chart.following(piece.end):
            for symbol, choices in chart.cells[place].items():
                if symbol not in beginning.longer:
                    continue
                behind = chart.behind(place, symbol)
                for third, rule in beginning.longer[symbol]:
                    # Most rules begin with what is there, and go on with what is not.
                    if third is None or third in behind:
                        _extend(chart, rule, (piece,), piece.weight, choices, agenda)


class Chart:
    """Cells, one for each word, and what may follow a piece."""

    def __init__(self, words: Sequence[Word]) -> None:
        self.cells: list[Cell] = [{} for _ in range(len(words) + 1)]
        self._following = [
            (place, place + 1) if joins(words, place) else (place,) for place in range(len(words))
        ]
        self._following.append((len(words),))
        self._behind: dict[tuple[int, str], frozenset[str]] = {}

    def following(self, end: int) -> tuple[int, ...]:
        """Give the cells at which the next piece may start; a hyphen that joins words may be passed over."""
        return self._following[end]

    def behind(self, place: int, category: str) -> frozenset[str]:
        """Give the categories of what may follow the pieces of a category that start at a word.

        The cells from that word on are full: it is asked about again and again.
        """
        key = place, category
        if key not in self._behind:
            cells = {cell for end in self.cells[place][category] for cell in self._following[end]}
            self._behind[key] = frozenset().union(*(self.cells[cell] for cell in cells))
        return self._behind[key]


def _extend(
    chart: Chart,
    rule: Rule,
    found: tuple[Piece, ...],
    weight: float,
    choices: Mapping[int, Piece],
    agenda: list[Piece],
) -> None:
    """Add each of some pieces to those found, and match the rest of a rule's symbols behind it.

    ``weight`` is what the pieces found weigh together.
    """
    start, symbols, size = found[0].start, rule.symbols, len(found) + 1
    for piece in choices.values():
        if piece.end - start > LONGEST:
            continue
        more, heavier = (*found, piece), weight + piece.weight
        if size == len(symbols):
            _make(rule, more, heavier, chart.cells[start], agenda)
            continue
        for place in chart.following(piece.end):
            if symbols[size] in chart.cells[place]:
                _extend(chart, rule, more, heavier, chart.cells[place][symbols[size]], agenda)


def _make(rule: Rule, found: tuple[Piece, ...], weight: float, cell: Cell, agenda: list[Piece]) -> None:
    """Make the piece of a rule whose symbols are all found, unless one is held that weighs as much."""
    weight, end = rule.weight + weight, found[-1].end
    held = cell[rule.category].get(end) if rule.category in cell else None
    if held is not None and held.weight >= weight:
        return
    value = rule.action(*[None if slot is None else found[slot].value for slot in rule.slots])
    if value is not None:
        agenda.append(Piece(rule.category, found[0].start, end, value, weight, rule.name))
