"""Which stretches of a text are times: the chart's readings, sifted and chosen.

A reading is refused where its words are no sure time: a number that counts something ("by 10", beside
"volume"), a word with another meaning ("March the troops", "second drawer"). Of what is left, the stretches
are chosen that together explain most words in the fewest pieces.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from fuzzytime.language.grammar.chart import Cell, Grammar, Piece
from fuzzytime.language.grammar.judging.judging import Judge
from fuzzytime.language.grammar.judging.run_on_hours import typed_apart
from fuzzytime.language.grammar.judging.walls.dated_entries import beside_name, sure_in_front
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.numerals import numeral_pieces
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.grammar.timetables import holds_stretch
from fuzzytime.language.grammar.typed_words import as_meant, with_marks
from fuzzytime.language.grammar.understood.due import due_then
from fuzzytime.language.grammar.understood.lending import (
    appointed,
    in_half,
    in_minutes,
    in_unit,
    is_moved,
    moved_to,
    one_by_one,
)
from fuzzytime.language.grammar.understood.minutes_of_steps import with_units
from fuzzytime.language.grammar.understood.typed_hours import (
    clock_of_alarm,
    going_on,
    gone_by,
    lasting_on_day,
)
from fuzzytime.language.grammar.understood.waited import waited
from fuzzytime.language.grammar.words import Word, quotes_in, words_of
from fuzzytime.language.meaning.expressions import Phrase

WIDTH = 0.35
"""What each piece costs: two neighbours are worth less than one piece over the same words."""

COMMA = -0.05
"""What a comma inside a piece is worth, where a word is worth 1: of two ways to join, it is the looser."""


ROUNDS = 6
"""How often the best pieces are chosen anew because the judge refused some of them."""


UNDERSTOOD = (
    in_minutes,
    lasting_on_day,
    going_on,
    clock_of_alarm,
    gone_by,
    due_then,
    waited,
    moved_to,
    appointed,
)
"""What gives a time as it is understood by what stands around it, in the order of their reading."""

REMEMBERED = 64
"""Texts that are kept as they were scanned: one is looked at for all that it may be. They may be long."""


@dataclass(frozen=True, slots=True, eq=False)
class Scanned:
    """A text's words, everything the grammar finds in them, and what stands around each of them.

    At each of the places of ``hours`` stands a space or a point that is read as the mark of an hour. It is
    ``measured`` where lines beside it say how long something goes on.
    """

    text: str
    words: tuple[Word, ...]
    cells: list[Cell]
    around: Surroundings = field(repr=False)
    hours: frozenset[int] = frozenset()
    measured: bool = False

    @classmethod
    def of(
        cls,
        text: str,
        grammar: Grammar,
        lexicon: Lexicon,
        *,
        hours: frozenset[int] = frozenset(),
        measured: bool = False,
    ) -> "Scanned":
        """Apply a grammar, which gets no more rules, to a text."""
        return _scanned(text, grammar, lexicon, hours, measured=measured)

    @property
    def lexicon(self) -> Lexicon:
        """The tables that its words were looked up in."""
        return self.around.lexicon

    def pieces(self, category: str) -> list[Piece]:
        """Give all pieces of a category, by their start."""
        return [piece for cell in self.cells if category in cell for piece in cell[category].values()]


@lru_cache(maxsize=REMEMBERED)
def _scanned(
    text: str, grammar: Grammar, lexicon: Lexicon, hours: frozenset[int], *, measured: bool
) -> Scanned:
    typed = typed_apart(with_marks(_with_quotes(text, grammar, lexicon), hours))
    words = tuple(with_units(as_meant(typed, lexicon), lexicon, measured=measured))
    around = Surroundings(words, lexicon)
    lexical = {
        start: [*numeral_pieces(words, start, lexicon), *around.pieces(start)] for start in range(len(words))
    }
    return Scanned(text, words, grammar.parse(words, lexical), around, hours, measured)


def _with_quotes(text: str, grammar: Grammar, lexicon: Lexicon) -> list[Word]:
    """Cut a text into words; what is quoted is one, as no word in it is a time of what is asked for.

    Only where it is nothing but a bound time it may be one, if nothing is written: feed the cat "at six".
    """
    words = list(words_of(text))
    written = lexicon.no_times.writing | lexicon.no_times.sending | lexicon.doing.saying
    for start, end in quotes_in(text):
        free = written.isdisjoint(word.text for word in words if word.end <= start)
        if free and _is_time(text[start + 1 : end - 1], grammar, lexicon):
            continue
        inside = [place for place, word in enumerate(words) if start <= word.start < end]
        said = Word(text[start:end].lower(), start, end, words[inside[0]].glued)
        words[inside[0] : inside[-1] + 1] = [said]
    return words


def _is_time(text: str, grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether a text is a time with its preposition, from its first word to its last."""
    scanned = Scanned.of(text, grammar, lexicon)
    bound = [phrase for phrase in phrases_of(scanned) if phrase.said.preposition is not None]
    return [(phrase.first, phrase.end) for phrase in bound] == [(0, len(scanned.words))]


@lru_cache(maxsize=REMEMBERED)
def phrases_of(scanned: Scanned) -> tuple[Phrase, ...]:
    """Choose the times of a text."""
    lexicon, judge = scanned.lexicon, Judge(scanned.around)
    called = [
        piece
        for piece in scanned.pieces("called at")
        if (
            judge.walls.is_called(piece.start)
            or holds_stretch(scanned.words, piece.start, piece.end, lexicon)
            or is_moved(scanned.words, piece.start, piece.end, lexicon)
        )
        and not judge.borders.no_times.figures.hold(piece)
    ]
    # "She works three to five shifts"
    open_hours = (piece for piece in scanned.pieces("hours open") if judge.around.may_end(piece))
    called += [p for p in open_hours if judge.walls.is_open(p.start) or judge.walls.is_seen_to(p)]
    called += [piece for piece in scanned.pieces("so many each") if judge.lengths.counts_each(piece)]
    instead = {(piece.start, piece.end) for piece in called}
    said = [piece for piece in scanned.pieces("said") if (piece.start, piece.end) not in instead]
    chosen = _best_of(called, said, judge)
    chosen = judge.further.listed(chosen, scanned.cells)
    read = [_phrase(scanned, piece) for piece in sorted(chosen, key=lambda piece: piece.start)]
    found = [
        one
        for phrase in read
        for one in (one_by_one(phrase, scanned.words, lexicon) if phrase.said.listed else (phrase,))
    ]
    found = [beside_name(sure_in_front(one, scanned.words, lexicon), scanned.words, lexicon) for one in found]
    for place in range(1, len(found)):
        found[place] = in_unit(found[place], found[place - 1], scanned.words, lexicon)
    for understood in UNDERSTOOD:
        found = [understood(phrase, scanned.words, lexicon) for phrase in found]
    for place in range(len(found) - 2, -1, -1):
        found[place] = in_half(found[place], found[place + 1], scanned.words, lexicon)
    return tuple(found)


def _best_of(called: Sequence[Piece], said: Sequence[Piece], judge: Judge) -> list[Piece]:
    """Give the best pieces of those that are called and those said that the judge accepts.

    To judge costs more than to choose, and most pieces lie inside better ones: the best of all are chosen,
    and only those are judged, until none of them is refused. Where that goes on, all are judged.
    """
    words, left, accepted = judge.around.words, list(said), set(map(id, called))
    for _ in range(ROUNDS):
        chosen = _best([*called, *left], words)
        refused = {id(piece) for piece in chosen if id(piece) not in accepted and not judge.accepts(piece)}
        if not refused:
            return chosen
        accepted |= {id(piece) for piece in chosen if id(piece) not in refused}
        left = [piece for piece in left if id(piece) not in refused]
    kept = (piece for piece in left if id(piece) in accepted or judge.accepts(piece))
    return _best([*called, *kept], words)


def _best(pieces: Sequence[Piece], words: Sequence[Word]) -> list[Piece]:
    """Give the pieces that do not overlap and together have the highest worth."""
    length, upto = len(words), [0.0]
    for word in words:
        upto.append(upto[-1] + (COMMA if word.text == "," else 1.0))
    starting: dict[int, list[Piece]] = {}
    for piece in pieces:
        starting.setdefault(piece.start, []).append(piece)
    worth = [0.0] * (length + 1)
    chosen: list[Piece | None] = [None] * (length + 1)
    for start in range(length - 1, -1, -1):
        worth[start] = worth[start + 1]
        for piece in starting.get(start, ()):
            value = upto[piece.end] - upto[piece.start] - WIDTH + 0.1 * piece.weight + worth[piece.end]
            if value > worth[start]:
                worth[start], chosen[start] = value, piece
    found, at = [], 0
    while at < length:
        best = chosen[at]
        if best is None:
            at += 1
        else:
            found.append(best)
            at = best.end
    return found


def _phrase(scanned: Scanned, piece: Piece) -> Phrase:
    start, end = scanned.words[piece.start].start, scanned.words[piece.end - 1].end
    words = scanned.words[piece.start : piece.end]
    # The full stop of an abbreviation at the end of a sentence ends both.
    if words[-1].text == "." and len(words) > 1 and len(words[-2].text) > 1:
        end = words[-2].end
    return Phrase(piece.value, piece.start, piece.end, (start, end), piece.rule)
