"""Reading conditions of rules by recursive descent; nothing in them is ever run.

::

    cond  := and {"or" and}
    and   := unary {"and" unary}
    unary := "not" unary | "(" cond ")" [temp] | atom
    atom  := VARIABLE "is" ["not"] {HEDGE} TERM [temp]
    temp  := ("throughout" | "sometime" | "mostly") ["in"] ["the"] ("last" | "next")
             ["about" | "roughly" | "exactly"] NUMBER UNIT {NUMBER UNIT}
"""

import math
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass

from fuzzytime.rulebook.formula import And, Direction, Formula, Is, Not, Operator, Or, Window
from fuzzytime.times import UNITS
from fuzzytime.yaml_nodes import suggestion

SOFTNESS = {"exactly": 0.0, "about": 0.25, "roughly": 0.5}
"""How far a hedged window fades beyond its length, as a share of it."""

KEYWORDS = frozenset({"and", "or", "not", "is", "in", "the", *Operator, *Direction, *SOFTNESS})
"""Words that no variable, term or hedge may be called."""

LONGEST = 2000
DEEPEST = 24

_COMMON_UNITS = ("s", "min", "h", "d", "seconds", "minutes", "hours", "days")

_NUMBER = re.compile(r"\d+(?:\.\d+)?|\.\d+")
_TOKEN = re.compile(r"[A-Za-z_]\w*|\d+(?:\.\d+)?|\.\d+|[()]|\S")


@dataclass(frozen=True, slots=True)
class Problem:
    """What is wrong with a condition, and at which character."""

    message: str
    offset: int


@dataclass(frozen=True, slots=True)
class Parsed:
    """A condition's formula, None where it has none, and every problem found."""

    formula: Formula | None
    problems: tuple[Problem, ...]


def parse_condition(text: str, terms: Mapping[str, Collection[str]], hedges: Collection[str]) -> Parsed:
    """Read a condition.

    Parameters
    ----------
    text
        The condition as written.
    terms
        The names of each variable's terms.
    hedges
        The hedges of terms ("very").
    """
    if len(text) > LONGEST:
        message = f"a condition must not be longer than {LONGEST} characters, got {len(text)}"
        return Parsed(None, (Problem(message, 0),))
    parser = _Parser(text, terms, hedges)
    try:
        formula = parser.whole()
    except _BrokenError as error:
        return Parsed(None, (*parser.problems, error.problem))
    return Parsed(None if parser.problems else formula, tuple(parser.problems))


class _BrokenError(Exception):
    """The form is broken: what follows cannot be read."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem


class _Parser:
    """Reads one condition; unknown names are noted and read over."""

    def __init__(self, text: str, terms: Mapping[str, Collection[str]], hedges: Collection[str]) -> None:
        self.problems: list[Problem] = []
        self._terms = terms
        self._hedges = hedges
        self._tokens = [(match[0], match.start()) for match in _TOKEN.finditer(text)]
        self._end = len(text.rstrip())
        self._at = 0
        self._depth = 0

    # -- tokens ---------------------------------------------------------------------------------------------

    @property
    def _next(self) -> str | None:
        return self._tokens[self._at][0] if self._at < len(self._tokens) else None

    @property
    def _offset(self) -> int:
        return self._tokens[self._at][1] if self._at < len(self._tokens) else self._end

    def _take(self, *words: str) -> str | None:
        """Take the next word if it is one of these."""
        word = self._next
        if word is None or word not in words:
            return None
        self._at += 1
        return word

    def _expected(self, what: str) -> _BrokenError:
        found = "the end" if self._next is None else repr(self._next)
        return _BrokenError(Problem(f"expected {what}, got {found}", self._offset))

    def _unknown(self, message: str, word: str, known: Collection[str]) -> None:
        self.problems.append(Problem(f"{message}{suggestion(word, known)}", self._offset))

    # -- the grammar ----------------------------------------------------------------------------------------

    def whole(self) -> Formula:
        """Read the text to its end."""
        formula = self._any()
        if self._next is not None:
            raise self._expected("'and', 'or' or the end")
        return formula

    def _any(self) -> Formula:
        parts = [self._all()]
        while self._take("or"):
            parts.append(self._all())
        return parts[0] if len(parts) == 1 else Or(tuple(parts))

    def _all(self) -> Formula:
        parts = [self._one()]
        while self._take("and"):
            parts.append(self._one())
        return parts[0] if len(parts) == 1 else And(tuple(parts))

    def _one(self) -> Formula:
        self._depth += 1
        if self._depth > DEEPEST:
            raise _BrokenError(Problem(f"a condition must not be nested deeper than {DEEPEST}", self._offset))
        if self._take("not"):
            formula: Formula = Not(self._one())
        elif self._take("("):
            formula = self._any()
            if not self._take(")"):
                raise self._expected("')'")
            formula = self._windowed(formula)
        else:
            formula = self._windowed(self._atom())
        self._depth -= 1
        return formula

    def _atom(self) -> Formula:
        variable = self._name("a variable")
        known = variable in self._terms
        if not known:
            self._at -= 1
            self._unknown(f"unknown variable {variable!r}", variable, self._terms)
            self._at += 1
        if not self._take("is"):
            raise self._expected("'is'")
        negated = self._take("not") is not None
        hedges: list[str] = []
        while self._next in self._hedges and not (known and self._next in self._terms[variable]):
            hedges.append(self._name("a hedge"))
        term = self._name("a term")
        if known and term not in self._terms[variable]:
            self._at -= 1
            self._unknown(f"{variable!r} has no term {term!r}", term, self._terms[variable])
            self._at += 1
        atom = Is(variable, term, tuple(hedges))
        return Not(atom) if negated else atom

    def _name(self, what: str) -> str:
        word = self._next
        if word is None or not (word[0].isalpha() or word[0] == "_") or word in KEYWORDS:
            raise self._expected(what)
        self._at += 1
        return word

    def _windowed(self, part: Formula) -> Formula:
        operator = self._take(*Operator)
        if operator is None:
            return part
        self._take("in")
        self._take("the")
        direction = self._take(*Direction)
        if direction is None:
            raise self._expected("'last' or 'next'")
        softness = SOFTNESS[self._take(*SOFTNESS) or "exactly"]
        at = self._offset
        length = self._stretch()
        while self._next is not None and _NUMBER.fullmatch(self._next):
            length += self._stretch()
        if not 0 < length < math.inf:
            self.problems.append(Problem("a window must be longer than 0 and have an end", at))
        return Window(Operator(operator), Direction(direction), length, softness, part)

    def _stretch(self) -> float:
        """Read a number and its unit, in seconds."""
        number = self._next
        if number is None or not _NUMBER.fullmatch(number):
            raise self._expected("a number")
        self._at += 1
        unit = self._next
        if unit not in UNITS:
            if unit is None or not unit[0].isalpha():
                raise self._expected("a unit of time such as s, min or h")
            self._unknown(f"unknown unit of time {unit!r}", unit, _COMMON_UNITS)
        self._at += 1
        return float(number) * UNITS.get(unit, 1.0)
