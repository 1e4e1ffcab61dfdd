"""Days that head a list hold for its entries and what is named alone: "fri: dentist 9am; bank 11am"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.expressions import Repeat
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.verbs.without_verbs.named_alone import named_alone

HEADS = (":", "- ", "– ", "— ")
"""What stands behind a day that heads a list."""


def heads_list(first: Sketch, text: str) -> bool:
    """Whether a text begins with a day, or a repetition, and a mark behind which a list may begin."""
    day = next(iter(first.phrases), None)
    if day is None or text[: day.span[0]].strip():
        return False
    if not isinstance(day.said.time, Repeat) and day.said.wall.days is None:
        return False
    named, _, behind = text[slice(*day.span)].partition(":")
    return text[day.span[1] :].lstrip().startswith(HEADS) or (bool(behind) and named.strip().isalpha())


def listed_below_day(first: Sketch, sketch: Sketch, between: str, text: str) -> bool:
    """Whether an entry is in the list that a day heads, or in one whose entries begin with their hours."""
    day = next(iter(first.phrases), None)
    if between.strip() != ";" or day is None or text[: day.span[0]].strip():
        return False
    if heads_list(first, text):
        return True
    if day.said.wall.days is None or day.said.wall.clock is None:
        return False
    hour = next(iter(sketch.phrases), None)
    if hour is None or hour.span[0] != sketch.part.segment.span[0]:
        return False
    return hour.said.wall.clock is not None and hour.said.wall.days is None


def things_alone(sketches: Sequence[Sketch], text: str, *, headed: bool) -> list[Sketch]:
    """Give what is named, and no verb is understood, its place among what is to be done.

    It stands beside a time or a clause, or in a list with a head; ``headed`` by a line above.
    """
    listed = headed or bool(sketches and heads_list(sketches[0], text))
    return [_to_be_done(one) if one.operation is None and (listed or one.heard) else one for one in sketches]


def _to_be_done(sketch: Sketch) -> Sketch:
    """Give what is named alone, beside its time or without, as what is to be done."""
    tree, offset = sketch.part.tree, sketch.part.offset
    if not tree.nodes:
        return sketch
    spans = [(first - offset, end - offset) for first, end in sketch.heard]
    operation = named_alone(tree, {place for span in spans for place in tree.at(*span)})
    return sketch if operation is None else replace(sketch, operation=operation.moved(offset))
