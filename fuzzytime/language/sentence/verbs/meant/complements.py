"""The verb that stands below another: with "to", as a gerund, or bare behind "let"."""

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.small_clauses import small_clause

COMPLEMENTS = ("xcomp", "ccomp")


def complement(tree: Tree, place: int, lemma: str) -> int | None:
    """Give the verb below a verb, with "to" or as a gerund; "let us" has it bare."""
    for below in tree.children(place, *COMPLEMENTS):
        node = tree.nodes[below]
        if node.is_verb and (node.tag in {"VB", "VBG"} or lemma == "let") and below > place:
            return below
        if lemma in tree.lexicon.doing.wishing and node.tag in {"VBN", "VBP"}:
            return below
        if lemma == "have" and node.tag == "VBN" and tree.children(below, "auxpass") and has_to(tree, below):
            # "The dog has to be walked"
            return below
    return None


def assured(tree: Tree, place: int) -> int | None:
    """Give the verb below what it is time for, or to be sure of: "be careful to close it"."""
    for below in tree.children(place, "acomp", "ccomp", "oprd", "attr"):
        if tree.nodes[below].lower in tree.lexicon.doing.sure:
            verbs = tree.children(below, "xcomp", "relcl", "acl")
            return next((p for p in verbs if tree.nodes[p].tag == "VB"), None)
    return None


def has_to(tree: Tree, below: int) -> bool:
    """Whether it is "have to do", not "have it done"."""
    marks = [tree.nodes[p].lower for p in tree.children(below, "aux")]
    return "to" in marks and not tree.children(below, *SUBJECTS)


def is_numbered_place(tree: Tree, place: int) -> bool:
    """Whether what a tree takes for a verb is called by the number behind it: "take it to station 4"."""
    counted = place + 1 < len(tree.nodes) and tree.nodes[place + 1].tag == "CD"
    known = tree.lexicon.machines | tree.lexicon.measure_nouns
    led = "to" in tree.said(tree.children(place, "aux"))
    return counted and led and tree.nodes[place].lower in known


def brings_about(tree: Tree, place: int) -> bool:
    """Whether a verb is what is to be done: "leave the cake to cool", not "let us go"."""
    lets = tree.nodes[place].lemma == "let" and (lets_do(tree, place) or lets_forget(tree, place))
    return not lets and small_clause(tree, place) is not None


def lets_do(tree: Tree, place: int) -> bool:
    """Whether it is "let us" or "lets", not "let me know"."""
    following = tree.nodes[place + 1].lower if place + 1 < len(tree.nodes) else ""
    return tree.nodes[place].lower == "lets" or following in {"us", "'s", "’s"}


def lets_forget(tree: Tree, place: int) -> bool:
    """Whether it is "don't let me forget to post it", "don't let me forget the bins"."""
    below = complement(tree, place, "let")
    forgets = below is not None and tree.nodes[below].lemma in tree.lexicon.forgetting
    return forgets and below is not None and bool(tree.children(below, "xcomp", "dobj", "ccomp"))
