"""Which moment of what is done a verb says that its times are about: "start", "have it ready"."""

from collections.abc import Iterator

from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.small_clauses import small_clause
from fuzzytime.requirement import Reference

RESULTS = frozenset({"JJ", "VBN"})
"""Tags of what something is in the end."""


def reference_of(tree: Tree, place: int) -> Reference | None:
    """Give which moment of an operation its verb, or what it results in, says that its times are about."""
    lexicon = tree.lexicon
    lemma = tree.nodes[place].lemma
    named = lexicon.indicators.get(lemma) or lexicon.indicators.get(tree.nodes[place].lower)
    if named is not None:
        return Reference(named)
    node = tree.nodes[place]
    if node.lower in lexicon.results and node.tag in RESULTS and tree.children(place, "auxpass", "aux"):
        return Reference.FINISH
    if lemma == "be" and any(tree.nodes[p].lower in lexicon.results for p in tree.children(place, "acomp")):
        # "Charge it so that it is ready by noon"
        return Reference.FINISH
    if lemma in lexicon.causing and any(
        tree.nodes[p].lower in lexicon.results for p in _results(tree, place)
    ):
        return Reference.FINISH
    brought = small_clause(tree, place) if lemma in lexicon.causing else None
    # "Make the soup hot by six"; but "have the robot mop the floor" is what it does.
    return Reference.FINISH if brought and tree.nodes[brought.predicate].tag in RESULTS else None


def _results(tree: Tree, place: int) -> Iterator[int]:
    """Give what a verb brings about: "have the rice ready", "make sure that it is done"."""
    nouns = tree.children(place, "dobj")
    modifying = (p for noun in nouns for p in tree.children(noun, "amod", "acl") if p > noun)
    for below in (
        *tree.children(place, "acomp", "oprd", "ccomp", "attr", "xcomp", "advcl", "conj"),
        *modifying,
    ):
        yield below
        yield from _results(tree, below)
