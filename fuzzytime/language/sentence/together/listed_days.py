"""Days that head a list hold for its entries, also behind a stop: "fri: dentist 9am; bank 11am"."""

from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.sentence.sketches.sketch import Sketch

STOP = ";"
"""The end of an entry of a list."""

HEADS = ":"
"""What stands behind a day that heads a list."""


def listed_below_day(first: Sketch, sketch: Sketch, between: str, text: str) -> bool:
    """Whether an entry is in the list that a day heads, or in one whose entries begin with their hours."""
    day = next(iter(first.phrases), None)
    if between.strip() != STOP or day is None or text[: day.span[0]].strip():
        return False
    time = day.said.time
    if not isinstance(time, Wall) or time.days is None:
        return False
    named, _, behind = text[slice(*day.span)].partition(HEADS)
    if text[day.span[1] :].lstrip().startswith(HEADS) or (behind and named.strip().isalpha()):
        return True
    hour = next(iter(sketch.phrases), None)
    if hour is None or hour.span[0] != sketch.part.segment.span[0] or time.clock is None:
        return False
    said = hour.said.time
    return isinstance(said, Wall) and said.clock is not None and said.days is None
