"""Numbers in digits, in words, and in the shapes in which clock times and dates are typed.

These are the pieces that the rules of a grammar start from, beside those of the word tables.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word, joins
from fuzzytime.language.policy import DateOrder
from fuzzytime.requirement import Unit

LONGEST_DIGITS = 9
MINUTE_DIGITS = 2
RUN = 14
"""Marks and digits without spaces that one shape may hold at most."""


@dataclass(frozen=True, slots=True)
class Integer:
    """A whole number; ``digits`` as typed, empty where it was words."""

    value: int
    digits: str = ""


@dataclass(frozen=True, slots=True)
class Typed:
    """Numbers typed in a shape: 8:30:00, 2026-03-04, 3/4, 15h30.

    ``ordered`` says that the points between them tell which is which: 10.3.2026.
    """

    parts: tuple[str, ...]
    ordered: bool = False

    def __getitem__(self, place: int) -> int:
        """Give one of the numbers."""
        return int(self.parts[place])


_SHAPES = tuple(
    (category, re.compile(shape))
    for category, shape in (
        ("hh:mm", r"(\d{1,2})[:;](\d\d)(?!\d)"),
        ("hh:mm:ss", r"(\d{1,2}):(\d\d):(\d\d)(?!\d)"),
        ("hh.mm", r"(\d{1,2})\.(\d\d)(?!\d)"),
        ("15h30", r"(\d{1,2})h(\d\d)(?!\d)"),
        ("decimal", r"(\d{1,9}\.\d{1,9})"),
        ("n,n", r"(\d{1,3}),(\d{1,2})(?!\d)"),
        ("n,nnn", r"(\d{1,3}),(\d{3})(?!\d)"),
        ("ratio", r"(\d{1,2})/(\d{1,2})(?!\d)"),
        ("n-n-n", r"(\d{1,2})([-/.])(\d{1,2})\2(\d{4}|\d\d)(?!\d)"),
        ("n/n", r"(\d{1,2})[-/](\d{1,2})(?!\d)"),
        ("n.n", r"(\d{1,2})\.(\d{1,2})(?!\d)"),
        ("d.m.", r"(\d{1,2})\.(\d{1,2})\.(?!\d)"),
        ("n/y", r"(\d{1,2})[-/](\d{4})(?!\d)"),
        ("y/n", r"(\d{4})[-/](\d{1,2})(?!\d)"),
        ("yyyymmdd", r"(\d{4})(\d\d)(\d\d)(?!\d)"),
    )
)
SURE_DATE = re.compile(r"(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})(?!\d)")
CLOSING_DATE = re.compile(r"(\d{4})-(\d{1,2})-(\d{1,2})(?!\d)")
"""A typed date that ends an interval of two."""
ISO_LENGTH = re.compile(
    r"p(?:(\d+)y)?(?:(\d+)m)?(?:(\d+)w)?(?:(\d+)d)?(?:t(?:(\d+)h)?(?:(\d+)m)?(?:(\d+)s)?)?(?![^\W_])"
)
DATE_WORDS = 4
"""Words of a typed date behind its first."""

OPENING = frozenset("([{@:;,<>=~")
"""Marks right behind which a typed date may begin: "(2026-03-28)", "due:2026-03-28"."""

DATES = frozenset({"n-n-n", "n/n", "n.n"})
"""Shapes whose first two numbers are month and day, in the order of the policy."""


def numeral_pieces(words: Sequence[Word], start: int, lexicon: Lexicon) -> Iterator[Piece]:
    """Give every number that starts at a word."""
    word = words[start]
    if word.is_digits:
        date = _sure_date(words, start)
        if date is None:
            yield from _typed(words, start, lexicon)
        elif date.start == start:
            yield date
    elif word.text == "." and _begins_decimal(words, start):
        digits = words[start + 1].text
        if len(digits) <= LONGEST_DIGITS:
            yield Piece(
                "decimal", start, start + 2, Typed((f"0.{int(digits):0{len(digits)}d}",)), 0.0, "shape"
            )
    else:
        yield from _typed_length(words, start)
        yield from _spoken(words, start, lexicon)


def _begins_decimal(words: Sequence[Word], point: int) -> bool:
    """Whether digits follow a point, and none stand in front of it: ".5"; but not the ".30" of "18.30"."""
    behind = words[point + 1 : point + 2]
    inside = point > 0 and words[point].glued and words[point - 1].is_digits
    return bool(behind) and behind[0].is_digits and behind[0].glued and not inside


def _sure_date(words: Sequence[Word], place: int) -> Piece | None:
    """Give the date, typed from the year to the day, that a number belongs to: it is nothing else then."""
    first = place
    while (
        first and words[first].glued and words[first - 1].text not in OPENING and place - first < DATE_WORDS
    ):
        first -= 1
    for start in range(first, place + 1):
        run, ends = _typed_together(words, start)
        match = (SURE_DATE if start == first else CLOSING_DATE).match(run)
        behind = start == first or _parts_dates(words, start)
        if behind and match is not None and match.end() in ends and ends[match.end()] > place:
            return Piece("y-m-d", start, ends[match.end()], Typed(match.groups()), 0.0, "shape")
    return None


def _parts_dates(words: Sequence[Word], place: int) -> bool:
    """Whether what stands before a place parts two dates: "2026-03-28/2026-03-30"."""
    return words[place - 1].text == "/" or [word.text for word in words[place - 2 : place]] == ["-", "-"]


def _typed(words: Sequence[Word], start: int, lexicon: Lexicon) -> Iterator[Piece]:
    word = words[start]
    if len(word.text) > LONGEST_DIGITS:
        return
    value = Integer(int(word.text), word.text)
    # A number that runs on ("650-650", "3.1.2", "1,000") is told by its whole shape, or is none of ours.
    yield Piece("integer", start, start + 1, value, 0.0, "digits")
    following = words[start + 1] if start + 1 < len(words) else None
    if following is not None and following.glued and following.text in lexicon.beside.ordinal_endings:
        for category in ("ordinal", "ordinal in digits"):
            yield Piece(category, start, start + 2, value.value, 0.0, "digits")
    yield from _spaced(words, start)
    run, ends = _typed_together(words, start)
    for category, shape in _SHAPES:
        match = shape.match(run)
        if match is not None and match.end() in ends:
            # What stands between the numbers of a date is told by what is alike: "3-3.30" is none.
            parts = tuple(part for part in match.groups() if part not in {"-", "/", "."})
            behind = words[ends[match.end()] :][:1]
            if category == "d.m." and behind and behind[0].capital:
                # "Set it to 2.5. At noon, stop it."
                continue
            # 10.3.2026: where points part them, the day comes first.
            pointed = category == "n-n-n" and match[0].count(".") == 2
            if pointed or (category in DATES and lexicon.policy.date_order is DateOrder.DAY_MONTH):
                parts = (parts[1], parts[0], *parts[2:])
            name = "last d.m." if category == "d.m." and not behind else category
            yield Piece(name, start, ends[match.end()], Typed(parts, pointed), 0.0, "shape")


def _typed_length(words: Sequence[Word], start: int) -> Iterator[Piece]:
    """Give a length as ISO 8601 has it: "PT2H30M"."""
    if not words[start].text.startswith("p") or not words[start].capital:
        return
    run, ends = _typed_together(words, start)
    match = ISO_LENGTH.match(run)
    if match is not None and match.end() in ends and match.end() > len(words[start].text):
        parts = tuple(part or "0" for part in match.groups())
        yield Piece("iso length", start, ends[match.end()], Typed(parts), 0.0, "shape")


def _spaced(words: Sequence[Word], start: int) -> Iterator[Piece]:
    """Give the clock time whose colon stands between spaces, as those write it who take down what is said."""
    mark, minutes = (*words[start + 1 : start + 3], None, None)[:2]
    if mark is None or minutes is None or mark.text != ":" or mark.glued or minutes.glued:
        return
    if minutes.is_digits and len(minutes.text) == MINUTE_DIGITS and len(words[start].text) <= MINUTE_DIGITS:
        yield Piece("hh:mm", start, start + 3, Typed((words[start].text, minutes.text)), 0.0, "shape")


def _typed_together(words: Sequence[Word], start: int) -> tuple[str, dict[int, int]]:
    """Give what is typed without a space from a word on, and which word ends at which of its characters."""
    text, ends = words[start].text, {len(words[start].text): start + 1}
    for place in range(start + 1, min(start + RUN, len(words))):
        if not words[place].glued:
            break
        text += words[place].text
        ends[len(text)] = place + 1
    return text, ends


def _spoken(words: Sequence[Word], start: int, lexicon: Lexicon) -> Iterator[Piece]:
    first = words[start].text
    if not (first in lexicon.numbers or first in lexicon.ordinals or first in lexicon.closed.one_of_hundreds):
        return
    scan = _Scan(words, lexicon)
    for end, value in scan.cardinals(start):
        yield Piece("integer", start, end, Integer(value), 0.0, "number words")
    for end, value in scan.ordinals(start):
        yield Piece("ordinal", start, end, value, 0.0, "number words")
    for end, value in scan.years(start):
        yield Piece("spoken year", start, end, value, 0.0, "number words")


class _Scan:
    """Number words from a place on: every beginning of them that is a number."""

    def __init__(self, words: Sequence[Word], lexicon: Lexicon) -> None:
        self.words = words
        self.lexicon = lexicon

    def text(self, place: int) -> str:
        return self.words[place].text if place < len(self.words) else ""

    def after(self, place: int) -> int:
        """Give the place behind a joining hyphen, or the place itself."""
        return place + 1 if place + 1 < len(self.words) and joins(self.words, place) else place

    def below_hundred(self, start: int) -> Iterator[tuple[int, int]]:
        """Give ends and values: "twenty", "twenty five"."""
        value = self.lexicon.numbers.get(self.text(start))
        if value is None:
            return
        yield start + 1, value
        if value >= 20:
            ones = self.after(start + 1)
            # "twenty and four hours"
            ones = ones + 1 if self.text(ones) == "and" and value == 20 else ones
            more = self.lexicon.numbers.get(self.text(ones))
            if more is not None and 1 <= more <= 9:
                yield ones + 1, value + more

    def below_thousand(self, start: int) -> Iterator[tuple[int, int]]:
        """Give ends and values: "one hundred and thirty", "a hundred"."""
        heads = list(self.below_hundred(start))
        yield from heads
        if self.text(start) in self.lexicon.closed.one_of_hundreds:
            heads.append((start + 1, 1))
        for end, value in heads:
            place = self.after(end)
            if self.lexicon.magnitudes.get(self.text(place)) == 100:
                yield place + 1, value * 100
                rest = place + 2 if self.text(place + 1) == "and" else self.after(place + 1)
                for stop, more in self.below_hundred(rest):
                    yield stop, value * 100 + more

    def cardinals(self, start: int) -> Iterator[tuple[int, int]]:
        """Give ends and values, thousands too."""
        heads = list(self.below_thousand(start))
        yield from heads
        if self.text(start) == "a":
            heads.append((start + 1, 1))
        for end, value in heads:
            place = self.after(end)
            if self.lexicon.magnitudes.get(self.text(place)) == 1000:
                yield place + 1, value * 1000
                rest = place + 2 if self.text(place + 1) == "and" else self.after(place + 1)
                for stop, more in self.below_thousand(rest):
                    yield stop, value * 1000 + more

    def ordinals(self, start: int) -> Iterator[tuple[int, int]]:
        """Give ends and values: "second", "twenty second"."""
        value = self.lexicon.ordinals.get(self.text(start))
        if value is not None:
            yield start + 1, value
        tens = self.lexicon.numbers.get(self.text(start), 0)
        if tens in {20, 30}:
            place = self.after(start + 1)
            ones = self.lexicon.ordinals.get(self.text(place))
            if ones is not None and ones < 10:
                yield place + 1, tens + ones

    def years(self, start: int) -> Iterator[tuple[int, int]]:
        """Give ends and values: "nineteen ninety nine", "twenty ten", "two thousand and seventeen"."""
        century = self.lexicon.numbers.get(self.text(start))
        if century is not None and 10 < century <= 20:
            place = self.after(start + 1)
            for end, rest in self.below_hundred(place):
                if rest >= 10:
                    yield end, century * 100 + rest
        for end, value in self.cardinals(start):
            if 1000 < value < 3000:
                yield end, value


SMALLER = {
    Unit.HOUR: Unit.MINUTE,
    Unit.MINUTE: Unit.SECOND,
    Unit.DAY: Unit.HOUR,
    Unit.WEEK: Unit.DAY,
    Unit.YEAR: Unit.MONTH,
}
"""The unit that a number behind an amount of a unit counts: "an hour thirty"."""
