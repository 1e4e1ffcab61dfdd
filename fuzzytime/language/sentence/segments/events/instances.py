"""Several of one kind, each with its own time: "set two alarms, one for 6.45 and the other for 7".

What counts them is read as if it were not there, and each is an instruction of its own.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.understood.lists import lists_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span, blanked

MARKS = frozenset({",", ":", "-", "–", "—", ";", "("})
"""What stands before the first of several."""

ONE = ("one",)
TWO = 2


@dataclass(frozen=True, slots=True)
class Instances:
    """Where each of several begins, as characters, and the stretches that only count them.

    ``counted`` is the word behind their number, where that is said too: "two alarms", ``joints`` are words
    that join them.
    """

    starts: tuple[int, ...] = ()
    counting: tuple[Span, ...] = ()
    counted: str | None = None
    joints: tuple[Word, ...] = ()


NONE = Instances()


def instances_of(scanned: Scanned, grammar: Grammar) -> tuple[Scanned, Instances]:
    """Give a text without the words that tell several of one kind apart, each of which has a time."""
    counts = list(_counts_of_lists(scanned))
    if counts:
        scanned = Scanned.of(blanked(scanned.text, counts), grammar, scanned.lexicon, hours=scanned.hours)
    found = _marked(scanned)
    if len(found.starts) < 2 or _begins_alone(scanned, found):
        return scanned, NONE
    bare = Scanned.of(blanked(scanned.text, found.counting), grammar, scanned.lexicon, hours=scanned.hours)
    begins = [next((word.start for word in bare.words if word.start >= start), -1) for start in found.starts]
    if any(sum(first <= begin < end for begin in begins) > 1 for first, end in _spans(bare)):
        # "Once before noon and once after four" is no stretch between them.
        apart = bare.text
        for joint in found.joints:
            apart = apart[: joint.start] + ",".ljust(joint.end - joint.start) + apart[joint.end :]
        bare = Scanned.of(apart, grammar, scanned.lexicon, hours=scanned.hours)
    times = _spans(bare)
    # "Two visits today, one at nine": the first may have its day in front.
    timed = [any(first <= begin < end for first, end in times) for begin in begins]
    return (bare, found) if all(timed) else (scanned, NONE)


def _spans(scanned: Scanned) -> list[Span]:
    """Give where times stand."""
    return [phrase.span for phrase in phrases_of(scanned)]


def _counts_of_lists(scanned: Scanned) -> Iterator[Span]:
    """Give the words that say how many times stand behind them: "twice, at noon and at five"."""
    words, pieces = scanned.words, scanned.pieces("times")
    phrases = phrases_of(scanned) if pieces else ()
    listed = {times.members[0].first: times for times in lists_of(phrases, words, scanned.lexicon)}
    whole = {phrase.first: phrase.end for phrase in phrases}
    for piece in pieces:
        # "Twice tomorrow, at eight and six"
        end = whole.get(piece.start, piece.end)
        times = listed.get(end + (end < len(words) and words[end].text in MARKS))
        if times is not None and not times.either and len(times.members) == piece.value:
            yield words[piece.start].start, words[piece.end - 1].end


def _begins_alone(scanned: Scanned, found: Instances) -> bool:
    """Whether the first of several has its time before: "take one now, one at lunch and one at night"."""
    first = found.counting[0][0]
    ones = [word.end for word in scanned.words if word.end <= first and word.text in ONE]
    ends = [phrase.span for phrase in phrases_of(scanned)]
    return bool(ones) and any(ones[-1] < start and end == first for start, end in ends)


def _marked(scanned: Scanned) -> Instances:
    """Give where several of one kind are told apart: "…, one …, the other …"."""
    lexicon = scanned.lexicon
    words = scanned.words
    starts: list[int] = []
    counting: list[Span] = []
    joints: list[Word] = []
    for place in range(1, len(words)):
        before = words[place - 1]
        named = lexicon.instances["further" if starts else "first"]
        form = longest_match(words, place, named)
        # "Two alarms for tomorrow one at six and one at seven", as it is said
        told = bool(starts) or _has_number(words, place, lexicon)
        spoken = form == ONE and _times_behind(words, place) and told
        if (
            before.text not in (MARKS | lexicon.closed.joints_of_instances if starts else MARKS)
            and not spoken
        ):
            continue
        behind = place if form is None else place + len(form)
        # "The first | one" is marked already.
        inside = bool(starts) and words[place].start < starts[-1]
        if form is None or inside or behind >= len(words):
            continue
        starts.append(words[behind - 1].end)
        joints += [before] if len(starts) > 1 and before.text in lexicon.closed.additions else []
        marked = len(starts) == 1 and not spoken
        counting.append((before.start if marked else words[place].start, words[behind - 1].end))
    if len(starts) == TWO:
        # "Walk the dog twice, once at eight and once at four"
        counting += [(w.start, w.end) for w in words if w.text == "twice" and w.end <= counting[0][0]]
    number = next(_counts(words, counting, lexicon), None) if len(starts) > 1 else None
    counted = None
    if number is not None and lexicon.numbers.get(number.text, number.text) in {
        len(starts),
        str(len(starts)),
    }:
        counting.append((number.start, number.end))
        counted = _behind(scanned, number)
    return Instances(tuple(starts), tuple(counting), counted, tuple(joints))


def _times_behind(words: Sequence[Word], place: int) -> bool:
    """Whether a preposition of times stands behind a word."""
    return place + 1 < len(words) and words[place + 1].text in {"at", "for", "on"}


def _has_number(words: Sequence[Word], end: int, lexicon: Lexicon) -> bool:
    """Whether a number, and a word that it counts, stand before a place."""
    numbers = (words[place].text for place in range(end - 1) if words[place + 1].text.endswith("s"))
    return any(lexicon.numbers.get(text, 0) >= TWO for text in numbers)


def _counts(words: Sequence[Word], counting: Sequence[Span], lexicon: Lexicon) -> Iterator[Word]:
    """Give the numbers before the first of several: "two alarms"."""
    for word in words:
        if word.start < counting[0][0] and (word.text in lexicon.numbers or word.is_digits):
            yield word


def _behind(scanned: Scanned, number: Word) -> str:
    """Give the word behind a number, as typed."""
    counted = next(word for word in scanned.words if word.start >= number.end)
    return scanned.text[counted.start : counted.end]
