"""All that the name of an event means: "after each dive", where there is a first and a second dive."""

from itertools import chain

from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.references.likeness import all_alike


def names_each(clause: Clause, anchors: Anchors) -> bool:
    """Whether a clause names an event each time that it is: "before every take"."""
    first = (clause.object or "").lower().split()[:1]
    return clause.is_event and not anchors.lexicon.closed.distributives.isdisjoint(first)


def every_one(clause: Clause, anchors: Anchors) -> tuple[int, ...]:
    """Give the positions of all instructions that the name of an event means, as far as they are known."""
    here = ((anchors.first + place, operation) for place, operation in enumerate(anchors.own))
    beside = ((place, operation) for place, operation in here if place != anchors.position)
    behind = anchors.first + len(anchors.own)
    last = len(anchors.mentions.operations) if anchors.awaits else behind
    stretches = range(anchors.first), range(behind, last)
    named = anchors.mentions.named_by
    places = chain(*(named(clause, stretch, backwards=False, every=True) for stretch in stretches))
    others = ((place, anchors.mentions.operations[place]) for place in places)
    alike = all_alike(clause, chain(beside, others), anchors.lexicon)
    return tuple([place for place in alike if not _is_in_turns(place, anchors)] or alike)


def _is_in_turns(place: int, anchors: Anchors) -> bool:
    """Whether an instruction is itself done with each of several, or between them."""
    operation, closed = anchors.operation_at(place), anchors.lexicon.closed
    said = "" if operation is None else f"{operation.object or ''} {operation.place or ''}"
    return not closed.marking_turns.isdisjoint(said.lower().split())
