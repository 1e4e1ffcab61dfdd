"""Days that head a list hold for its entries and what is named alone: "fri: dentist 9am; bank 11am"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Span, overlap
from fuzzytime.language.meaning.expressions import Repeat
from fuzzytime.language.sentence.references.meals import names_meal
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, are_steps
from fuzzytime.language.sentence.trees.tags import FINITE
from fuzzytime.language.sentence.verbs.without_verbs.happenings import is_typed
from fuzzytime.language.sentence.verbs.without_verbs.named_alone import named_alone

HEADS = (":", "- ", "– ", "— ")
"""What stands behind a day that heads a list."""


def heads_list(first: Sketch, text: str) -> bool:
    """Whether a sentence begins with a day, a part of one or a repetition, and the mark of a list."""
    day = next(iter(first.phrases), None)
    before = "" if day is None else text[: day.span[0]].rstrip()
    if day is None or (before and before[-1] not in ENDS):
        return False
    part, marked = day.said.wall.part, text[day.span[1] :].lstrip()
    if not isinstance(day.said.time, Repeat) and day.said.wall.days is None:
        # "Morning: feed the hens"; but "Lunch: soup"
        return part is not None and not part.meal and day.said.is_day and marked.startswith(":")
    named, _, behind = text[slice(*day.span)].partition(":")
    return marked.startswith(HEADS) or (bool(behind) and named.strip().isalpha())


def listed_below_day(first: Sketch, sketch: Sketch, between: str, text: str) -> bool:
    """Whether an entry is in the list that a day heads, or in one whose entries begin with their hours."""
    day = next(iter(first.phrases), None)
    if between.strip() != ";" or day is None or text[: day.span[0]].strip():
        return False
    if day.said.wall.days is None or day.said.wall.clock is None:
        return False
    hour = next(iter(sketch.phrases), None)
    if hour is None or hour.span[0] != sketch.part.segment.span[0]:
        return False
    return hour.said.wall.clock is not None and hour.said.wall.days is None


def things_alone(sketches: Sequence[Sketch], draft: Draft, apart: str, *, headed: bool) -> list[Sketch]:
    """Give what is named, and no verb is understood, its place among what is to be done.

    It stands beside a time or a clause, in a list with a head (``headed`` by a line above), or goes on with
    what is named before it: "half an hour of piano, then tea"; or beside its hour on a line among such;
    or on the way, or first or last of all: "gym on the way home". In the text with its stops they are
    ``apart``.
    """
    text = draft.text
    listed = headed or bool(sketches and heads_list(sketches[0], text))
    found: list[Sketch] = []
    # "Homework first, then half an hour of tv"
    led = [sketch.part.segment.connective == "then" for sketch in sketches[:2]] == [False, True]
    for sketch in sketches:
        then = sketch.part.segment.connective == "then"
        leads = led and not found and not any(node.tag in FINITE for node in sketch.part.tree.nodes)
        chained = leads or (bool(found) and _is_named(found[-1]))
        chained = leads or (chained and (then or are_steps(found[-1], sketch, text, apart)))
        # "Mrs Patel at ten, the twins at half ten"
        chained = chained or sketch.part.segment.entry
        orders = [span for span, _ in draft.orders if overlap(span, sketch.part.segment.span)]
        ways, nodes = sketch.lexicon.closed.ways, sketch.part.tree.nodes
        # "Gym on the way home"; but "in the way"
        placed = bool(orders) or any(node.lower in ways and nodes[0].tag != "IN" for node in nodes)
        named = sketch.operation is None and (listed or chained or placed or sketch.heard or _is_had(sketch))
        # "The half" at 18:25, "me out" from four to five
        entry = draft.listed and any(map(is_typed, sketch.phrases))
        found.append(_to_be_done(sketch, orders, chained=chained, entry=entry) if named else sketch)
    return found


def _is_had(sketch: Sketch) -> bool:
    """Whether it is a meal with where, with whom or how late it is: "lunch in town"; but "packed lunch"."""
    tree, root, beside = sketch.part.tree, sketch.part.tree.root, sketch.lexicon.beside
    meal = tree.nodes[root].lower if tree.nodes else ""
    behind, before = tree.said(range(root + 1, len(tree.nodes))[:1]), tree.said(range(root))
    placed = bool(behind) and behind <= beside.whereabouts | {"with"}
    had = placed or (not behind and bool(before) and before <= beside.how_late)
    return had and meal in sketch.lexicon.happening and names_meal(meal, sketch.lexicon)


def _is_named(sketch: Sketch) -> bool:
    """Whether it is only named, and no verb says what is done with a thing, or where."""
    operation = sketch.operation
    return operation is not None and operation.name in {operation.verb, operation.phrase}


def _to_be_done(sketch: Sketch, orders: Sequence[Span], *, chained: bool, entry: bool) -> Sketch:
    """Give what is named alone, beside its time or without, as what is to be done."""
    tree, offset = sketch.part.tree, sketch.part.offset
    if not tree.nodes:
        return sketch
    spans = [(first - offset, end - offset) for first, end in (*sketch.heard, *sketch.joints, *orders)]
    heard = {place for span in spans for place in tree.at(*span)}
    operation = named_alone(tree, heard, chained=chained, entry=entry)
    return sketch if operation is None else replace(sketch, operation=operation.moved(offset))
