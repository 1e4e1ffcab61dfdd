"""The edges of what goes on: "by the end of the lesson", "between the meeting and three"."""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.words import Word
from fuzzytime.requirement import Edge

LONGEST_EDGE = 4
"""Words of "the very end of"."""

OF_EDGES = {
    "by": dict.fromkeys(Edge, "by the time"),
    "at": {Edge.START: "while", Edge.END: "after"},
    "on": {Edge.START: "while", Edge.END: "after"},
    "from": dict.fromkeys(Edge, "after"),
}
"""Prepositions that begin a clause before an edge of what goes on, and which kind."""


LONGEST_EVENT = 5
"""Words of the name of an event, at most: "the knocking-off time"."""

AS_LONG = ("as", "long", "as")

BY = ("by",)

INSTEAD = ("after  ", "by ")
"""What is said instead, as long as "between" and "and" are."""

BARE = "b4 "
"""The second of both before what has no article: "by swimming" would be how."""


def edge_of(
    words: Sequence[Word], place: int, covered: AbstractSet[int], lexicon: Lexicon
) -> tuple[Edge, int] | None:
    """Give which edge of an event words name, and where the event begins: "the end of the lesson"."""
    texts = [word.text for word in words[place : place + LONGEST_EDGE]]
    said = [text for text in texts if text not in {"the", "very"}][:2]
    edge = _edge(said[0], lexicon) if said[1:] == ["of"] else None
    behind = place + texts.index("of") + 1 if edge is not None else 0
    return (edge, behind) if edge and behind < len(words) and behind not in covered else None


def _edge(word: str, lexicon: Lexicon) -> Edge | None:
    if word in lexicon.beside.starts:
        return Edge.START
    return Edge.END if word in lexicon.beside.ends else None


def is_event(
    words: Sequence[Word], first: int, end: int, covered: AbstractSet[int], lexicon: Lexicon
) -> bool:
    """Whether the name of what has a time stands at a place: "by the meeting"; but "go by train"."""
    closed = lexicon.closed
    # "By kick-off"; but "stand by the bell" is where
    moment = (longest_match(words, first, lexicon.moments) if first < end else None) or ("the",)
    over = first + len(moment)
    if moment[0] != "the" and first not in covered and (over >= end or over in covered):
        return True
    eventful = lexicon.happening | lexicon.taken | {"time"}
    named = eventful - lexicon.travelling
    for place in range(first, min(end, first + LONGEST_EVENT)):
        text = words[place].text
        if place in covered or (text in lexicon.function_words and text not in closed.noun_openers):
            return False
        # "By the party" is no way to travel.
        owned = (
            place > first
            and words[place - 1].text in closed.noun_openers
            and text in eventful & lexicon.events
        )
        if (text in named or owned) and (place + 1 >= end or place + 1 in covered):
            return place > first and words[place - 1].text not in lexicon.beside.no_event
    return False


def is_length(form: tuple[str, ...], words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a marker is a part of a length: "half as long as you cooked it"."""
    return form == AS_LONG and place > 0 and words[place - 1].text in lexicon.beside.as_long_as


def said_apart(scanned: Scanned) -> str:
    """Give a text of the same length that says on which side of either end something is."""
    text = scanned.text
    for first, joint, before in _betweens(scanned):
        for (start, end), word in zip((first, joint), (INSTEAD[0], before), strict=True):
            text = text[:start] + word + text[end:]
    return text


def _betweens(scanned: Scanned) -> Iterator[tuple[tuple[int, int], tuple[int, int], str]]:
    """Give the places of "between" and its "and", where one of them is an event and both have a time.

    With them stands what is said instead of the "and".
    """
    words, lexicon = scanned.words, scanned.lexicon
    for place, word in enumerate(words):
        if word.text != "between":
            continue
        behind = range(place + 2, min(place + 2 + LONGEST_EVENT, len(words) - 1))
        joint = next((p for p in behind if words[p].text == "and"), None)
        if joint is None:
            continue
        ends = range(joint + 2, min(joint + 2 + LONGEST_EVENT, len(words) + 1))
        event = is_event(words, place + 1, joint, frozenset(), lexicon)
        # "Between two and four call mum": what a clock time or a day begins is no event.
        other = any(is_event(words, joint + 1, end, frozenset(), lexicon) for end in ends)
        own = [p for p in scanned.pieces("wall") if _is_own(p)] + scanned.pieces("minutes past")
        other = other and not any(piece.start == joint + 1 for piece in own)
        bare = _is_bare(words, joint + 1, lexicon)
        known = event or other or bare
        walls = {(piece.start, piece.end) for piece in scanned.pieces("wall")} if known else set()
        timed = (place + 1, joint) in walls, any(start == joint + 1 for start, _ in walls)
        if not (all(timed) or (place and words[place - 1].text in lexicon.measure_verbs)):
            # "Between soundcheck and doors"; but "choose between football and swimming"
            event = event or (joint == place + 2 and _is_bare(words, place + 1, lexicon))
        first = event or timed[0] or (place + 2, joint) in walls
        if (event or other) and first and (other or timed[1] or bare):
            spans = (word.start, word.end), (words[joint].start, words[joint].end)
            yield *spans, INSTEAD[1] if other or timed[1] else BARE


def _is_bare(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether what has a time stands there in one word: "yoga", "doors"."""
    apart = place + 1 >= len(words) or not words[place + 1].is_letters or words[place + 1].glued
    apart = apart or words[place + 1].text in lexicon.function_words
    return apart and words[place].text in (lexicon.happening | lexicon.taken) - lexicon.travelling


def _is_own(piece: Piece) -> bool:
    """Whether it is a clock time or a day, without an article that may open an event's name."""
    return piece.value.clock is not None or piece.value.days is not None
