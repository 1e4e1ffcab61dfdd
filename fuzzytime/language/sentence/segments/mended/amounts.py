"""Amounts of several things behind an order: "mix 500 g flour, 350 g water and 10 g salt"."""

from collections.abc import Iterator

from fuzzytime.language.sentence.trees.tags import DETERMINERS, NOUNS
from fuzzytime.language.sentence.trees.tree import Tree

NAMING = NOUNS | {"JJ", "VBN", "VBG"}
"""Tags of words of which a thing is named behind its amount."""

LEAST = 4
"""Words of "add 20 g salt"."""


def with_amounts(tree: Tree) -> Tree:
    """Give an order the things whose amounts stand right behind it, which a tree hangs here and there."""
    nodes = tree.nodes
    if len(nodes) < LEAST or not nodes[0].may_act or nodes[0].lower != nodes[0].lemma.lower():
        return tree
    things = [*_things(tree)]
    if not things or not any(unit for _, _, _, unit in things):
        return tree
    end, thing = things[-1][2], things[0][1]
    behind = [p for p in range(end, len(nodes)) if nodes[p].head < end or nodes[p].head == tree.root]
    if tree.root < end:
        tree = tree.changed(0, tag="VB", relation="ROOT", head=0).hung(
            (p for p in behind if p != nodes[p].head), 0
        )
    for place in range(1, end):
        if nodes[place].lower in tree.lexicon.closed.joints_of_things:
            tree = tree.changed(place, relation="punct" if nodes[place].text == "," else "cc", head=thing)
    for start, last, stop, _ in things:
        for place in range(start, last):
            tree = tree.changed(
                place, relation="nummod" if nodes[place].tag == "CD" else "compound", head=last
            )
        for place in range(last + 1, stop):
            # "A pinch of salt"
            relation = "prep" if place == last + 1 else "pobj"
            tree = tree.changed(place, relation=relation, head=place - 1)
        tag = nodes[last].tag if nodes[last].tag in NOUNS else "NN"
        relation, head = ("dobj", 0) if last == thing else ("conj", thing)
        tree = tree.changed(last, tag=tag, relation=relation, head=head)
    return tree


def _things(tree: Tree) -> Iterator[tuple[int, int, int, bool]]:
    """Give for each thing where it begins, its noun, where it ends, and whether it is measured."""
    nodes, place = tree.nodes, 1
    while place < len(nodes):
        start = place
        counted = nodes[place].tag == "CD"
        if not counted and (start == 1 or not _begins_thing(tree, place)):
            return
        while place < len(nodes) and nodes[place].tag == "CD":
            place += 1
        place += nodes[place].tag in DETERMINERS
        unit = counted and place < len(nodes) and nodes[place].lower in tree.lexicon.no_times.measured_in
        place += unit
        first = place
        while place < len(nodes) and (
            nodes[place].tag in NAMING or (unit and place == first and nodes[place].is_verb)
        ):
            place += 1
        if place == first:
            return
        last = place - 1
        yield start, last, place, unit
        joints = place
        while place < len(nodes) and nodes[place].lower in tree.lexicon.closed.joints_of_things:
            place += 1
        if place == joints:
            return


def _begins_thing(tree: Tree, place: int) -> bool:
    """Whether a further thing begins at a place: "and the chickpeas", ", salt"; but "and stir"."""
    node, behind = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    orders, joints = tree.lexicon.orders | tree.lexicon.alone, tree.lexicon.closed.joints_of_things
    bare = node.tag in {"NN", "NNS"} and node.lower not in orders
    return node.tag in DETERMINERS or (bare and all(one.tag == "IN" or one.lower in joints for one in behind))
