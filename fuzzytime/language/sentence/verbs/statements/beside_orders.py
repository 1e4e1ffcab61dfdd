"""What is told beside an order: why it is asked for, "…, it's hot", what another does, "… and Bob cooks"."""

from fuzzytime.language.sentence.trees.tags import GRAMMATICAL_SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

BEFORE_ORDER = ("ccomp", "advcl", "parataxis", "dep", "nsubj", "csubj")
"""How trees join a statement to an order behind it."""


def subjects_before(tree: Tree, verb: int) -> list[int]:
    """Give the subjects in front of a verb; "it" of "it's raining" may hang on "is" in a tree."""
    return [p for p in _below(tree, verb, *GRAMMATICAL_SUBJECTS) if p < verb]


def is_so_now(tree: Tree, place: int) -> bool:
    """Whether something is being done, or is so, which needs no time: "…, she's sleeping", "…, it's hot"."""
    be = tree.lexicon.closed.present_be
    helping = tree.said(tree.children(place, "aux"))
    described = tree.nodes[place].lower in be and bool(tree.children(place, "acomp"))
    return described or (tree.nodes[place].tag == "VBG" and bool(helping) and helping <= be)


def does_beside(tree: Tree, place: int, start: int) -> bool:
    """Whether somebody named does it while another order is done: "walk the dog and Bob feeds the cat"."""
    root, node, who = tree.root, tree.nodes[place], tree.nodes[start]
    ordered = root < start and tree.nodes[root].is_bare
    # "Tell Ann that I cook and Bob washes up"
    ordered = ordered and not tree.children(root, *GRAMMATICAL_SUBJECTS, "ccomp", "xcomp")
    named = who.tag == "NNP" or who.lower in tree.lexicon.people
    joined = (
        node.relation == "conj"
        and node.head == root
        and tree.nodes[start - 1].lower in tree.lexicon.closed.conjunctions_of_clauses
    )
    return ordered and joined and named and (node.tag == "VBZ" or bool(tree.children(place, "aux")))


def _below(tree: Tree, verb: int, *relations: str) -> list[int]:
    """Give what is below a verb, or below its helping verbs."""
    over = (verb, *tree.children(verb, "aux"))
    return [p for one in over for p in tree.children(one, *relations)]
