"""By when orders of a sentence are to be over, said as an order: "mow from two and be done by five"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.references.mentions import verb_forms
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.told.asides import Aside
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import Constraint, Reference


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


def prepared_for(sketch: Sketch, aside: Aside) -> list[Sketch]:
    """Give what happens with what is done so long before it: "dinner at seven, takes an hour to cook"."""
    event = sketch.operation
    named = event is not None and (event.stated or event.verb == event.name)
    if event is None or not named or not aside.prepares or not sketch.times or sketch.clauses:
        return []
    verb, _, particle = aside.prepares.partition(" ")
    whole = particle in sketch.lexicon.beside.ended
    preparing = Operation(
        verb=aside.prepares if whole else verb,
        lemma=verb,
        span=(aside.length.span[1], aside.span[1]),
        object=None if whole else event.object or event.name,
        particle=None if whole else particle or None,
    )
    until = [Reference.FINISH] * len(sketch.times)
    prepared = replace(sketch, phrases=tuple(sketch.times), references=tuple(until), operation=preparing)
    prepared = replace(prepared, joints=(*sketch.joints, (sketch.part.segment.span[0], event.span[1])))
    length = replace(aside.length, said=replace(aside.length.said, constraint=Constraint.FOR))
    return [replace(sketch, operation=replace(event, stated=True)), prepared.also(length)]


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
    wholes = sketch.lexicon.closed.wholes | sketch.lexicon.closed.both
    if not tree.said(tree.children(tree.root, *SUBJECTS)) <= wholes:
        # "It should be done in ten minutes"
        return False
    so = {operation.phrase, operation.verb, operation.place}
    return thing in wholes | {""} and not so.isdisjoint(sketch.lexicon.beside.ended)
