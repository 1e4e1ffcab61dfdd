"""What is done because of what is told to happen: "the guests come at seven, so set the table"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Instruction, Span
from fuzzytime.language.meaning.expressions import Phrase, Wall
from fuzzytime.language.sentence.references.mentions import comes
from fuzzytime.language.sentence.segments.told.asides_of_hours import bounding
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.language.sentence.together.told.opening_hours import is_errand
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import MOMENTS, Anchor, Constraint, Edge, TimeRequirement

LEADING = frozenset({"so", ", so", "; so", ", and so", "- so", "– so", ":", "-", "–", "—"})
"""What stands between what is told and what is done because of it."""


def due_before_told(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Bound orders without a time by when it is told right before them that something begins, comes or goes.

    What comes is waited for by what is done with it: "the truck arrives at ten, so unload it". Behind what
    ends comes what is no errand: "the meeting ends at three, so clean the room".
    """
    found = list(sketches)
    for place in range(1, len(found)):
        told, order = found[place - 1 : place + 1]
        between = text_between(told, order, text).strip().lower()
        if between not in LEADING or order.part.segment.connective or not order.is_open:
            continue
        said = _said_when(told)
        ends = _ends(told)
        if said is not None and (ends or (_begins(told) and not _is_done_with(order, told))):
            closing = not ends or is_errand(order)
            found[place] = order.under([bounding(said, closing=closing)])
    return found


def _said_when(sketch: Sketch) -> Phrase | None:
    """Give the only time of what is told to happen then; None for all else."""
    operation = sketch.operation
    if operation is None or not operation.stated or len(sketch.phrases) != 1 or sketch.clauses:
        return None
    phrase = sketch.phrases[0]
    at = isinstance(phrase.said.time, Wall) and phrase.said.constraint in MOMENTS
    return phrase if at else None


def _ends(sketch: Sketch) -> bool:
    """Whether something is told to end, and does not close."""
    lemma = None if sketch.operation is None else sketch.operation.lemma
    return lemma in sketch.lexicon.doing.ending - sketch.lexicon.doing.closing_up


def _begins(sketch: Sketch) -> bool:
    """Whether something is told to begin, to come or to go, or what who speaks does then."""
    lexicon = sketch.lexicon
    operation, doing = sketch.operation, lexicon.doing
    if operation is None:
        return False
    named = content_words(operation.object)
    happens = operation.complement is None and not named.isdisjoint(lexicon.happening | lexicon.taken)
    begins = (doing.beginning | doing.leaving) - doing.opening_up
    becomes = operation.lemma in doing.becoming and not named.isdisjoint(lexicon.impersonal)
    tree, root = sketch.part.tree, sketch.part.tree.root
    doers = tree.children(root, *SUBJECTS)
    # "We fly at nine, so pack the bags"
    ours = any(tree.nodes[place].lower in lexicon.closed.first_person for place in doers)
    return operation.lemma in begins or becomes or ours or (operation.lemma == "be" and happens)


def _is_done_with(order: Sketch, told: Sketch) -> bool:
    """Whether it is done with what comes, which has to be there."""
    asked, happening = order.operation, told.operation
    if asked is None or happening is None or not comes(happening, order.lexicon):
        return False
    known = content_words(asked.object) | content_words(asked.place)
    again = (asked.object or "").lower() in order.lexicon.closed.all_anaphors
    return again or not known.isdisjoint(content_words(happening.object))


def leads_to_consequence(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether "so" stands between two orders, or in front of the second."""
    between = text_between(before, sketch, text).strip(" ,;").lower()
    first = text[slice(*sketch.part.segment.span)].partition(" ")[0].lower()
    return "so" in {between, first}


def behind_consequences(
    instructions: Sequence[Instruction], sketches: Sequence[Sketch], text: str, first: int
) -> list[Instruction]:
    """Let what takes long come behind what is asked for as it does; ``first`` were given before the text."""
    found = list(instructions)
    for place in range(len(sketches) - 1):
        why, consequence = found[place : place + 2]
        if not leads_to_consequence(sketches[place], sketches[place + 1], text):
            continue
        if _is_why(why, consequence):
            span = _so(text, why.span[1], consequence)
            after = TimeRequirement(
                text=text[slice(*span)],
                span=span,
                constraint=Constraint.AFTER,
                preposition="after",
                anchor=Anchor(text=text[slice(*span)], target=first + place + 1, edge=Edge.END),
            )
            found[place] = replace(why, requirements=(*why.requirements, after))
    return found


def _is_why(why: Instruction, consequence: Instruction) -> bool:
    """Whether one only says how long it goes on, and the other, about the same thing, when it is due."""
    one, other = why.operation, consequence.operation
    if one is None or other is None or not (one.is_asked and other.is_asked):
        return False
    same = one.object is not None and one.object == other.object
    due = any(
        part.constraint in {Constraint.AT, Constraint.BEFORE} and part.anchor is None
        for part in consequence.requirements
    )
    lengths = bool(why.requirements) and all(p.constraint is Constraint.FOR for p in why.requirements)
    return same and due and lengths


def _so(text: str, end: int, consequence: Instruction) -> Span:
    """Give where "so" stands behind a character, or what it leads to."""
    place = text.lower().find("so", end)
    return (place, place + len("so")) if place >= 0 else consequence.span
