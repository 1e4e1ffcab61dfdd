"""How long is waited between two of several: "two coats, leaving four hours between coats" are so long apart.

So are turns of which each is so long: "three times, five minutes per rinse" is five minutes each.
"""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span, blanked
from fuzzytime.language.meaning.expressions import Duration

OWNING = frozenset({"'s", "’s", "'", "’"})

APART, EACH_ONE = "apart", "each"
"""What is said instead, which is shorter."""


def with_gaps(scanned: Scanned) -> str:
    """Give a text of the same length in which gaps are so long "apart", and turns so long "each"."""
    text = scanned.text
    if not {"between", *scanned.lexicon.closed.rates}.isdisjoint(word.text for word in scanned.words):
        for before, (first, end), said in _gaps(scanned):
            text = text[:first] + said.rjust(end - first) + text[end:]
            text = blanked(text, [before])
    return text


def _gaps(scanned: Scanned) -> Iterator[tuple[Span, Span, str]]:
    """Give for each gap the words before its length that say no more, those behind it, and what they mean."""
    lexicon = scanned.lexicon
    words = scanned.words
    lengths = [piece for piece in scanned.pieces("duration") if isinstance(piece.value, Duration)]
    whole = {piece.end: piece for piece in sorted(lengths, key=lambda piece: -piece.start)}
    for piece in whole.values():
        place = piece.end
        while place < len(words) and words[place].text in OWNING | lexicon.spacing["nouns"]:
            place += 1
        if place >= len(words):
            continue
        first = words[piece.end].start
        if words[place].text == "between":
            end, led = _end(words, place + 1, lexicon), _led(words, piece.start, lexicon)
            if end is not None and led is not None:
                yield (words[led].start, words[piece.start].start), (first, words[end - 1].end), APART
        elif words[place].text in lexicon.closed.rates and place + 1 < len(words) and place == piece.end:
            turn = words[place + 1].text
            if turn in lexicon.spacing["turns"] and _ends(words, place + 2, lexicon):
                yield (first, first), (first, words[place + 1].end), EACH_ONE


def _end(words: Sequence[Word], place: int, lexicon: Lexicon) -> int | None:
    """Give where the name of what is between ends: "coats", "each coat", "them"."""
    closed = lexicon.closed
    each = place < len(words) and words[place].text in closed.each_of_several
    behind = place + each
    if each and behind < len(words) and words[behind].text in closed.each_of_several:
        behind += 1
    if behind >= len(words) or not words[behind].is_letters or not _ends(words, behind + 1, lexicon):
        return None
    text = words[behind].text
    return behind + 1 if each or text in lexicon.beside.behind_gaps or text.endswith("s") else None


def _ends(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    return place >= len(words) or words[place].text in lexicon.closed.end_of_a_gap


def _led(words: Sequence[Word], place: int, lexicon: Lexicon) -> int | None:
    """Give where the words begin that lead to a gap: ", leaving", "with"; None where an order begins."""
    closed = lexicon.closed
    first = place
    while first and words[first - 1].text in lexicon.spacing["leading"]:
        first -= 1
    joined = first > 0 and (
        words[first - 1].text in closed.joints_of_clauses or words[first].text in lexicon.spacing["beside"]
    )
    if first and words[first - 1].text in closed.joints_of_clauses - {","} and first < place:
        first -= 1
    return first if joined else None
