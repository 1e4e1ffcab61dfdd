"""By when orders of a sentence are to be over, said as an order: "mow from two and be done by five"."""

from collections.abc import Sequence

from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.references.mentions import verb_forms
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import Reference


def done_by(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Give what is to be over by then that time as its end: nobody does two things who also has it done.

    "It" is what was named last; without it, all that the sentence asks for: "wash the car, hoover it and be
    finished by noon".
    """
    found: list[Sketch] = []
    for sketch in sketches:
        first = _first_ended(found, sketch, text)
        if first is None:
            found.append(sketch)
            continue
        ended = [one.also(*sketch.phrases, about=Reference.FINISH) for one in found[first:]]
        found[first:] = [*ended[:-1], ended[-1].reaching(sketch)]
    return found


def _first_ended(found: Sequence[Sketch], sketch: Sketch, text: str) -> int | None:
    """Give the place of the first that is to be over when a sketch says; None where it asks for something."""
    operation, tree = sketch.operation, sketch.part.tree
    if operation is None or not found or not sketch.asks or sketch.clauses or not sketch.times:
        return None
    # "Watch the rice, it should be done in ten minutes" is told of it.
    told = sketch.part.segment.connective == "then" or tree.children(tree.root, *SUBJECTS)
    named = (operation.object or "").lower()
    if _is_over(operation, sketch):
        # "…, all ready by noon"
        named = ""
    elif told or operation.place or operation.purpose or operation.due:
        return None
    if not sketch.lexicon.closed.anaphors | {""} >= {named}:
        return None
    first, behind = len(found), sketch
    ends = _is_end(operation, found[-1].operation, sketch)
    while ends and first and found[first - 1].asks and not (named and behind is not sketch):
        if ENDS & set(text_between(found[first - 1], behind, text)):
            break
        first -= 1
        behind = found[first]
    return first if first < len(found) else None


def _is_end(operation: Operation, before: Operation | None, sketch: Sketch) -> bool:
    """Whether an order says only that what stands before it is to be over: "finish", "have it loaded"."""
    so, lexicon = (operation.complement or "").lower(), sketch.lexicon
    ends = Reference(lexicon.indicators.get(operation.phrase, Reference.START)) is Reference.FINISH
    if _is_over(operation, sketch):
        return True
    if before is None or any(about is not Reference.FINISH and not ends for about in sketch.references):
        return False
    if so:
        return so in lexicon.beside.ended or so in verb_forms(before.lemma, lexicon)
    return ends or operation.object is None


def _is_over(operation: Operation, sketch: Sketch) -> bool:
    """Whether all that is said is that it, or everything, is over: "done by noon", "all ready by noon"."""
    thing, tree = (operation.object or "").lower(), sketch.part.tree
    if not tree.said(tree.children(tree.root, *SUBJECTS)) <= sketch.lexicon.closed.wholes:
        # "It should be done in ten minutes"
        return False
    so = {operation.phrase, operation.verb, operation.place}
    return thing in sketch.lexicon.closed.wholes | {""} and not so.isdisjoint(sketch.lexicon.beside.ended)
