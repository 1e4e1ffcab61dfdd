"""Words behind a thing that a tree takes for others: "light the deck oven", "the fence round the pond"."""

from fuzzytime.language.sentence.trees.tags import DETERMINERS, SINGULAR
from fuzzytime.language.sentence.trees.tree import Tree

NAMES = SINGULAR | {"NNS"}
"""Tags of what is named."""


def with_last_noun(tree: Tree) -> Tree:
    """Give "light the deck oven" its thing, whose last word a tree has for a verb that none knows.

    Or for a word that says how: "sign the permission slip".
    """
    tree = _with_last_of_place(tree)
    for thing in tree.children(tree.root, "dobj"):
        place = thing + 1
        if place >= len(tree.nodes) or tree.nodes[thing].tag not in SINGULAR:
            continue
        node = tree.nodes[place]
        done = (node.is_verb or node.relation == "aux") and not node.may_act and not tree.children(place)
        if node.head != tree.root or not (done or _hangs_like_how(tree, place)):
            continue
        named = tree.hung((p for p in tree.children(thing) if p < thing), place)
        named = named.hung((p for p in tree.children(place) if p > place), tree.root)
        named = named.changed(place, tag="NN", relation="dobj", lemma=node.lower)
        return named.changed(thing, relation="compound", head=place)
    return tree


def _with_last_of_place(tree: Tree) -> Tree:
    """Give "on the plate rack" its last noun, which a tree has beside the one before it, as if joined."""
    for place in range(1, len(tree.nodes)):
        node, thing = tree.nodes[place], tree.nodes[place - 1]
        beside = node.relation == "conj" and node.head in {place - 1, tree.root} and not tree.children(place)
        alone = thing.relation == "pobj" and thing.tag in SINGULAR and not tree.children(node.head, "cc")
        if beside and alone and node.tag in NAMES and tree.children(place - 1, "det", "poss"):
            named = tree.hung((p for p in tree.children(place - 1) if p < place - 1), place)
            named = named.changed(place, relation="pobj", head=thing.head)
            return named.changed(place - 1, relation="compound", head=place)
    return tree


def _hangs_like_how(tree: Tree, place: int) -> bool:
    """Whether a noun hangs on a verb like a word that says how, and says neither where nor when."""
    node, lexicon = tree.nodes[place], tree.lexicon
    known = node.lower in lexicon.entries or node.lower in lexicon.places or node.lower in lexicon.particles
    aside = node.tag in NAMES and node.relation == "advmod" and bool(tree.children(place - 1, "det", "poss"))
    return aside and not known and node.lower not in lexicon.closed.adverbs_of_arrival


def with_things_around(tree: Tree) -> Tree:
    """Give "put the fence round the pond" its place, where a tree has "round" for a thing, or for how."""
    for place in range(1, len(tree.nodes) - 2):
        known = tree.nodes[place].lower in tree.lexicon.closed.around and tree.root < place
        if not known or tree.nodes[place].tag == "IN" or tree.nodes[place + 1].tag not in DETERMINERS:
            continue
        around = tree.nodes[place + 1].head
        if around <= place or tree.nodes[around].tag not in NAMES:
            continue
        before = tree.nodes[place - 1]
        if before.relation == "compound" and before.head == place:
            led = [p for p in tree.children(place) if p < place - 1]
            tree = tree.hung(led, place - 1).changed(place - 1, relation="dobj", head=tree.root)
        behind = [p for p in tree.children(around) if p > around]
        tree = tree.hung(behind, tree.root)
        tree = tree.changed(place, tag="IN", relation="prep", head=tree.root)
        tree = tree.changed(around, relation="pobj", head=place)
    return tree
