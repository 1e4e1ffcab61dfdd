"""Words that say when or how often, and by which nothing is planned: "every payday", "between lessons"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.segments.waiting import Part


def unknown_moments(text: str, part: Part, heard: Sequence[Span]) -> Iterator[Remark]:
    """Point at what is repeated as often as something that is not known, and at what lies between events."""
    for place in _unknown(part):
        first, end = part.tree.reach(place)
        span = part.span(part.tree.nodes[first], part.tree.nodes[end - 1])
        if not any(overlap(span, other) for other in heard):
            message = f"{text[slice(*span)]!r} says when, and is not understood"
            yield Remark(RemarkKind.NOT_UNDERSTOOD, span, message)


def _unknown(part: Part) -> Iterator[int]:
    """Give the words over such stretches: a noun, or its preposition."""
    lexicon = part.lexicon
    tree = part.tree
    events = lexicon.events | lexicon.happening | lexicon.taken | lexicon.lasting
    for place, node in enumerate(tree.nodes):
        if not node.tag.startswith("NN"):
            continue
        each = any(tree.nodes[p].lower in lexicon.closed.distributives for p in tree.children(place, "det"))
        things = [p for p in tree.children(node.head, "dobj") if p < place]
        # Who stands first may be given the second.
        given = all(tree.nodes[p].lower in lexicon.persons for p in things)
        if each and things and (node.relation == "npadvmod" or (node.relation == "dobj" and not given)):
            # "Pay the rent every payday"; but "give mum every photo"
            yield place
        over = tree.nodes[node.head]
        several = node.tag == "NNS" and not events.isdisjoint({node.lower, node.lemma})
        lies_between = node.relation == "pobj" and over.lower == "between"
        if several and lies_between and not tree.children(place, "conj"):
            yield node.head
