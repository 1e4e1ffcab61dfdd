"""Where orders come: behind another, by a connective ("then, within ten minutes"), first or last of all."""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Order, Remark, RemarkKind, Span
from fuzzytime.language.sentence.segments.segment import ENDS, Segment
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement

ORDERING = frozenset({"then", "meanwhile"})

NAMED = frozenset({"DT", "PRP", "PRP$", "NNPS", "EX", "NNS"})
"""Tags of who does something that begins with no bare noun."""


def follows_nothing(said: str, span: Span) -> Remark:
    """Point at words that order an instruction beside another, where it is the first."""
    message = f"{said!r} is about an instruction before it, and none was given so far"
    return Remark(RemarkKind.UNRESOLVED, span, message)


def led_by_nothing(segment: Segment, text: str) -> Iterator[Remark]:
    """Point at the connective of what is the first instruction of all."""
    if segment.connective in ORDERING:
        said = text[slice(*segment.connective_span)].rstrip(" ,:")
        yield follows_nothing(said, segment.connective_span)


def led_by_denial(segment: Segment, text: str) -> Iterator[Remark]:
    """Point at the connective of what comes behind nothing but what is not to be done: "don't …, then …"."""
    if segment.connective in ORDERING:
        said = text[slice(*segment.connective_span)].rstrip(" ,:")
        message = f"{said!r} is not used: nothing that is to be done was said before it"
        yield Remark(RemarkKind.POLICY, segment.connective_span, message)


def anchored_by_connective(segment: Segment, text: str, before: int | None) -> TimeRequirement | None:
    """Give the order that "then" or "meanwhile" says, to the instruction ``before``; None without one."""
    if segment.connective not in ORDERING or before is None:
        return None
    first, end = segment.connective_span
    said = text[first:end].rstrip(" ,:") or text[first:end]
    follows = segment.connective == "then"
    return TimeRequirement(
        text=said,
        span=(first, first + len(said)),
        constraint=Constraint.AFTER if follows else Constraint.AT,
        preposition=segment.connective,
        anchor=Anchor(text=said, target=before, edge=Edge.END if follows else Edge.START),
    )


def agreeing(connected: TimeRequirement | None, others: Sequence[TimeRequirement]) -> TimeRequirement | None:
    """Let "then" agree with a distance from the same: "bake it, then take it out after an hour"."""
    if connected is None or connected.anchor is None:
        return connected
    anchor = connected.anchor
    edges = [
        o.anchor.edge for o in others if o.anchor and o.anchor.exact and o.anchor.target == anchor.target
    ]
    return replace(connected, anchor=replace(anchor, edge=edges[0])) if edges else connected


def within_after(requirements: Sequence[TimeRequirement]) -> list[TimeRequirement]:
    """Let a length that something is to be done within count from what it is to be done after.

    "Then mount the cover within five minutes" counts from what was done before.
    """
    within = [part for part in requirements if part.preposition == "within" and part.anchor is None]
    after = [part for part in requirements if _is_after(part)]
    if len(within) != 1 or len(after) != 1:
        return list(requirements)
    (length,), (behind,) = within, after
    if length.t_spec is None or behind.anchor is None:
        return list(requirements)
    anchor = replace(behind.anchor, lag=behind.anchor.lag + length.t_spec)
    both = replace(length, constraint=Constraint.BETWEEN, anchor=anchor, t_spec=None, latest=None)
    return [both if part is length else part for part in requirements if part is not behind]


def _is_after(part: TimeRequirement) -> bool:
    anchor = part.anchor
    behind = anchor is not None and anchor.target is not None and not anchor.exact
    return behind and part.constraint is Constraint.AFTER


def next_one(one: Waiting, part: Part) -> list[Segment]:
    """Give a segment with the "next" in front, where that describes what does it: "next bus leaves"."""
    segment, tree, root = one.segment, part.tree, part.tree.root
    said = one.source.scanned.text[slice(*segment.connective_span)].lower()
    if said != "next" or tree.nodes[root].tag != "VBZ":
        return []
    subjects = [p for p in tree.children(root, *SUBJECTS) if p < root]
    if not subjects or tree.reach(subjects[0])[0] != 0:
        return []
    who = tree.nodes[:root]
    if any(node.tag in NAMED or node.text[0].isupper() or node.lower in part.lexicon.persons for node in who):
        return []
    span = (segment.connective_span[0], segment.span[1])
    return [replace(segment, span=span, connective="", connective_span=(0, 0))]


def order_words(
    words: Sequence[Word], covered: AbstractSet[int], lexicon: Lexicon
) -> Iterator[tuple[Span, Order]]:
    """Give the words behind what is to be done that say where it comes; ``covered`` are those about time."""
    closed = lexicon.closed
    orders = set(Order)
    for place in range(1, len(words)):
        word = words[place]
        before = words[place - 1].text
        # "Leave the kitchen till last"; but "keep the mugs out till last" goes on until then.
        led = word.text == Order.LAST and lexicon.clauses.get((before,)) == "until"
        led = led and not lexicon.beside.left_at.isdisjoint(one.text for one in words[:place])
        named = before in ENDS or (before in closed.no_order_before and not led)
        if word.text not in orders or place in covered or named:
            continue
        behind = words[place + 1].text if place + 1 < len(words) else ""
        ends = not behind[:1].isalnum() or place + 1 in covered or behind in lexicon.function_words
        if ends and behind not in closed.prepositions_of_length:
            yield (words[place - led].start, word.end), Order(word.text)
