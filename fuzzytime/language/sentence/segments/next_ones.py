"""What is the next of its kind, and no next step: "next on-call takes over at eight"."""

from dataclasses import replace

from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import SUBJECTS

NEXT = "next"
NAMED = frozenset({"DT", "PRP", "PRP$", "NNPS", "EX", "NNS"})
"""Tags of who does something that begins with no bare noun."""


def next_one(one: Waiting, part: Part) -> list[Segment]:
    """Give a segment with the "next" in front, where that describes what does it: "next bus leaves"."""
    segment, tree, root = one.segment, part.tree, part.tree.root
    said = one.source.scanned.text[slice(*segment.connective_span)].lower()
    if said != NEXT or tree.nodes[root].tag != "VBZ":
        return []
    subjects = [p for p in tree.children(root, *SUBJECTS) if p < root]
    if not subjects or tree.reach(subjects[0])[0] != 0:
        return []
    who = tree.nodes[:root]
    if any(node.tag in NAMED or node.text[0].isupper() or node.lower in part.lexicon.persons for node in who):
        return []
    span = (segment.connective_span[0], segment.span[1])
    return [replace(segment, span=span, connective="", connective_span=(0, 0))]
