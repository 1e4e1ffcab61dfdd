"""Whether "now" only says that a time is a new one: "the meeting is now at three"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings

POINTS = frozenset({"at", "on", "@"})
"""What may lead to the new time."""


def tells_new_time(piece: Piece, around: Surroundings) -> bool:
    """Whether the new time stands behind it, or what something does then: "practice now starts at six".

    "Call me now, on friday call Ann" are two, and "now starts the oven" begins with it.
    """
    if around.texts[piece.start : piece.end] != ["now"] or not piece.start:
        return False
    if around.follower(piece) in around.lexicon.doing.timed:
        return True
    place = piece.end + (around.follower(piece) in POINTS)
    place += around.texts[place : place + 1] == ["the"]
    day = around.is_day(place) or around.is_day_from_now(place) or around.is_part(place)
    return place < len(around.texts) and (day or around.is_number(place))
