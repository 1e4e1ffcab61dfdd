"""What something needs: "the cars need washing", of which a tree makes a thing, or the need what helps.

Who speaks needs things: "we need cleaning products"; and so does what has a noun behind.
"""

from collections.abc import Set as AbstractSet

from fuzzytime.english import PARTICIPLE, is_participle
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.tree import Tree

OF_THINGS = frozenset({"det", "poss", "amod", "compound", "nummod"})
"""Relations of the words before a thing that are said of it."""

JOINED = frozenset({"conj", "cc", "punct"})
"""Relations of what goes on behind."""


def with_needed_deed(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "the cars need washing" what must be done with which thing."""
    for need in range(1, len(tree.nodes) - 1):
        if tree.root in {need, need + 1} and _needs_deed(tree, need, timed):
            return _mended(tree, need)
    return tree


def _needs_deed(tree: Tree, need: int, timed: AbstractSet[int]) -> bool:
    """Whether a thing stands before a verb of needs, and behind it what is done, of which nothing is."""
    thing, word, deed = tree.nodes[need - 1 : need + 2]
    behind = [
        node for place, node in enumerate(tree.nodes[need + 2 : need + 3], need + 2) if place not in timed
    ]
    # "The oven needs cleaning": a tree may have several needs there, that are like an oven.
    called = thing.tag.startswith("NN") or (thing.relation == "amod" and thing.head == need)
    called = called or thing.lower in tree.lexicon.closed.universal_pronouns | {"it", "they"}
    needs = word.lower.removesuffix("s") in tree.lexicon.doing.needing and not tree.children(
        need, "neg", "aux"
    )
    done = is_participle(deed.lower) and need + 1 not in timed
    return called and needs and done and not any(node.tag.startswith(("NN", "DT", "PRP")) for node in behind)


def _mended(tree: Tree, need: int) -> Tree:
    thing, deed = need - 1, need + 1
    nodes = tree.nodes
    for place, node in enumerate(nodes):
        if place in {thing, need, deed} or node.head not in {need, deed}:
            continue
        of_thing = place < thing and node.relation in OF_THINGS
        head = thing if of_thing else need if place < need or node.relation in JOINED else deed
        tree = tree.changed(place, head=head)
    finite = "VBZ" if nodes[need].lower.endswith("s") else "VBP"
    tree = tree.changed(
        need, tag=finite, lemma=nodes[need].lower.removesuffix("s"), relation="ROOT", head=need
    )
    named = "NN" if nodes[thing].tag == "JJ" else nodes[thing].tag
    tree = tree.changed(thing, tag=named, relation="nsubj", head=need)
    lemma = nodes[deed].lemma if nodes[deed].tag == "VBG" else _bare(nodes[deed].lower, tree.lexicon)
    return tree.changed(deed, tag="VBG", lemma=lemma, relation="xcomp", head=need)


def _bare(deed: str, lexicon: Lexicon) -> str:
    """Give the bare form of a verb that is known, or else what is left of it: "washing", "mopping"."""
    stem = deed.removesuffix(PARTICIPLE)
    forms = (stem, f"{stem}e", stem[:-1] if stem[-1:] == stem[-2:-1] else stem)
    return next((form for form in forms if form in lexicon.orders), stem)
