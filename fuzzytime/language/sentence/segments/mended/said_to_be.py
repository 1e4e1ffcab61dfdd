"""What somebody else is to do, or said will be, as what is told to come.

"Plumber to fix the tap at ten" and "the plumber said he'd be here at ten" are read as "the plumber will …".
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.sentence.trees.named import SAID_BY, calls_somebody
from fuzzytime.language.sentence.trees.tags import PRESENT, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

WILL = "will"
"""What "would" is of what was said to come, and "to" behind who is to do it."""

NAMING = frozenset({"DT", "PRP$", "JJ", "NN", "NNP"})
"""Tags of the words for who does it."""


def with_what_is_said(tree: Tree) -> Tree:
    """Give a tree in which what somebody else said to be so, or to come, is what is told.

    Who says it of themselves does it: "Ann texted to say she'll be late" is about Ann. What who speaks said,
    or is told to do, stays.
    """
    closed, root, told = tree.lexicon.closed, tree.root, tree.root
    who = tree.children(root, *SUBJECTS)
    if not who or not tree.said(who).isdisjoint(closed.first_and_second_person):
        return tree
    verbs = tree.lexicon.doing.foretelling
    while tree.nodes[told].lower in verbs:
        below = [p for p in tree.children(told, "ccomp", "xcomp", "advcl") if p > told]
        # "Ann texted to say she'll be here"; but "Ann says so if the bus comes"
        below = [p for p in below if tree.nodes[p].relation == "ccomp" or tree.nodes[p].lower in verbs]
        if not below:
            return tree
        told = below[0]
    subjects, helping = tree.children(told, *SUBJECTS), tree.children(told, "aux")
    future = [p for p in helping if tree.nodes[p].lower in closed.future | closed.backshifted]
    so = len(future) == len(helping) > 0 or (not helping and tree.nodes[told].tag in PRESENT)
    if told == root or not subjects or not so or tree.children(told, "neg"):
        return tree
    if not tree.said(subjects).isdisjoint(closed.first_and_second_person):
        return tree
    by_name = tree.nodes[subjects[0]].lower in closed.third_person - {"it"}
    doer = who[0] if by_name else subjects[0]
    named = set(tree.below(doer))
    tree = tree.hung([p for p in range(told) if p not in {*named, *helping}], told, SAID_BY)
    tree = tree.changed(doer, head=told, relation="nsubj").changed(told, head=told, relation="ROOT")
    return _with_will(tree, future)


def with_doer_in_front(tree: Tree) -> Tree:
    """Give "Ann to ring Bob at three", as a plan has it, the tree of "Ann will ring Bob at three".

    Who is asked is called otherwise, and nothing does what is to be done with it: "bread to buy".
    """
    lexicon = tree.lexicon
    to = next((place for place, node in enumerate(tree.nodes) if node.tag == "TO"), 0)
    verb, doer = to + 1, to - 1
    done = tree.nodes[verb : verb + 1] if verb + 1 < len(tree.nodes) else ()
    if not to or not any(node.tag == "VB" and node.relation != "aux" for node in done):
        return tree
    others = lexicon.beside.awaited_in_a_stretch | lexicon.taken
    named = tree.nodes[doer].lower in others - lexicon.happening - lexicon.workers
    named = named or calls_somebody(tree.nodes[doer], lexicon)
    if not named or any(node.tag not in NAMING for node in tree.nodes[:to]):
        return tree
    top = {tree.root, doer, tree.nodes[doer].head}
    tree = tree.hung([p for p, node in enumerate(tree.nodes) if node.head in top and p > verb], verb)
    tree = tree.hung(range(doer), doer, "compound").changed(doer, head=verb, relation="nsubj")
    tree = tree.changed(verb, head=verb, relation="ROOT").changed(to, head=verb, tag="MD", relation="aux")
    return _with_will(tree, [to])


def _with_will(tree: Tree, helping: Sequence[int]) -> Tree:
    """Give a tree in which some verbs that help say what is to come."""
    return tree.with_nodes(
        replace(node, text=WILL) if place in helping else node for place, node in enumerate(tree.nodes)
    )
