"""Why something is to be done, said in front: "because the bank closes at four, go there before three"."""

from dataclasses import replace

from fuzzytime.language.sentence.segments.segment import Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import SUBJECTS

TOLD = frozenset({"VBZ", "VBP", "VBD", "MD"})
"""Tags of what is so."""

LEAST = 3
"""Words of "lunch is at one", at least, before its time."""


def reason_in_front(one: Waiting, part: Part) -> list[Segment]:
    """Give a reason that has a time of its own as something told, and what is to be done behind its comma.

    "As the pan heats, stir the soup" has none, and says when.
    """
    words = one.source.scanned.words
    places = one.source.places(*one.segment.span)
    if not places or words[places[0]].text not in part.lexicon.beside.reasons_in_front:
        return []
    comma = next((place for place in places if words[place].text == ","), None)
    if comma is None or comma - places[0] <= LEAST or comma + 1 not in places:
        return []
    first, end = words[places[1]].start, words[comma].start
    timed = any(first < phrase.span[0] and phrase.span[1] <= end for phrase in one.source.phrases)
    tree = part.tree if part.front is None else part.front
    told = any(
        node.tag in TOLD and tree.children(place, *SUBJECTS)
        for place, node in enumerate(tree.nodes)
        if first <= node.start + (part.offset if part.front is None else one.segment.span[0]) < end
    )
    if not (timed and told):
        return []
    behind = (words[comma + 1].start, one.segment.span[1])
    return [replace(one.segment, span=(first, end)), Segment(behind, addressee=one.segment.addressee)]
