"""The edges of what goes on: "by the end of the lesson", "at the start of every shift"."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
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


BY = ("by",)

LONGEST_EVENT = 5
"""Words of the name of an event, at most: "the knocking-off time"."""

AS_LONG = ("as", "long", "as")


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
