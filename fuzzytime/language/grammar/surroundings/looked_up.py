"""Words of a text with what the tables say of each, looked up once; names that hold words about time."""

from collections.abc import Sequence
from functools import cached_property, lru_cache

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon, form_of, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.requirement import Unit

TIMELY = frozenset(
    {"preposition_at", "preposition_before", "preposition_after", "hedge", "hedge_after", "word", "zone"}
    | {"part", "day", "weekday", "month", "day_part", "unit"}
)
"""Categories of words that may follow a time and belong to it, or to another."""


class LookedUp:
    """The words of a text, and what each of them names."""

    def __init__(self, words: Sequence[Word], lexicon: Lexicon) -> None:
        self.words = words
        self.lexicon, self.closed, self.beside = lexicon, lexicon.closed, lexicon.beside
        self.texts = [word.text for word in words]
        self._pieces: dict[int, list[Piece]] = {}

    def pieces(self, place: int) -> list[Piece]:
        """Give what the tables say of the words from a place on, none at the end: looked up once."""
        if place not in self._pieces:
            inside = place < len(self.words)
            self._pieces[place] = list(self.lexicon.pieces(self.words, place)) if inside else []
        return self._pieces[place]

    @cached_property
    def known_names(self) -> frozenset[int]:
        """The places of words of known names, and of idioms."""
        return named_in(self.words, self.lexicon)

    def before(self, piece: Piece) -> str:
        """Give the word before it."""
        return self.texts[piece.start - 1] if piece.start else ""

    def follower(self, piece: Piece) -> str:
        """Give the word behind it."""
        return self.texts[piece.end] if piece.end < len(self.texts) else ""

    def timely(self, place: int) -> bool:
        """Whether the word at a place begins a time."""
        return any(piece.category in TIMELY for piece in self.pieces(place))

    def is_number(self, place: int) -> bool:
        """Whether there is a word at a place, and it is a number, in words or in digits."""
        inside = 0 <= place < len(self.words)
        return inside and (self.words[place].is_digits or self.texts[place] in self.lexicon.numbers)

    def is_day(self, place: int) -> bool:
        """Whether the word at a place names a day."""
        return any(piece.category in {"day", "weekday", "month"} for piece in self.pieces(place))

    def is_weekday(self, place: int) -> bool:
        """Whether the word at a place names a day of the week."""
        return any(piece.category == "weekday" for piece in self.pieces(place))

    def is_day_from_now(self, place: int) -> bool:
        """Whether the word at a place names a day, or a part of one, by where it is from now: "tonight"."""
        return any(
            piece.category == "day_part" or (piece.category == "day" and isinstance(piece.value, Relative))
            for piece in self.pieces(place)
        )

    def is_part(self, place: int) -> bool:
        """Whether the word at a place names a part of the day."""
        return any(piece.category == "part" for piece in self.pieces(place))

    def is_meal(self, place: int) -> bool:
        """Whether the word at a place names a meal."""
        return any(piece.category == "meal" for piece in self.pieces(place))

    def is_part_or_meal(self, place: int) -> bool:
        """Whether the word at a place names a part of the day, or a meal."""
        return self.is_part(place) or self.is_meal(place)

    def is_unit(self, place: int) -> bool:
        """Whether the word at a place is a unit, which a number before it counts."""
        return any(piece.category == "unit" and len(piece.value.form) > 1 for piece in self.pieces(place))

    def is_unit_of_days(self, place: int) -> bool:
        """Whether the word at a place is a unit of a day or more, which no hour with minutes counts."""
        units = (piece.value.unit for piece in self.pieces(place) if piece.category == "unit")
        return any(UNIT_SECONDS[unit] >= UNIT_SECONDS[Unit.DAY] for unit in units)


@lru_cache(maxsize=4)
def _forms(texts: frozenset[str]) -> dict[str, list[tuple[str, ...]]]:
    """Give forms of some words by their first."""
    found: dict[str, list[tuple[str, ...]]] = {}
    for form in map(form_of, sorted(texts)):
        found.setdefault(form[0], []).append(form)
    return found


def named_in(words: Sequence[Word], lexicon: Lexicon) -> frozenset[int]:
    """Give the places of words of such names: of idioms, and of titles, those with capitals if so typed.

    A name with capitals is one where other words have none: not in "Call Ann After Eight".
    """
    kinds, found = lexicon.no_times, set[int]()
    for start, word in enumerate(words):
        for texts in (kinds.idioms, kinds.capital_names):
            forms = _forms(texts).get(word.text)
            form = longest_match(words, start, forms) if forms else None
            if form is not None and (texts is kinds.idioms or _is_typed(words, start, len(form), lexicon)):
                found.update(range(start, start + len(form)))
    return frozenset(found)


def _is_typed(words: Sequence[Word], start: int, length: int, lexicon: Lexicon) -> bool:
    """Whether a name is typed with its capitals, where other words are small."""
    inside, others = words[start : start + length], (*words[:start], *words[start + length :])
    small = lexicon.closed.of_titles
    capitals = all(word.capital or not word.is_letters or word.text in small for word in inside)
    return capitals and any(word.is_letters and not word.capital for word in others)
