"""Trees mended where several things, or orders, are joined: "milk and eggs", "the tables, chairs out"."""

from collections.abc import Set as AbstractSet

from fuzzytime.english import looks_plural
from fuzzytime.language.sentence.trees.tags import NOUNS, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

TWO = 2
"""Words of a chain at least: "trim and mow"."""


def with_joined(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give "bath and bed", "milk and eggs" both things, where a tree has the first for what is done.

    Nothing but a time stands behind them. Of "trim and mow" a tree has the second for a thing, of "scrub,
    rinse and dry" the last for what something is like.
    """
    tree = _with_last_done(tree)
    joined = (
        tree.nodes[1:2]
        and tree.nodes[1].lower in tree.lexicon.closed.additive_conjunctions
        and 2 in tree.children(0, "conj")
    )
    if not joined or not tree.nodes[0].is_bare or tree.root or tree.children(0, "dobj", "prt"):
        return tree
    alone = all(
        place in timed or not tree.nodes[place].text[0].isalnum() for place in range(3, len(tree.nodes))
    )
    if not tree.nodes[2].tag.startswith("NN") or not alone:
        return tree
    place, tag = (2, "VB") if tree.nodes[2].lower in tree.lexicon.orders else (0, "NN")
    return tree.changed(place, tag=tag)


def _with_last_done(tree: Tree) -> Tree:
    """Give orders in a row that are all of their words the last of them, which may be an adjective, too."""
    chain, joints = [0], tree.lexicon.closed.joints_of_things
    while chain[-1] + 2 < len(tree.nodes) and tree.nodes[chain[-1] + 1].lower in joints:
        chain.append(chain[-1] + 2)
    last = chain[-1]
    acts = all(tree.nodes[p].may_act and tree.nodes[p].lower == tree.nodes[p].lemma for p in chain)
    acts = acts and tree.nodes[0].tag != "JJ"
    ended = last + 1 == len(tree.nodes) or tree.nodes[last + 1].tag in {"IN", "."}
    if len(chain) < TWO or not acts or not ended or tree.nodes[last].tag != "JJ":
        return tree
    return tree.changed(last, tag="VB", relation="conj", head=chain[-2])


def with_list(tree: Tree) -> Tree:
    """Give "water the roses, the lawn and the pots" all its things, where a tree hangs some on the verb."""
    root = tree.root
    things = tree.children(root, "dobj")
    if not tree.nodes[root].is_verb or len(things) != 1:
        return tree
    thing, comma = things[0], things[0] + 1
    if comma >= len(tree.nodes) or tree.nodes[comma].text != ",":
        return tree
    bare = comma + 1
    if bare in tree.children(root, "conj") and _is_bare_plural(tree, bare, root):
        # "Put the tables, chairs out": what stands behind them is of all.
        tree = tree.hung(tree.children(bare), root)
        return tree.changed(bare, tag="NNS", head=thing, relation="conj").changed(comma, head=thing)
    further = [*tree.children(root, "conj", "dep"), *tree.children(thing, "conj", "appos")]
    listed = next((p for p in further if tree.nodes[p].tag in NOUNS and _is_led(tree, p, comma + 1)), None)
    if listed is None or not tree.children(listed, "conj"):
        return tree
    return tree.changed(listed, head=thing, relation="conj").changed(comma, head=thing)


def _is_bare_plural(tree: Tree, place: int, verb: int) -> bool:
    """Whether things without an article stand before a particle of a verb, and do nothing: "chairs out"."""
    node, particle = tree.nodes[place], "".join(other.lower for other in tree.nodes[place + 1 : place + 2])
    plural = node.may_name and looks_plural(node.lower) and node.tag in {"NNS", "VBZ"}
    carried = tree.nodes[verb].lemma in tree.lexicon.particles.get(particle, ())
    return plural and carried and not tree.children(place, *SUBJECTS, "dobj", "conj")


def _is_led(tree: Tree, place: int, first: int) -> bool:
    """Whether a noun begins at a place with its article, or whose it is."""
    return first in tree.children(place, "det", "poss")
