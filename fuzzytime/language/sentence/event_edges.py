"""The edges of what goes on: "by the end of the lesson", "at the start of every shift"."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.words import Word
from fuzzytime.requirement import Edge

EDGES = {
    **dict.fromkeys(("start", "beginning", "opening", "outset"), Edge.START),
    **dict.fromkeys(("end", "close", "finish", "ending", "closing"), Edge.END),
}
"""Words for the edges of what goes on: "by the end of the lesson"."""

LONGEST_EDGE = 4
"""Words of "the very end of"."""

OF_EDGES = {
    "by": dict.fromkeys(Edge, "by the time"),
    "at": {Edge.START: "while", Edge.END: "after"},
    "on": {Edge.START: "while", Edge.END: "after"},
    "from": dict.fromkeys(Edge, "after"),
}
"""Prepositions that begin a clause before an edge of what goes on, and which kind."""


def edge_of(words: Sequence[Word], place: int, covered: AbstractSet[int]) -> tuple[Edge, int] | None:
    """Give which edge of an event words name, and where the event begins: "the end of the lesson"."""
    texts = [word.text for word in words[place : place + LONGEST_EDGE]]
    said = [text for text in texts if text not in {"the", "very"}][:2]
    edge = EDGES.get(said[0]) if said[1:] == ["of"] else None
    behind = place + texts.index("of") + 1 if edge is not None else 0
    return (edge, behind) if edge and behind < len(words) and behind not in covered else None
