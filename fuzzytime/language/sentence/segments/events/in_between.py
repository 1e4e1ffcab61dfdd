"""Between what has a time and another time: "between the meeting and three" is after the one, by the other.

Two times are a range, which the grammar reads; an event's time is that of another instruction.
"""

from collections.abc import Iterator

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.sentence.segments.events.event_edges import LONGEST_EVENT, is_event

AFTER, BY = "after  ", "by "
"""What is said instead, as long as "between" and "and" are."""


def said_apart(scanned: Scanned) -> str:
    """Give a text of the same length that says on which side of either end something is."""
    text = scanned.text
    for first, joint in _betweens(scanned):
        for (start, end), word in ((first, AFTER), (joint, BY)):
            text = text[:start] + word + text[end:]
    return text


def _betweens(scanned: Scanned) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """Give the places of "between" and its "and", where one of them is an event and both have a time."""
    words = scanned.words
    for place, word in enumerate(words):
        if word.text != "between":
            continue
        behind = range(place + 2, min(place + 2 + LONGEST_EVENT, len(words) - 1))
        joint = next((p for p in behind if words[p].text == "and"), None)
        if joint is None:
            continue
        ends = range(joint + 2, min(joint + 2 + LONGEST_EVENT, len(words) + 1))
        event = is_event(words, place + 1, joint, frozenset(), scanned.lexicon)
        # "Between two and four call mum": what a clock time or a day begins is no event.
        other = any(is_event(words, joint + 1, end, frozenset(), scanned.lexicon) for end in ends)
        own = [p for p in scanned.pieces("wall") if _is_own(p)] + scanned.pieces("minutes past")
        other = other and not any(piece.start == joint + 1 for piece in own)
        walls = {(piece.start, piece.end) for piece in scanned.pieces("wall")} if event or other else set()
        first = event or (place + 1, joint) in walls or (place + 2, joint) in walls
        last = other or any(start == joint + 1 for start, _ in walls)
        if (event or other) and first and last:
            yield (word.start, word.end), (words[joint].start, words[joint].end)


def _is_own(piece: Piece) -> bool:
    """Whether it is a clock time or a day, without an article that may open an event's name."""
    return piece.value.clock is not None or piece.value.days is not None
