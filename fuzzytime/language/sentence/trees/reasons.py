"""What says why something is to be done: "because it rains", "as places are limited"."""

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

AS = "as"
"""What says when, too: "as the pan heats", "serve them as they are ready"."""


def begins_reason(tree: Tree, place: int) -> bool:
    """Whether a word begins why something is done: "as" does before what is, will be or can be so."""
    node, lexicon = tree.nodes[place], tree.lexicon
    if node.lower != AS or node.relation != "mark":
        return node.lower in lexicon.closed.subordinators_of_reason
    verb, behind = node.head, tree.nodes[node.head].head < place
    helped = any(tree.nodes[p].tag == "MD" for p in tree.children(verb, "aux"))
    # "Leave it as it should be", "act as if it were yours", "ring as you are on your way"
    so = tree.said(tree.children(verb, "acomp", "attr", *(["prep"] if helped else [])))
    is_so = bool(so) and lexicon.results.isdisjoint(so)
    known = is_so if tree.nodes[verb].lemma == "be" else helped
    return behind and known and any(p > place for p in tree.children(verb, *SUBJECTS))
