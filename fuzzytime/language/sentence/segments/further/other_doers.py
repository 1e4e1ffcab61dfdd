"""What somebody else does in the same sentence: "Ana peels the carrots, Ben boils the pasta"."""

from collections.abc import Iterator

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

TOLD = frozenset({"ccomp", "parataxis", "dep", "conj"})
"""How a tree hangs what one does on what another does, or the other way round."""


def other_doers(tree: Tree) -> Iterator[int]:
    """Give the places at which begins what another one does than who was named before."""
    for verb in range(2, len(tree.nodes)):
        other = _beside(tree, verb)
        who = [place for place in tree.children(verb, *SUBJECTS) if place < verb]
        if other is None or not who or not _is_doer(tree, who[0]):
            continue
        start = min(tree.below(who[0]))
        if other < start and tree.nodes[start - 1].lower in {*tree.lexicon.closed.joints_of_things, ";"}:
            yield start


def _beside(tree: Tree, verb: int) -> int | None:
    """Give what another does that is told beside a verb, where neither is a part of more."""
    root = tree.root
    if tree.nodes[verb].tag != "VBZ":
        return None
    others = [root] if tree.nodes[verb].relation in TOLD and tree.nodes[verb].head == root else []
    others += [*tree.children(root, *TOLD)] if verb == root else []
    free = (p for p in others if p < verb and tree.nodes[p].tag == "VBZ" and not tree.children(p, "mark"))
    return next((p for p in free if any(_is_doer(tree, who) for who in tree.children(p, *SUBJECTS))), None)


def _is_doer(tree: Tree, place: int) -> bool:
    """Whether it is a person, or a machine that does things."""
    node, lexicon = tree.nodes[place], tree.lexicon
    return node.tag == "NNP" or node.lower in lexicon.persons | lexicon.workers | lexicon.machines
