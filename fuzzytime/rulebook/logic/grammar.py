"""Reading conditions of rules by recursive descent; nothing in them is ever run.

::

    cond  := and {"or" and}
    and   := unary {"and" unary}
    unary := "not" unary | "(" cond ")" [temp] | atom
    atom  := VARIABLE "is" ["not"] {HEDGE} TERM [temp]
    temp  := ("throughout" | "sometime" | "mostly") ["in"] ["the"] ("last" | "next")
             ["about" | "roughly" | "exactly"] DURATION
"""

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from fuzzytime.errors import FuzzytimeError
from fuzzytime.rulebook.logic.formula import And, Direction, Formula, Is, Not, Operator, Or, Window
from fuzzytime.spelling import nearest, suggestion
from fuzzytime.times import DAY, UNITS, parse_duration

SOFTNESS = {"exactly": 0.0, "about": 0.25, "roughly": 0.5}
"""How far a hedged window fades beyond its length, as a share of it."""

KEYWORDS = frozenset({"and", "or", "not", "is", "in", "the", *Operator, *Direction, *SOFTNESS})
"""Words that no variable, term or hedge may be called."""

NONE: Mapping[str, Collection[str]] = MappingProxyType({})

LONGEST = 2000
DEEPEST = 24
LONGEST_WINDOW = 366 * DAY

_COMMON_UNITS = ("s", "min", "h", "d", "seconds", "minutes", "hours", "days")

_DIGITS = r"[-+]?(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][-+]?\d+)?"
_NUMBER = re.compile(_DIGITS)
_CLOSE = r"\d+(?:\.\d+)?(?![eE]\d)[A-Za-z]+\d[\w.]*"
"""A duration in one word: ``1h30``."""

_NAME = r"[^\W\d](?:\w|[^\x00-\x7f\s])*"
_LENGTH = re.compile(rf"{_CLOSE}|{_DIGITS}")
_TOKEN = re.compile(rf"{_NAME}|{_CLOSE}|{_DIGITS}|[()]|&&|\|\||[<>=!]=|\S")


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


def parse_condition(
    text: str,
    terms: Mapping[str, Collection[str]],
    hedges: Collection[str],
    signals: Mapping[str, Collection[str]] = NONE,
) -> Parsed:
    """Read a condition.

    Parameters
    ----------
    text
        The condition as written.
    terms
        The names of each variable's terms.
    hedges
        The hedges of terms ("very").
    signals
        The names of each signal's variables, through which alone a condition speaks of it.
    """
    if len(text) > LONGEST:
        message = f"a condition must not be longer than {LONGEST} characters, got {len(text)}"
        return Parsed(None, (Problem(message, 0),))
    parser = _Parser(text, terms, hedges, signals)
    formula = parser.whole()
    return Parsed(None if parser.problems else formula, tuple(parser.problems))


class _BrokenError(Exception):
    """The form is broken: what follows cannot be read."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem


class _Parser:
    """Reads one condition; unknown names are noted and read over."""

    def __init__(
        self,
        text: str,
        terms: Mapping[str, Collection[str]],
        hedges: Collection[str],
        signals: Mapping[str, Collection[str]],
    ) -> None:
        self.problems: list[Problem] = []
        self._terms = terms
        self._hedges = hedges
        self._signals = signals
        self._tokens = [(match[0], match.start()) for match in _TOKEN.finditer(text)]
        self._end = len(text.rstrip())
        self._at = 0
        self._depth = 0

    # -- tokens ---------------------------------------------------------------------------------------------

    @property
    def _next(self) -> str | None:
        return self._ahead(0)

    def _ahead(self, count: int) -> str | None:
        at = self._at + count
        return self._tokens[at][0] if at < len(self._tokens) else None

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

    def _expected(self, what: str, words: Collection[str] = ()) -> _BrokenError:
        found = "the end" if self._next is None else repr(self._next)
        close = nearest(self._next or "", words)
        meant = f" (did you mean {close!r}?)" if close is not None else ""
        return _BrokenError(Problem(f"expected {what}, got {found}{meant}", self._offset))

    def _unknown(self, message: str, word: str, known: Collection[str]) -> None:
        """Note that the next word is not known."""
        self.problems.append(Problem(f"{message}{suggestion(word, known)}", self._offset))

    # -- the grammar ----------------------------------------------------------------------------------------

    def whole(self) -> Formula | None:
        """Read the text to its end; where its form is broken, what follows is still searched for mistakes."""
        try:
            formula = self._any()
            self._check_end()
        except _BrokenError as error:
            self.problems.append(error.problem)
        else:
            return formula
        while self._next is not None:
            at = self._at
            if _is_name(self._next) and self._ahead(1) == "is":
                try:
                    self._windowed(self._atom())
                    self._check_end("and", "or", ")")
                except _BrokenError as error:
                    self.problems.append(error.problem)
            self._at = max(self._at, at + 1)
        return None

    def _check_end(self, *others: str) -> None:
        """Check that the text ends here, or goes on with one of these words."""
        if self._next is not None and self._next not in others:
            words = () if self._next in KEYWORDS else ("and", "or", *Operator)
            raise self._expected("'and', 'or', a window or the end", words)

    def _any(self) -> Formula:
        parts = [self._all()]
        while self._take("or"):
            parts.append(self._all())
        return parts[0] if len(parts) == 1 else Or(tuple(parts))

    def _all(self) -> Formula:
        parts = [self._unary()]
        while self._take("and"):
            parts.append(self._unary())
        return parts[0] if len(parts) == 1 else And(tuple(parts))

    def _unary(self) -> Formula:
        self._depth += 1
        if self._depth > DEEPEST:
            raise _BrokenError(Problem(f"a condition must not be nested deeper than {DEEPEST}", self._offset))
        if self._take("not"):
            formula: Formula = Not(self._unary())
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
        terms = self._terms.get(variable, ())
        if variable in self._signals and variable not in self._terms:
            message = f"{variable!r} is a signal; a condition speaks of variables"
            self._unknown(message, variable, self._signals[variable])
        elif variable not in self._terms:
            self._unknown(f"unknown variable {variable!r}", variable, self._terms)
        self._at += 1
        if not self._take("is"):
            raise self._expected("'is'", ("is",))
        negated = self._take("not") is not None
        hedges: list[str] = []
        while self._hedge_stands(terms):
            hedge = self._name("a hedge").lower()
            if hedge not in self._hedges:
                self._unknown(f"unknown hedge {hedge!r}", hedge, self._hedges)
            hedges.append(hedge)
            self._at += 1
        term = self._name("a term")
        if variable in self._terms and term not in terms:
            self._unknown(f"{variable!r} has no term {term!r}", term, terms)
        self._at += 1
        atom = Is(variable, term, tuple(hedges))
        return Not(atom) if negated else atom

    def _hedge_stands(self, terms: Collection[str]) -> bool:
        """Tell whether the next word is a hedge, perhaps a misspelt one: a term or a hedge follows."""
        word, following = self._next or "", self._ahead(1)
        if word in terms or not _is_name(word):
            return False
        if word.lower() in self._hedges or following in terms or (following or "").lower() in self._hedges:
            return True
        return _is_name(following) and nearest(word, self._hedges) is not None and not nearest(word, terms)

    def _name(self, what: str) -> str:
        """Give the next word, which must be a name, without taking it: a problem may stand at it."""
        word = self._next
        if word is None or not _is_name(word):
            raise self._expected(what)
        return word

    def _windowed(self, part: Formula) -> Formula:
        operator = self._take(*Operator)
        if operator is None:
            return part
        self._take("in")
        self._take("the")
        direction = self._take(*Direction)
        if direction is None:
            raise self._expected("'last' or 'next'", tuple(Direction))
        if _is_name(self._next) and _LENGTH.fullmatch(self._ahead(1) or ""):
            self._unknown(f"a window has no hedge {self._next!r}", self._next or "", SOFTNESS)
            self._at += 1
        softness = SOFTNESS[self._take(*SOFTNESS) or "exactly"]
        at = self._offset
        length = self._stretch()
        while self._next is not None and _LENGTH.fullmatch(self._next):
            length += self._stretch()
        if not 0 < length <= LONGEST_WINDOW:
            limit = f"longer than 0 and at most {LONGEST_WINDOW / DAY:g} d"
            self.problems.append(Problem(f"a window must be {limit}", at))
        return Window(Operator(operator), Direction(direction), length, softness, part)

    def _stretch(self) -> float:
        """Read a number and its unit, or what is written as one word, in seconds."""
        number = self._next
        if number is None or not _LENGTH.fullmatch(number):
            raise self._expected("a number")
        if not _NUMBER.fullmatch(number):
            return self._in_one_word(number)
        self._at += 1
        unit = self._next
        if unit not in UNITS:
            if unit is None or not unit[0].isalpha():
                raise self._expected("a unit of time such as s, min or h")
            self._unknown(f"unknown unit of time {unit!r}", unit, _COMMON_UNITS)
        self._at += 1
        return float(number) * UNITS.get(unit, 1.0)

    def _in_one_word(self, text: str) -> float:
        """Read ``1h30``."""
        try:
            return parse_duration(text)
        except FuzzytimeError as error:
            self.problems.append(Problem(str(error), self._offset))
            return 1.0
        finally:
            self._at += 1


def _is_name(word: str | None) -> bool:
    return bool(word) and word is not None and word.isidentifier() and word not in KEYWORDS
