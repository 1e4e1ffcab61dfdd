"""Where further wishes begin that borrow words of the first."""

from collections.abc import Callable, Iterator
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.borrowed import Borrowed
from fuzzytime.language.sentence.segments.borrowed_words.frames import (
    acts_too,
    is_asked_too,
    is_done_too,
    is_gone_for_too,
    is_reminded_then,
    is_sure_too,
    lets_too,
)
from fuzzytime.language.sentence.segments.borrowed_words.further_wishes import Stretch, Wish
from fuzzytime.language.sentence.segments.borrowed_words.other_things import (
    goes_elsewhere,
    is_done_then,
    is_given_too,
    is_put_too,
)
from fuzzytime.language.sentence.segments.waiting import Part, Waiting
from fuzzytime.language.sentence.trees.tree import Tree

JOINTS = frozenset({"and", "&", ",", ";", "but"})

KINDS: tuple[Callable[[Wish], list[Stretch] | None], ...] = (
    is_sure_too,
    is_asked_too,
    lets_too,
    is_gone_for_too,
    acts_too,
    is_done_too,
    goes_elsewhere,
    is_given_too,
    is_put_too,
    is_done_then,
)


def wishes_beside(one: Waiting, part: Part, lexicon: Lexicon) -> dict[int, tuple[Borrowed, ...]]:
    """Give where further wishes begin that borrow words, with these."""
    tree, timed = part.tree, one.timed(part.tree)
    found: dict[int, tuple[Borrowed, ...]] = {}
    for start in (*_starts(tree, timed), *_other_times(tree, timed)):
        behind = range(start, len(tree.nodes))
        ends = (p for p in behind if p in timed or (tree.nodes[p].lower,) in lexicon.clauses)
        end = next(ends, len(tree.nodes))
        wish = Wish(tree, start, end, timed, lexicon)
        kinds = (is_reminded_then,) if start in timed else KINDS
        stretches = next((said for kind in kinds if (said := kind(wish)) is not None), None)
        if stretches is None or any(not timed.isdisjoint(words) for _, words in stretches):
            continue
        offset = part.offset
        found[tree.nodes[start].start + offset] = tuple(
            Borrowed(
                tree.nodes[at].start + offset,
                (tree.nodes[words[0]].start + offset, tree.nodes[words[-1]].end + offset),
            )
            for at, words in stretches
            if words
        )
    return found


def _starts(tree: Tree, timed: AbstractSet[int]) -> Iterator[int]:
    """Give the places behind a joint that stands behind a time."""
    for place in range(2, len(tree.nodes)):
        before = place - 1
        if place in timed or tree.nodes[before].lower not in JOINTS:
            continue
        while before and tree.nodes[before].lower in JOINTS:
            before -= 1
        if before in timed:
            yield place


def _other_times(tree: Tree, timed: AbstractSet[int]) -> Iterator[int]:
    """Give the places of times between a joint and what is to be done: "and | in two hours to call dad"."""
    for place in range(2, len(tree.nodes) - 1):
        if place not in timed or place - 1 in timed or tree.nodes[place - 1].lower not in JOINTS:
            continue
        behind = next(p for p in range(place, len(tree.nodes) + 1) if p not in timed)
        done = tree.nodes[behind + 1 : behind + 2]
        if done and tree.nodes[behind].lower == "to" and done[0].may_act:
            yield place
