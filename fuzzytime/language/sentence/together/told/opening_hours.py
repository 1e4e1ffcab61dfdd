"""What is done where something opens or closes: "buy stamps, the shop shuts at six"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import PARTICIPLE
from fuzzytime.language.meaning.expressions import Phrase, Range, Wall
from fuzzytime.language.sentence.segments.told.asides_of_hours import HOURS, bounding
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import MOMENTS, STRETCHES, Constraint

BESIDE = frozenset({"", ",", "-", "–", ";", ":", "so", ", so", "; so", ", and so"})
"""What stands between an order and what is told of where it is done."""


def within_opening_hours(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Bound orders without a time by when it is told beside them that somewhere opens or closes.

    What is asked for behind that is an errand: "the office closes at five, lock up" is done later. So is
    whatever has to be done once somewhere is open. What only says when "they" are open is nothing by itself.
    """
    found, taken = list(sketches), set[int]()
    for place, sketch in enumerate(found):
        before = place - 1
        bound = _bound_of(sketch) or (_hours_of(found[before], sketch) if place else None)
        if bound is None:
            continue
        closing = bound.said.constraint is not Constraint.AFTER
        if before >= 0 and _is_unbound(found[before]) and _is_beside(found[before], sketch, text):
            of_that = _is_of_that(sketch)
            if closing or is_errand(found[before]) or of_that:
                found[before] = found[before].under([bound])
                taken |= {place} if of_that else set()
            continue
        behind = place + 1
        # "The shop opens at nine and closes at five, buy milk"
        while behind < len(found) and _bound_of(found[behind]) is not None:
            behind += 1
        if behind == len(found) or not _is_unbound(found[behind], opened=True):
            continue
        if _is_beside(found[behind - 1], found[behind], text) and is_errand(found[behind]):
            found[behind] = found[behind].under([bound])
    return [sketch for place, sketch in enumerate(found) if place not in taken]


def _bound_of(sketch: Sketch) -> Phrase | None:
    """Give when somewhere is told to open or close as a bound of what is done there."""
    operation, doing = sketch.operation, sketch.lexicon.doing
    if operation is None or not operation.stated or len(sketch.phrases) != 1 or sketch.clauses:
        return None
    phrase = replace(sketch.phrases[0], rule=HOURS)
    tree, root = sketch.part.tree, sketch.part.tree.root
    described = tree.children(root, "acomp")
    if any(tree.nodes[place].lower in doing.opening_up for place in described):
        # "The shop is open until five"
        return phrase if phrase.said.constraint in STRETCHES or isinstance(phrase.said.time, Range) else None
    at = isinstance(phrase.said.time, Wall) and phrase.said.constraint in MOMENTS
    closing = operation.lemma in doing.closing_up
    if not at or not (closing or operation.lemma in doing.opening_up):
        return None
    return bounding(phrase, closing=closing)


def _hours_of(order: Sketch, sketch: Sketch) -> Phrase | None:
    """Give from when to when what is asked for can be done: "visit dad, visiting is two till four"."""
    told, asked = sketch.operation, order.operation
    if told is None or asked is None or not told.stated or len(sketch.phrases) != 1 or sketch.clauses:
        return None
    phrase, name = sketch.phrases[0], (told.object or "").lower()
    # "Visiting hours are two to four"
    named = name.endswith(HOURS) or name.removesuffix(PARTICIPLE) in {
        asked.lemma,
        asked.lemma.removesuffix("e"),
    }
    return replace(phrase, rule=HOURS) if named and isinstance(phrase.said.time, Range) else None


def _is_unbound(sketch: Sketch, *, opened: bool = False) -> bool:
    """Whether something is asked for, and not when; where it is ``opened``, but for a bound from before."""
    kinds = {phrase.said.constraint for phrase in sketch.times} - ({Constraint.AFTER} if opened else set())
    return sketch.asks and not sketch.clauses and not kinds


def _is_of_that(sketch: Sketch) -> bool:
    """Whether it is told of what the order before it names: "ring the dentist, they open at nine"."""
    tree, anaphors = sketch.part.tree, sketch.lexicon.closed.anaphors
    # "They're open till five" is named by what they are.
    said = {tree.nodes[place].lower for place in tree.children(tree.root, "nsubj")}
    return sketch.operation is not None and (
        sketch.operation.object is None or (bool(said) and said <= anaphors)
    )


def is_errand(sketch: Sketch) -> bool:
    """Whether it is done at a place while that is open, or something is needed from there: "need feed"."""
    doing = sketch.lexicon.doing
    return sketch.operation is not None and sketch.operation.lemma in doing.errands | doing.needing


def _is_beside(before: Sketch, sketch: Sketch, text: str) -> bool:
    """Whether nothing more than a mark, or "so", stands between two parts."""
    return text_between(before, sketch, text).strip().lower() in BESIDE and not sketch.part.segment.connective
