"""Days that head a list hold for its entries, also behind a stop: "fri: dentist 9am; bank 11am"."""

from fuzzytime.language.meaning.expressions import Repeat
from fuzzytime.language.sentence.sketches.sketch import Sketch

STOP = ";"
"""The end of an entry of a list."""

COLON = ":"
HEADS = (":", "- ", "– ", "— ")
"""What stands behind a day that heads a list."""


def heads_list(first: Sketch, text: str) -> bool:
    """Whether a text begins with a day, or a repetition, and a mark behind which a list may begin."""
    day = next(iter(first.phrases), None)
    if day is None or text[: day.span[0]].strip():
        return False
    if not isinstance(day.said.time, Repeat) and day.said.wall.days is None:
        return False
    named, _, behind = text[slice(*day.span)].partition(COLON)
    return text[day.span[1] :].lstrip().startswith(HEADS) or (bool(behind) and named.strip().isalpha())


def listed_below_day(first: Sketch, sketch: Sketch, between: str, text: str) -> bool:
    """Whether an entry is in the list that a day heads, or in one whose entries begin with their hours."""
    day = next(iter(first.phrases), None)
    if between.strip() != STOP or day is None or text[: day.span[0]].strip():
        return False
    if heads_list(first, text):
        return True
    if day.said.wall.days is None or day.said.wall.clock is None:
        return False
    hour = next(iter(sketch.phrases), None)
    if hour is None or hour.span[0] != sketch.part.segment.span[0]:
        return False
    return hour.said.wall.clock is not None and hour.said.wall.days is None
