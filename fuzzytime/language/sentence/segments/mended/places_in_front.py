"""Where something is done, in front of a verb that no tree sees: "in a bowl mix flour and salt"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from fuzzytime.english import is_participle
from fuzzytime.language.sentence.segments.fronts import CARRIER, is_bare, is_order, may_be_done
from fuzzytime.language.sentence.segments.waiting import Waiting
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Node, Tree, Trees

LEAST = 3
"""Words of "in a bowl", before what is done there."""


@dataclass(frozen=True, slots=True)
class _Try:
    """A place at which what is to be done may begin behind the words that say where."""

    one: int
    front: str
    order: str


def with_places_in_front(waiting: Sequence[Waiting], found: Sequence[Tree], trees: Trees) -> list[Tree]:
    """Give trees in which words in front that say where hang on what is done there.

    One tree of the whole may have the verb for a part of the thing in front, or of the one behind. So it is
    tried: wherever a bare verb stands behind such a thing, both parts are parsed.
    """
    tries = [
        attempt
        for place, (one, tree) in enumerate(zip(waiting, found, strict=True))
        for attempt in _tries(place, one, tree)
    ]
    fronts = trees([attempt.front for attempt in tries])
    orders = trees([CARRIER + attempt.order for attempt in tries])
    mended = list(found)
    for attempt, front, carried in zip(tries, fronts, orders, strict=True):
        order = carried.without_carrier(CARRIER, attempt.order, 0)
        tree = found[attempt.one]
        if mended[attempt.one] is tree and _says_where(front) and is_order(order) and _governs(order):
            mended[attempt.one] = _joined(tree, front, order)
    return mended


def _tries(place: int, one: Waiting, tree: Tree) -> Iterator[_Try]:
    nodes, skipped = tree.nodes, one.behind_time
    # "At six in the garage record the match"
    first = next((p for p, node in enumerate(nodes) if node.start >= skipped), len(nodes))
    if (
        len(nodes) <= first + LEAST
        or nodes[first].tag != "IN"
        or nodes[first].lower not in tree.lexicon.places
    ):
        return
    if nodes[first + 1].tag not in DETERMINERS:
        return
    timed, root = one.timed(tree), tree.root
    for here in range(first + LEAST, len(nodes) - 1):
        node, before = nodes[here], nodes[here - 1]
        if here in timed:
            continue
        if here == root and node.may_act and is_bare(node, tree.lexicon):
            return
        # "On your way home at five pick up milk"
        led = (
            before.text == ","
            or here - 1 in timed
            or (before.tag.startswith("NN") and not is_participle(before.lower))
        )
        if led and may_be_done(tree, here) and nodes[here + 1].lower != "of":
            front, order = tree.text[nodes[first].start : before.end], tree.text[node.start :]
            yield _Try(place, front.rstrip(" ,"), order)


def _says_where(tree: Tree) -> bool:
    """Whether words are a preposition and its thing, to the last: "on the way to work"."""
    things = tree.children(0, "pobj") if tree.root == 0 else ()
    return (
        bool(things) and max(tree.below(0)) == len(tree.nodes) - 1 and not any(n.is_verb for n in tree.nodes)
    )


def _governs(tree: Tree) -> bool:
    return bool(tree.children(0, "dobj"))


def _joined(tree: Tree, front: Tree, order: Tree) -> Tree:
    """Give one tree of what is done and where."""
    begin = tree.text.index(front.text)
    start = tree.text.index(order.text, begin + front.nodes[-1].end)
    verb = len(front.nodes)
    led = [_moved(node, begin, 0) for node in front.nodes]
    led[0] = replace(led[0], head=verb, relation="prep")
    behind = [_moved(node, start, verb) for node in order.nodes]
    return tree.with_nodes((*led, *behind))


def _moved(node: Node, by: int, places: int) -> Node:
    return replace(node, start=node.start + by, end=node.end + by, head=node.head + places)
