"""The last word of a thing, which a tree takes for another: "light the deck oven", "the permission slip"."""

from fuzzytime.language.sentence.trees.tags import SINGULAR
from fuzzytime.language.sentence.trees.tree import Tree

NAMES = SINGULAR | {"NNS"}
"""Tags of what is named."""


def with_last_noun(tree: Tree) -> Tree:
    """Give "light the deck oven" its thing, whose last word a tree has for a verb that none knows.

    Or for a word that says how: "sign the permission slip".
    """
    for thing in tree.children(tree.root, "dobj"):
        place = thing + 1
        if place >= len(tree.nodes) or tree.nodes[thing].tag not in SINGULAR:
            continue
        node = tree.nodes[place]
        done = (node.is_verb or node.relation == "aux") and not node.may_act and not tree.children(place)
        if node.head != tree.root or not (done or _names_how(tree, place)):
            continue
        named = tree.hung((p for p in tree.children(thing) if p < thing), place)
        named = named.hung((p for p in tree.children(place) if p > place), tree.root)
        named = named.changed(place, tag="NN", relation="dobj", lemma=node.lower)
        return named.changed(thing, relation="compound", head=place)
    return tree


def _names_how(tree: Tree, place: int) -> bool:
    """Whether a noun hangs on a verb like a word that says how, and says neither where nor when."""
    node, lexicon = tree.nodes[place], tree.lexicon
    known = node.lower in lexicon.entries or node.lower in lexicon.places or node.lower in lexicon.particles
    aside = node.tag in NAMES and node.relation == "advmod" and bool(tree.children(place - 1, "det", "poss"))
    return aside and not known and node.lower not in lexicon.closed.adverbs_of_arrival
