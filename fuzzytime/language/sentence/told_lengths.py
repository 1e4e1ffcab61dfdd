"""Lengths told in words of their own: "ten minutes should do", "allow an hour", "it's 20 minutes away".

They stand beside what they are about, or on a line of their own, and are read as asides are.
"""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.meaning.expressions import Duration, Phrase, Said
from fuzzytime.language.sentence.asides import Aside
from fuzzytime.requirement import Constraint

RULE = "told"
"""The rule of a length that is told."""

MARKS = frozenset({",", "(", ")", "-", ".", ";", ":", "!", "–", "—"})
JOINTS = frozenset({"and", "but", "so"})
"""What stands around such words."""

SUBJECTS = frozenset(
    [
        "it",
        "it's",
        "its",
        "it’s",
        "that",
        "that's",
        "that’s",
        "this",
        "which",
        "they",
        "they're",
        "there",
        "it'll",
    ]
)
DETERMINERS = frozenset({"the", "my", "our", "your", "a", "an"})
COPULAS = frozenset({"it's", "it’s", "its", "that's", "that’s", "they're", "is", "are", "'s", "be"})
TAKING = frozenset({"takes", "take", "lasts", "is", "took", "taking"})
SMALL = frozenset(
    {"a", "an", "only", "just", "about", "me", "us", "you", "will", "would", "should", "around"}
)
GOING = frozenset(
    ["drive", "walk", "ride", "journey", "trip", "way", "commute", "getting", "driving", "cycling"]
)
THERE = frozenset({"there", "over", "home", "back", "here"})
BY = frozenset({"by", "on"})
VEHICLES = frozenset(
    ["car", "bus", "bike", "train", "tram", "taxi", "foot", "tube", "metro", "ferry", "boat", "plane"]
)

HELPING = frozenset(
    {"should", "will", "would", "is", "are", "must", "might", "'ll", "be", "more", "than", "probably"}
)
ENOUGH = frozenset({"do", "enough", "plenty", "fine", "sufficient", "suffice", "ample"})
ALLOWING = (
    ["allow"],
    ["reckon"],
    ["budget"],
    ["estimate"],
    ["give", "it"],
    ["give", "them"],
    ["they", "get"],
    ["it", "gets"],
)
FOR_IT = frozenset({"for", "it", "that", "this", "them", "each"})


def told_lengths(scanned: Scanned) -> tuple[Aside, ...]:
    """Give the lengths that a text tells in words of their own, in order."""
    found: list[Aside] = []
    pieces = sorted(scanned.pieces("duration"), key=lambda piece: (piece.start, -piece.end))
    for piece in pieces:
        aside = _told(scanned, piece)
        if aside is not None and not any(aside.span[0] < other.span[1] for other in found):
            found.append(aside)
    return tuple(found)


def _told(scanned: Scanned, piece: Piece) -> Aside | None:
    words, texts = scanned.words, [word.text for word in scanned.words]
    if not isinstance(piece.value, Duration):
        return None
    start = piece.start
    while start > 0 and texts[start - 1] not in MARKS | JOINTS:
        start -= 1
    end = piece.end
    while end < len(texts) and texts[end] not in MARKS | JOINTS:
        end += 1
    before, after = texts[start : piece.start], texts[piece.end : end]
    way = _is_way(before, after, alone=start == 0)
    if not way and not _is_length(before, after):
        return None
    if end < len(texts) and texts[end] == ")":
        end += 1
    first = words[start - 1 if start > 0 and texts[start - 1] in MARKS - {".", "!"} else start].start
    span = (words[piece.start].start, words[piece.end - 1].end)
    return Aside(
        (first, words[end - 1].end),
        Phrase(Said(piece.value, Constraint.FOR), piece.start, piece.end, span, RULE),
        way=way,
    )


def _is_way(before: Sequence[str], after: Sequence[str], *, alone: bool) -> bool:
    """Whether words say how far it is: "it's 20 minutes away", "the drive takes half an hour"."""
    said = [word for word in before if word not in SMALL]
    rest = after[1:] if after[:1] in (["'s"], ["’s"]) else after
    goes = (
        rest[:1] == ["away"]
        or (rest[:1] and rest[0] in GOING)
        or (rest[:1] and rest[0] in BY and VEHICLES & set(rest))
    )
    if goes:
        called = not said and not alone
        return called or bool(said and said[-1] in COPULAS and said[0] in SUBJECTS | DETERMINERS)
    if len(said) > 1 and said[-1] in TAKING and not after:
        # "The drive takes half an hour", "getting there takes ten minutes"
        named = [word for word in said[:-1] if word not in THERE | DETERMINERS]
        return len(named) == 1 and named[0] in GOING
    to_there = len(after) > 2 and after[0] == "to" and after[-1] in THERE
    return to_there and len(said) > 1 and said[0] in SUBJECTS and said[-1] in TAKING


def _is_length(before: Sequence[str], after: Sequence[str]) -> bool:
    """Whether words say how long something takes: "ten minutes should do", "allow an hour for it"."""
    if not before:
        return len(after) > 1 and after[-1] in ENOUGH and HELPING.issuperset(after[:-1])
    said = [word for word in before if word not in SMALL]
    return said in ALLOWING and FOR_IT.issuperset(after)
