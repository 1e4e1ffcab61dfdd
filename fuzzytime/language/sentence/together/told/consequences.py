"""What has to be done as something else takes long: "chill it for four hours, so make it before lunch".

That comes first, where it is about the same thing: how long the other takes says when to begin.
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Instruction, Span
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement


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
