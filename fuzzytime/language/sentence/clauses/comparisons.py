"""Numbers in clauses: "the oven is above 150 degrees", "it has cooled down to about forty"."""

from collections.abc import Iterator
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.units import Quantity
from fuzzytime.requirement import Comparison, Side

MOST_BEHIND = 6
"""Words behind a number that may say what it counts."""

MOST_OF = 5
"""Words up to "of" that may say what the number is: "an internal temperature of"."""


@dataclass(frozen=True, slots=True)
class _Number:
    """A number with its hedges, and the place behind it."""

    value: float
    end: int
    hedges: tuple[str, ...] = ()


def comparisons_in(scanned: Scanned, span: Span, *, bare: bool = False) -> tuple[Comparison, ...]:
    """Give the numbers that a stretch of a text measures something by; a ``bare`` one may begin it."""
    inside = [p for p, word in enumerate(scanned.words) if span[0] <= word.start and word.end <= span[1]]
    return tuple(_comparisons(scanned, inside, bare=bare)) if inside else ()


def _comparisons(scanned: Scanned, inside: list[int], *, bare: bool) -> Iterator[Comparison]:
    lexicon = scanned.lexicon
    words, last = scanned.words, inside[-1] + 1
    place = inside[0]
    while place < last:
        form = longest_match(words, place, lexicon.comparisons)
        # "Until 80 degrees"
        form = () if form is None and bare and place == inside[0] else form
        end = _number_place(words, place, form, lexicon) if form is not None else place
        number = _number(scanned, end, last) if form is not None else None
        if form is None or number is None:
            place += 1
            continue
        side, until = lexicon.comparisons[form] if form else Side.AT, None
        if number.end < last and words[number.end].text in lexicon.closed.range_joints_or_and:
            until = _number(scanned, number.end + 1, last)
        ranges = side in (Side.AT, Side.BETWEEN) and until is not None and until.value > number.value
        if ranges and until is not None:
            side, stop = Side.BETWEEN, until.end
        else:
            until, stop = None, number.end
        if side is not Side.BETWEEN or ranges:
            behind = words[stop : min(stop + MOST_BEHIND, last)]
            yield Comparison(
                text=scanned.text[words[place].start : words[stop - 1].end],
                side=side,
                number=number.value,
                until=until.value if until is not None else None,
                fuzziness=tuple(dict.fromkeys((*number.hedges, *(until.hedges if until else ())))),
                behind=scanned.text[behind[0].start : behind[-1].end] if behind else "",
            )
        place = stop


def _number_place(words: tuple[Word, ...], place: int, form: tuple[str, ...], lexicon: Lexicon) -> int:
    """Give the place behind a form and what the number is of: "reaches", "reaches a temperature of"."""
    for text in form:
        while words[place].text != text:
            # A hyphen that joins the form's words.
            place += 1
        place += 1
    if words[place : place + 1] and words[place].text in lexicon.closed.before_numbers:
        noun = next(
            (p for p in range(place, min(place + MOST_OF, len(words))) if words[p].text == "of"), None
        )
        return place if noun is None else noun + 1
    return place


def _number(scanned: Scanned, place: int, last: int) -> _Number | None:
    """Read the longest number at a place, where it is one by itself: neither "a mess" nor "8:30"."""
    words = scanned.words
    if place >= last or longest_match(words, place, scanned.lexicon.comparisons):
        # "Is above 150": the words behind "is" say on which side.
        return None
    if words[place].text in scanned.lexicon.beside.minus:
        positive = _number(scanned, place + 1, last)
        return positive and _Number(-positive.value, positive.end, positive.hedges)
    pieces = [piece for piece in scanned.cells[place].get("quantity", {}).values() if piece.end <= last]
    if not pieces:
        return None
    piece = max(pieces, key=lambda piece: piece.end)
    said: Quantity = piece.value
    if said.indefinite or (words[piece.end - 1].is_digits and _goes_on(words, piece.end, last)):
        return None
    return _Number(float(said.value), piece.end, said.hedges)


def _goes_on(words: tuple[Word, ...], place: int, last: int) -> bool:
    """Whether a number is typed on in another shape: "8:30", "3.1.2", "2026/03"."""
    return (
        place + 1 < last
        and words[place].glued
        and words[place].text in ":/.,"
        and words[place + 1].glued
        and words[place + 1].is_digits
    )
