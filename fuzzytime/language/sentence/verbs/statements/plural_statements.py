"""Trees of what several things do, where the verb was taken for how they are: "the shops open at nine"."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.trees.tree import Tree

BESIDE_NAMES = frozenset({"IN", "DT", "PRP$", "JJ", "NN", "NNP", "CD"})
"""Tags of words that say where those are who do something: "the guests in room 12"."""


def with_plural(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give the tree of "the shops open at nine" its verb, which was taken for how they are."""
    root = tree.root
    if tree.nodes[root].tag != "NNS" or not tree.children(root, "det", "poss"):
        return tree
    verb = root + 1
    if (
        verb + 1 not in timed
        or tree.nodes[verb].lower not in tree.lexicon.doing.several_timed
        or tree.nodes[verb].head != root
    ):
        return tree
    told = tree.hung((p for p in tree.children(root) if p > verb), verb)
    told = told.changed(verb, tag="VBP", lemma=tree.nodes[verb].lower, head=verb, relation="ROOT")
    return told.changed(root, head=verb, relation="nsubj")


def is_led_by_plural(tree: Tree, verb: int) -> bool:
    """Whether several who do something stand before a word that may be a verb, with where they are."""
    led = (p for p in tree.children(verb, "nsubj") if tree.nodes[p].tag == "NNS" and p < verb)
    return any(all(node.tag in BESIDE_NAMES for node in tree.nodes[p + 1 : verb]) for p in led)
