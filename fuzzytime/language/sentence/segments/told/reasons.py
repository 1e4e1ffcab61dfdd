"""Why something is to be done: "because the bank closes at four, go there before three", "… or it's shut"."""

import re
from dataclasses import replace

from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.instruction import blanked
from fuzzytime.language.sentence.segments.segment import ENDS, Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import FINITE, SUBJECTS
from fuzzytime.requirement import Constraint

LEAST = 3
"""Words of "lunch is at one", at least, before its time."""

SUBJECT = re.compile(r"[^\W\d]+")
"""Whom or what it is said of: "they" of "they'll"."""


def without_threats(scanned: Scanned) -> str:
    """Give a text of the same length without what is so behind a deadline: "by three | or they won't come".

    What will be so needs no deadline: "put them out tonight | or it'll be a fortnight". "By three or you
    can do it at six" offers another time.
    """
    words, text, closed = scanned.words, scanned.text, scanned.lexicon.closed
    for place in range(1, len(words) - 1):
        joint, subject = words[place], SUBJECT.match(words[place + 1].text)
        told = subject is not None and subject[0] in closed.personal_pronouns | {"it"}
        behind = words[place + 2 : place + 3] if words[place + 1].text == "else" else ()
        told = told or any(word.text not in scanned.lexicon.orders for word in behind)
        offers = not closed.tentative_modals.isdisjoint(word.text for word in words[place + 2 : place + 3])
        if joint.text not in closed.alternatives or not told or offers:
            continue
        bounds = (one for one in phrases_of(scanned) if one.said.constraint is Constraint.BEFORE)
        bound = any(words[one.first].start < joint.start and one.end in {place, place - 1} for one in bounds)
        if bound or _is_foretold(scanned, place + 1):
            end = next((word.start for word in words[place:] if word.text in ENDS), len(text))
            text = blanked(text, [(joint.start, end)])
    return text


def _is_foretold(scanned: Scanned, place: int) -> bool:
    """Whether words say what will be, or cannot be, so: "it'll", "they won't"."""
    words, lexicon = scanned.words, scanned.lexicon
    subject = SUBJECT.match(words[place].text)
    helping = "" if subject is None else words[place].text[subject.end() :]
    behind = helping or (words[place + 1].text if place + 1 < len(words) else "")
    return behind in lexicon.closed.future | lexicon.asides["unable"]


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
    # "Because the lift is being mended at ten"
    finite = [
        {node.tag, *(tree.nodes[p].tag for p in tree.children(place, "aux", "auxpass"))}
        for place, node in enumerate(tree.nodes)
    ]
    told = any(
        not finite[place].isdisjoint(FINITE) and tree.children(place, *SUBJECTS)
        for place, node in enumerate(tree.nodes)
        if first <= node.start + (part.offset if part.front is None else one.segment.span[0]) < end
    )
    if not (timed and told):
        return []
    behind = (words[comma + 1].start, one.segment.span[1])
    return [replace(one.segment, span=(first, end)), Segment(behind, addressee=one.segment.addressee)]
