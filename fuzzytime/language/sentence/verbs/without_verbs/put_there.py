"""What is put somewhere, said without a verb: "ribs in at 10:30, two hours", "kettle on at six"."""

from collections.abc import Sequence

from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Tree

PLACES = frozenset({"in", "on"})
"""Where things are put that are only named: "lights out" and "doors open" happen."""

THINGS = frozenset({"NN", "NNS", "VBZ"})
"""Tags of things: a plural in front is often taken for what one does."""


def put_there(tree: Tree, timed: Sequence[int]) -> Operation | None:
    """Give what is named with "in" or "on" and a time behind it as to be put there; None for all else.

    Who comes in does so alone ("mum in at six"), and what happens is on ("dinner on at six").
    """
    lexicon = tree.lexicon
    nodes = tree.nodes
    first = 1 if nodes and nodes[0].tag in DETERMINERS else 0
    place = next((p for p in range(first + 1, len(nodes)) if nodes[p].lower in PLACES), 0)
    if not place or place + 1 not in timed or place in timed or nodes[place].tag == "IN":
        return None
    things = nodes[first:place]
    thing = things[-1]
    named = {node.lower for node in things}
    known = named & (lexicon.happening | lexicon.taken | lexicon.persons | lexicon.travelling)
    acts = thing.lower == thing.lemma and thing.may_act
    if known or acts or thing.tag not in THINGS or any(n.tag not in THINGS | {"JJ"} for n in things[:-1]):
        return None
    if thing.tag == "VBZ" and len(things) > 1:
        # "The bus comes in at nine"
        return None
    said = tree.text[nodes[0].start : thing.end]
    span = (nodes[place].start, nodes[place].end)
    lowered = said[:1].lower() + said[1:] if nodes[0].text[1:].islower() else said
    return Operation(verb="put", lemma="put", span=span, object=lowered, particle=nodes[place].lower)
