"""Where further wishes begin that borrow words of the first."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.borrowed import Borrowed
from fuzzytime.language.sentence.segments.borrowed_words.frames import (
    acts_too,
    happens_too,
    is_asked_too,
    is_done_too,
    is_gone_for_too,
    is_reminded_then,
    is_sure_too,
    lets_too,
)
from fuzzytime.language.sentence.segments.borrowed_words.further_wishes import Stretch, Wish
from fuzzytime.language.sentence.segments.borrowed_words.other_places import is_moved_on
from fuzzytime.language.sentence.segments.borrowed_words.other_things import is_done_elsewhere, is_given_too
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.source import Source
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tags import PAST
from fuzzytime.language.sentence.trees.tree import Tree

STOPS = frozenset({",", ";"})
"""Marks that join as conjunctions do."""

Kind = Callable[[Wish], list[Stretch] | None]

KINDS: tuple[Kind, ...] = (
    is_sure_too,
    is_asked_too,
    lets_too,
    is_gone_for_too,
    acts_too,
    happens_too,
    is_done_too,
    is_given_too,
    is_done_elsewhere,
    is_moved_on,
)
IN_FRONT: tuple[Kind, ...] = (is_reminded_then, is_done_elsewhere)
"""What a wish may be that has its time in front, or stands apart."""
DONE_TOO: tuple[Kind, ...] = (lets_too, is_done_too)
"""What a wish may be that no time stands before: "I want the table laid and the candles lit"."""


def wishes_beside(one: Waiting, part: Part) -> dict[int, tuple[Borrowed, ...]]:
    """Give where further wishes begin that borrow words, with these."""
    tree, timed = part.tree, one.timed(part.tree)
    found: dict[int, tuple[Borrowed, ...]] = {}
    for start, kinds in (*_starts(tree, timed), *_other_times(tree, timed)):
        behind = range(start, len(tree.nodes))
        ends = (p for p in behind if p in timed or (tree.nodes[p].lower,) in part.lexicon.clauses)
        end = next(ends, len(tree.nodes))
        wish = Wish(tree, start, end, timed, part.lexicon)
        borrowed = _borrowed(wish, kinds, part.offset)
        if borrowed is not None:
            found[tree.nodes[start].start + part.offset] = borrowed
    return found


def _borrowed(wish: Wish, kinds: Sequence[Kind], offset: int) -> tuple[Borrowed, ...] | None:
    """Give the words that a wish borrows, as the first of some kinds that it is of says; None for none."""
    nodes = wish.tree.nodes
    stretches = next((said for kind in kinds if (said := kind(wish)) is not None), None)
    if stretches is None or any(not wish.timed.isdisjoint(words) for _, words in stretches):
        return None
    starts = [*(node.start for node in nodes), nodes[-1].end]
    return tuple(
        Borrowed(starts[at] + offset, (nodes[words[0]].start + offset, nodes[words[-1]].end + offset))
        for at, words in stretches
        if words
    )


def wishes_behind(source: Source, parts: Mapping[int, Part]) -> Iterator[Part]:
    """Give the parts, by where they begin, that are done as the part before is: "…, then Ann to school"."""
    ordered: Part | None = None
    for start in sorted(parts):
        part = parts[start]
        if not part.tree.nodes or part.segment.borrowed or part.segment.entry:
            continue
        end = ordered.segment.span[1] if ordered is not None else 0
        said = source.scanned.text[end : part.segment.span[0]].lower()
        timed = any(start <= phrase.span[0] < part.segment.span[1] for phrase in source.phrases)
        # "Feed the hens when you get up and the ducks when it gets light"
        timed = timed or (
            part.segment.verbless and any((node.lower,) in part.lexicon.clauses for node in part.tree.nodes)
        )
        goes_on = timed and _joins(said, part.lexicon)
        borrowed = _behind(source, ordered, part) if ordered is not None and goes_on else None
        if borrowed is None:
            ordered = part
        else:
            yield replace(part, segment=replace(part.segment, borrowed=borrowed, verbless=False))


def _joins(said: str, lexicon: Lexicon) -> bool:
    """Whether what stands between two parts lets the second be as the first is: ", and then"."""
    joints = _joints(lexicon) | lexicon.closed.joints_of_steps
    return bool(said.strip()) and ENDS.isdisjoint(said) and joints.issuperset(said.split())


def _joints(lexicon: Lexicon) -> frozenset[str]:
    return lexicon.closed.conjunctions_of_clauses | STOPS


def _behind(source: Source, ordered: Part, part: Part) -> tuple[Borrowed, ...] | None:
    """Give the words of the part before that hold in a part; None where it is no further wish."""
    first, shift = ordered.tree.nodes, len(ordered.tree.nodes)
    nodes = (
        *(replace(n, start=n.start + ordered.offset, end=n.end + ordered.offset) for n in first),
        *(
            replace(n, start=n.start + part.offset, end=n.end + part.offset, head=n.head + shift)
            for n in part.tree.nodes
        ),
    )
    both = Tree(source.scanned.text, nodes, ordered.lexicon)
    timed = frozenset(place for phrase in source.phrases for place in both.at(*phrase.span))
    return _borrowed(Wish(both, shift, len(nodes), timed, ordered.lexicon, apart=True), IN_FRONT, 0)


def _starts(tree: Tree, timed: AbstractSet[int]) -> Iterator[tuple[int, Sequence[Kind]]]:
    """Give the places behind a joint that stands behind a time, or behind what is done with something."""
    joints = _joints(tree.lexicon)
    for place in range(2, len(tree.nodes)):
        before = place - 1
        if place in timed or tree.nodes[before].lower not in joints:
            continue
        while before and tree.nodes[before].lower in joints:
            before -= 1
        if before in timed or tree.nodes[before].tag in PAST:
            yield place, KINDS if before in timed else DONE_TOO


def _other_times(tree: Tree, timed: AbstractSet[int]) -> Iterator[tuple[int, Sequence[Kind]]]:
    """Give the places of times between a joint and what is to be done: "and | in two hours to call dad"."""
    for place in range(2, len(tree.nodes) - 1):
        joined = tree.nodes[place - 1].lower in _joints(tree.lexicon)
        if place not in timed or place - 1 in timed or not joined:
            continue
        yield place, IN_FRONT
