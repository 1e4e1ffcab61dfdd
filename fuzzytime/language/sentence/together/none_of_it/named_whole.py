"""Entries whose words a tree takes apart, where all of them name what happens: "6:00 Supper, toasts & cake".

An hour stands in front of them or behind, and no order begins them. What would be lost, or pointed at, is
what the entry is called.
"""

import re
from dataclasses import replace

from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation, Reading, Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.tags import IMPERATIVE
from fuzzytime.language.sentence.verbs.without_verbs.happenings import is_typed

NAMED = re.compile(r"(?:\((?=[^()]*\)))?[^\W_](?:.*[\w)])?", re.DOTALL)
"""What an entry is called: from its first letter or digit, or the bracket around it, to its last."""

JOINTS = frozenset({"+", "&", "/"})
"""Marks between what is on at once, in the name of an entry."""

LONGEST = 20
"""Words of a name, at most: what is longer tells more than what is on."""


def named_whole(draft: Draft, reading: Reading) -> Draft | None:
    """Give a draft of an entry that is only a name and its hour, where a reading of it loses words.

    None for lines alone, with another time than that hour, or with an order.
    """
    name = _name_of(draft) if draft.beside else None
    if name is None:
        return None
    named = draft.text[slice(*name)]
    # "Hair + make-up", of which a tree makes two things to be done
    cut = len(reading.instructions) > 1 and not JOINTS.isdisjoint(named.split())
    if not cut and not any(_loses(remark, name) for remark in reading.remarks):
        return None
    operation = Operation(
        verb=named.split()[-1].lower(), lemma="be", span=name, object=" ".join(named.split()), stated=True
    )
    return replace(draft, entry=operation)


def sketch_of_entry(draft: Draft, operation: Operation) -> Sketch:
    """Sketch an entry that is all a name beside its time."""
    part = draft.parts[0]
    first, end = draft.phrases[0].span
    span = min(first, operation.span[0]), max(end, operation.span[1])
    whole = replace(part, segment=replace(part.segment, span=span))
    return Sketch(
        part=whole,
        phrases=draft.phrases,
        clauses=(),
        references=(None,),
        operation=operation,
        joints=(operation.span,),
    )


def _name_of(draft: Draft) -> Span | None:
    """Give the stretch of the name beside the only time of a line; None where there is more."""
    if len(draft.phrases) != 1 or not draft.parts or not is_typed(draft.phrases[0]):
        return None
    if draft.asides or draft.messages or (draft.heading is not None and draft.heading.addressee is not None):
        return None
    first, end = draft.phrases[0].span
    if not draft.text[first].isdigit():
        # "Mr Hill had his tablets at six"
        return None
    before, behind = draft.text[:first], draft.text[end:]
    if before.strip(" \t-–—*•.:([") and behind.strip(" \t-–—.:)]"):
        return None
    start, rest = (0, before) if before.strip(" \t-–—*•.:([") else (end, behind)
    found = NAMED.search(rest)
    if found is None or len(found[0].split()) > LONGEST or _orders(draft, start + found.start()):
        return None
    closed, said = draft.lexicon.closed, {word.text for word in words_of(found[0])}
    if said & (closed.present_be | closed.past_be | closed.have | closed.subject_pronouns):
        # "The guests are late, call mum at nine" tells something, and asks.
        return None
    return start + found.start(), start + found.end()


def _orders(draft: Draft, start: int) -> bool:
    """Whether the first word of a name is an order; what has a bracket behind it is none: "Snack (fruit)"."""
    words = [word for word in draft.scanned.words if word.start >= start]
    if [word.text for word in words[1:2]] == ["("]:
        return False
    if words and words[0].text in draft.lexicon.orders:
        return True
    nodes = (node for part in draft.parts for node in part.tree.nodes if node.start + part.offset == start)
    return any(node.tag in IMPERATIVE and node.may_act for node in nodes)


def _loses(remark: Remark, name: Span) -> bool:
    """Whether words of a name are not used, or not understood."""
    lost = remark.kind is RemarkKind.NOT_UNDERSTOOD or remark.message.endswith("is not used")
    return lost and overlap(remark.span, name)
