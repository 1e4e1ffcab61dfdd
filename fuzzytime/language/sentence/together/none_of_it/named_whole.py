"""Entries whose words a tree takes apart, where all of them name what happens: "6:00 Supper, toasts & cake".

An hour stands in front of them or behind, and no order begins them. What would be lost, or pointed at, is
what the entry is called.
"""

import re
from dataclasses import replace

from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import NOT_USED, Operation, Reading, Remark, RemarkKind, Span, overlap
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.language.sentence.trees.tags import IMPERATIVE
from fuzzytime.language.sentence.verbs.without_verbs.happenings import is_typed

NAMED = re.compile(r"(?:\((?=[^()]*\)))?[^\W_](?:.*[\w)])?", re.DOTALL)
"""What an entry is called: from its first letter or digit, or the bracket around it, to its last."""

JOINTS = frozenset({"+", "&", "/"})
"""Marks between what is on at once, in the name of an entry."""

SHORT = 2
"""Words of each of several things, at most, that are one entry."""

LONGEST = 20
"""Words of a name, at most: what is longer tells more than what is on."""


def named_whole(draft: Draft, reading: Reading) -> Draft | None:
    """Give a draft of an entry that is only a name and its hour, where a reading of it loses words.

    None with another time than that hour, with an order, and for lines alone that list no things.
    """
    name = _name_of(draft)
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
    before, behind = draft.text[:first], draft.text[end:]
    ends_line = before.strip(" \t-–—*•.:([") != ""
    if ends_line and behind.strip(" \t-–—.:)]"):
        return None
    start, rest = (0, before) if ends_line else (end, behind)
    found = NAMED.search(rest)
    if found is None:
        return None
    name = start + found.start(), start + found.end()
    # "Bath, books, bed at seven"; but "Mr Hill had his tablets at six"
    entry = draft.beside and draft.text[first].isdigit() and not _orders(draft, name[0])
    if len(found[0].split()) > LONGEST or not (entry or _lists_things(found[0], draft)):
        return None
    closed, said = draft.lexicon.closed, {word.text for word in words_of(found[0])}
    if said & (closed.present_be | closed.past_be | closed.have | closed.subject_pronouns):
        # "The guests are late, call mum at nine" tells something, and asks.
        return None
    return name


def _lists_things(name: str, draft: Draft) -> bool:
    """Whether commas alone join things, each named by a word or two: "bath, books, bed"."""
    things = [words_of(thing) for thing in name.split(",")]
    plain = all(0 < len(words) <= SHORT and all(word.is_letters for word in words) for words in things)
    # "Sam, dinner at seven"
    others = draft.lexicon.function_words | draft.lexicon.persons | draft.lexicon.people
    small = others.intersection(word.text for words in things for word in words)
    ordered = len(things[0]) > 1 and things[0][0].text in draft.lexicon.orders | draft.lexicon.addressing
    return len(things) > 1 and plain and not small and not ordered


def _orders(draft: Draft, start: int) -> bool:
    """Whether the first word of a name is an order."""
    words = [word for word in draft.scanned.words if word.start >= start]
    if words and words[0].text in draft.lexicon.orders:
        return True
    nodes = (node for part in draft.parts for node in part.tree.nodes if node.start + part.offset == start)
    return any(node.tag in IMPERATIVE and node.may_act for node in nodes)


def _loses(remark: Remark, name: Span) -> bool:
    """Whether words of a name are not used, or not understood."""
    lost = remark.kind is RemarkKind.NOT_UNDERSTOOD or remark.message.endswith(NOT_USED)
    return lost and overlap(remark.span, name)
