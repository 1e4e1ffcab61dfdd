"""Names of files, sites and tags, typed without a space: "today.md", "bob@monday.com", "#friday"."""

from itertools import takewhile

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings

TAG, JOINT, DOT = "#", "_", "."
"""The mark before a tag, and those between words of a name that is typed in one."""


def is_typed_name(piece: Piece, around: Surroundings) -> bool:
    """Whether its last word is within a tag, or what has an ending, or is joined: "at_noon.sh"."""
    words, texts, last = around.words, around.texts, piece.end - 1
    first = next(place for place in range(last, -1, -1) if not words[place].glued)
    end = piece.end + sum(1 for _ in takewhile(lambda word: word.glued, words[piece.end :]))
    if texts[first] == TAG:
        # "Tag it #monday"; but "#5"
        return first + 1 < end and words[first + 1].is_letters
    dotted = (texts[place + 1] for place in range(last, end - 1) if texts[place] == DOT)
    return JOINT in texts[first:end] or not around.lexicon.no_times.file_endings.isdisjoint(dotted)
