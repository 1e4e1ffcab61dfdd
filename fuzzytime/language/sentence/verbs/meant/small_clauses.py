"""What a verb brings about, and when: "let the dough rest", "have the slides ready", "keep the soup warm".

The object and what it does or becomes are a clause without a tense of its own; trees join it to its verb in
many ways.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.requirement import Reference

COMPLEMENTS = ("ccomp", "xcomp", "oprd", "acomp")
MODIFIERS = ("amod", "acl")
GOVERNED = ("aux", "csubj")
"""How a tree that takes the clause for the sentence joins the verb to it: "have the robot mop the floor"."""

PREDICATES = frozenset({"VB", "VBP", "VBN", "VBD", "VBG", "JJ", "RB"})

RESULTS = frozenset({"JJ", "VBN"})
"""Tags of what something is in the end."""


@dataclass(frozen=True, slots=True)
class SmallClause:
    """The noun that a clause is about, and what it does or becomes, as places in a tree."""

    noun: int
    predicate: int

    def about(self, tree: Tree) -> frozenset[int]:
        """Give the words of the noun."""
        noun = frozenset(tree.below(self.noun))
        return noun - frozenset(tree.below(self.predicate)) if self.predicate in noun else noun

    def result(self, tree: Tree) -> list[int]:
        """Give the words of what the noun does or becomes."""
        said = set(tree.below(self.predicate)) - self.about(tree)
        return sorted(place for place in said if place > self.noun)


def small_clause(tree: Tree, verb: int) -> SmallClause | None:
    """Give the clause that a verb brings about, None where it has none."""
    if tree.nodes[verb].lemma in tree.lexicon.doing.setting:
        return _set_going(tree, verb)
    if tree.nodes[verb].lemma in tree.lexicon.causing | tree.lexicon.letting:
        return next(_clauses(tree, verb), None)
    return None


def _set_going(tree: Tree, verb: int) -> SmallClause | None:
    """Give what is set going: "set the centrifuge going"."""
    objects = [place for place in tree.children(verb, "dobj") if place > verb]
    verbs = tree.lexicon.doing.set_going
    going = (p for p in tree.children(verb, "advcl", "xcomp", "ccomp") if tree.nodes[p].lemma in verbs)
    found = next((p for p in going if tree.nodes[p].tag == "VBG" and p - 1 in objects), None)
    return None if found is None else SmallClause(objects[0], found)


def _clauses(tree: Tree, verb: int) -> Iterator[SmallClause]:
    objects = [place for place in tree.children(verb, "dobj") if place > verb]
    below = list(tree.children(verb, *COMPLEMENTS))
    if tree.said(range(verb + 1, min(verb + 2, len(tree.nodes)))) & tree.lexicon.doing.sure:
        # "Make sure the children are in bed" has a clause with a tense of its own.
        return
    if tree.nodes[verb].relation in GOVERNED:
        below.append(tree.nodes[verb].head)
    for predicate in below:
        if tree.nodes[predicate].tag not in PREDICATES or tree.children(predicate, "auxpass", "mark"):
            continue
        nouns = [place for place in tree.children(predicate, *SUBJECTS) if place > verb] or objects
        if nouns and nouns[0] < predicate:
            yield SmallClause(nouns[0], predicate)
    for noun in objects:
        for predicate in tree.children(noun, *MODIFIERS):
            if predicate > noun and tree.nodes[predicate].tag in PREDICATES:
                yield SmallClause(noun, predicate)


def gets_to_do(tree: Tree, verb: int, below: int) -> bool:
    """Whether somebody is got to do something: "get Bob to mow the lawn", "get the sprinklers going"."""
    named = any(verb < place < below for place in tree.children(below, *SUBJECTS))
    return tree.nodes[verb].lemma == "get" and named and tree.nodes[below].tag in {"VB", "VBG"}


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
