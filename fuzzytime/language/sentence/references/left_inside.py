"""What is left somewhere for a while: it goes in where that begins, and comes out where it is over.

"Score the loaves just before they go in. Bake them for 40 minutes. Call Ana 20 minutes before they come out".
"""

from itertools import chain

from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.named import is_several
from fuzzytime.requirement import Edge

WAYS = {"in": Edge.START, "out": Edge.END}


def edge_inside(clause: Clause, anchors: Anchors) -> Edge | None:
    """Give which end a clause is about of what goes on where something is: it goes in, or comes out."""
    way = "" if clause.where is None else clause.where.split()[0].lower()
    moves = clause.verb in anchors.lexicon.doing.being_somewhere and clause.verb != "be"
    return WAYS.get(way) if moves else None


def left_inside(clause: Clause, anchors: Anchors) -> int | None:
    """Give the instruction that leaves a thing there: the latest about it, the next, or one of its number."""
    subject = None if clause.condition is None else clause.condition.subject
    if subject is None or edge_inside(clause, anchors) is None:
        return None
    closed, own = anchors.lexicon.closed, anchors.operation_at(anchors.position)
    anaphor = subject in closed.anaphors
    thing = (own.object if own is not None else None) if anaphor else clause.object or subject
    last = anchors.first + len(anchors.own) if not anchors.awaits else len(anchors.mentions.operations)
    over = edge_inside(clause, anchors) is Edge.END
    before = [p for p in range(anchors.position - 1, -1, -1) if _leaves_something(p, anchors, over=over)]
    behind = (p for p in range(anchors.position + 1, last) if _leaves_something(p, anchors, over=over))
    words = content_words(thing)
    named = (p for p in chain(before, behind) if not words.isdisjoint(content_words(_thing(p, anchors))))
    several = subject not in closed.singular_anaphors
    alike = (p for p in before if is_several(_thing(p, anchors), anchors.lexicon) == several)
    return next(chain(named, alike if anaphor else ()), None)


def _leaves_something(place: int, anchors: Anchors, *, over: bool) -> bool:
    """Whether an instruction leaves something somewhere, for a known while where it is to be ``over``."""
    operation = anchors.operation_at(place)
    if operation is None or not operation.is_asked or operation.lemma not in anchors.lexicon.doing.putting:
        return False
    # What is baked is so for as long as that takes; what is only put somewhere stays there.
    baked = operation.place is None and operation.particle is None
    return not over or baked or anchors.told.length(place) is not None


def _thing(place: int, anchors: Anchors) -> str:
    operation = anchors.operation_at(place)
    return "" if operation is None else operation.object or ""
