"""Words that look like time and name a thing ("buy dad morning rolls"), or moments that nobody knows."""

from collections.abc import Iterable, Iterator, Sequence

from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.tags import SUBJECTS

MODIFYING = frozenset({"compound", "amod", "nmod", "poss"})
"""How a word hangs on the noun behind it that it describes."""


def naming_none(remarks: Iterable[Remark], sketches: Sequence[Sketch]) -> list[Remark]:
    """Leave out what is said of leftover words that describe a thing, or name somebody who is spoken to."""
    asked = [sketch for sketch in sketches if sketch.asks]
    return [
        remark
        for remark in remarks
        if not any(_describes(remark.span, one.part) or _is_somebody(remark.span, one) for one in asked)
        and not any(_calls_moment(remark.span, one) or _does(remark.span, one) for one in sketches)
    ]


def _calls_moment(span: Span, sketch: Sketch) -> bool:
    """Whether words are what a moment is called by: "arrival time 10:15"."""
    operation = sketch.operation
    named = sketch.lexicon.closed.named_moments
    return operation is not None and operation.verb in named and span[1] == operation.span[1]


def _does(span: Span, sketch: Sketch) -> bool:
    """Whether words name who does something, or has or needs it: "april takes her pill at nine"."""
    tree, part, operation = sketch.part.tree, sketch.part, sketch.operation
    said = [tree.nodes[place].lower for place in part.at(span)] if span[0] >= part.offset else []
    if operation is None or not said or not {*(operation.object or "").lower().split()}.issuperset(said):
        return False
    subjects = tree.children(tree.root, *SUBJECTS)
    named = {*subjects, *(p for subject in subjects for p in tree.children(subject, "conj"))}
    return part.segment.verbless or named.issuperset(part.at(span))


def _is_somebody(span: Span, sketch: Sketch) -> bool:
    """Whether a word names who is called or asked: "ask june to call back", "invite june and april"."""
    part, operation = sketch.part, sketch.operation
    if operation is None or operation.lemma not in part.lexicon.addressing or span[0] < part.offset:
        return False
    places = list(part.at(span))
    said = (operation.object or "").lower().split()
    nodes = part.tree.nodes
    return len(places) == 1 and any(
        nodes[place].lower in said and nodes[place - 1].lower in {operation.verb, "and"} for place in places
    )


def _describes(span: Span, part: Part) -> bool:
    """Whether every word of a stretch hangs on a noun right behind it, or on one behind other nouns."""
    tree = part.tree
    places = list(part.at(span))
    if not places or span[0] < part.offset:
        return False
    last = places[-1]
    head = tree.nodes[last].head
    between = tree.nodes[last + 1 : head + 1]
    named = head > last and all(node.tag.startswith("NN") for node in between)
    texts = (tree.nodes[place].text for place in places)
    if any(text[0].isalpha() and text[-1].isdecimal() for text in texts):
        # "T+10 open the valve"
        return False
    hangs = (tree.nodes[place].relation in MODIFYING for place in places)
    return named and all(hangs)


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
