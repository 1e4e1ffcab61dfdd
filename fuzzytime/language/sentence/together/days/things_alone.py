"""Things that a list under a day names, or that stand beside when: what is done then: "today: bins, post"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.together.days.listed_days import heads_list
from fuzzytime.language.sentence.verbs.without_verbs.named_alone import named_alone


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
