"""What is said behind a comma of what is named or told before it: "break duty at 10:50, Karen covers it"."""

from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE, SINGULAR, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

LEAST_NAMED = 2
"""Words of "dinner today", at least."""

NAMING = frozenset({*SINGULAR, *DETERMINERS, "JJ", "IN"})
"""Tags of words that name one thing: "dentist for Mia"."""

BESIDE = frozenset({"advcl", "ccomp", "npadvmod", "dep", "nsubj", "nsubjpass", "nmod", "parataxis"})
"""How trees hang what is named in front on a clause behind it."""


def behind_named(tree: Tree, root: int, timed: set[int]) -> int | None:
    """Give an order that has what is named with a time before it: "dentist at three, pick up the kids at 4".

    A machine is named to be asked: "robot at three, dock".
    """
    comma = root - 1
    if comma < LEAST_NAMED or tree.nodes[comma].text != "," or not tree.nodes[root].may_act:
        return None
    named = next((place for place in range(comma) if place in timed), 0)
    if not named or not timed.issuperset(range(named, comma)):
        return None
    things = tree.nodes[:named]
    asked = {node.lower for node in things} & (tree.lexicon.machines | tree.lexicon.addresses)
    if asked or things[-1].tag not in SINGULAR or any(node.tag not in NAMING for node in things):
        return None
    bare = tree.nodes[root].tag in IMPERATIVE and tree.nodes[root].lower == tree.nodes[root].lemma
    return root if bare and not tree.children(root, "aux", "mark", "neg") else None


def behind_heading(tree: Tree, root: int, timed: set[int]) -> int | None:
    """Give the clause behind what is named with a time: "table of twelve at 7:15, starters must go at once".

    So it is behind an order that a tree took for a thing: "ring Ollie's mum back, she's only free at ten".
    """
    comma = next((p for p in range(root - 1, 0, -1) if tree.nodes[p].text == ","), 0)
    if comma < LEAST_NAMED or any(node.text in {",", ":", ";"} for node in tree.nodes[:comma]):
        return None
    tops = {p for p in range(comma) if tree.nodes[p].head >= comma}
    head = next(iter(tops), root)
    node = tree.nodes[head]
    hangs = node.head == root or tree.nodes[node.head].head == root
    if len(tops) > 1 or not hangs or node.relation not in BESIDE or not node.tag.startswith("NN"):
        return None
    if tree.children(head, "mark", "advmod") and min(tree.children(head, "mark", "advmod")) < head:
        return None
    acts = node.relation in {"advcl", "ccomp"} and bool(tree.children(head, "dobj"))
    named = comma - 1 in timed and not timed.issuperset(range(comma))
    return comma + 1 if (acts or named) and _is_clause(tree, comma + 1, root) else None


def _is_clause(tree: Tree, start: int, root: int) -> bool:
    """Whether somebody does something from a place on, or is to have it done: "…, have it filled"."""
    subjects = [p for p in tree.children(root, *SUBJECTS) if p > start - 1]
    if any(tree.reach(p)[0] == start for p in subjects):
        return tree.nodes[root].is_verb
    first = tree.nodes[start]
    helps = first.relation == "aux" and first.head == root and first.lemma == "have"
    return helps and first.lower == first.lemma and bool(subjects)


def having_done(tree: Tree, place: int) -> int | None:
    """Give where begins what is to be had done, behind a comma: "it is collected at 3, have it filled"."""
    if tree.nodes[place].tag != "VBN":
        return None
    for have in tree.children(place, "aux"):
        node = tree.nodes[have]
        led = have > 1 and tree.nodes[have - 1].lower in tree.lexicon.closed.joints_of_orders
        brought = any(have < p < place for p in tree.children(place, *SUBJECTS))
        if node.lemma == "have" and node.lower == node.lemma and led and brought:
            return have
    return None
