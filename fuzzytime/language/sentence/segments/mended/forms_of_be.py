"""Forms of "be" that trees take for others: "I'm going to be out" is to come, "the vet's" is a place."""

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree

LEAST = 2
"""Words of "at mum", before the mark of whose place it is."""

AS = "as"
"""A marker of clauses that says more often what something is."""

OF_ORDERS = frozenset({"dobj", "prep", "npadvmod", "advmod", "prt", "tmod", "punct"})
"""Relations of words to an order before them."""


def with_clipped(tree: Tree) -> Tree:
    """Give "im at the gym" its "am", which is typed without an apostrophe."""
    for place in range(1, len(tree.nodes)):
        known = tree.nodes[place].lower in tree.lexicon.closed.clipped_be and tree.nodes[place].tag == "VBP"
        if known and tree.nodes[place - 1].tag == "PRP":
            tree = tree.changed(place, lemma="be")
    return tree


def with_there(tree: Tree) -> Tree:
    """Give "be there by ten" where to be, which a tree takes for the "there" of "there is a party"."""
    for place, node in enumerate(tree.nodes):
        alone = node.relation == "expl" and node.head == place - 1 and tree.nodes[node.head].tag == "VB"
        if alone and not tree.children(node.head, *SUBJECTS, "attr"):
            tree = tree.changed(place, relation="advmod")
    return tree


def with_future(tree: Tree) -> Tree:
    """Give "I'm going to be out" the tree of "I'll be out", where "going" was taken for what is done."""
    for going, node in enumerate(tree.nodes):
        be = tree.children(going, "aux")
        subjects = tree.children(going, *SUBJECTS, "expl")
        if node.lower not in tree.lexicon.closed.future or not be or not subjects:
            continue
        closed = tree.lexicon.closed
        is_so = tree.said(be) <= closed.present_be | closed.past_be and max(subjects) < min(be)
        below = [p for p in tree.children(going, "xcomp") if p > going]
        # "They're going to be shut at noon"
        done = [p for p in below if tree.nodes[p].tag == "VB" or tree.children(p, "auxpass")]
        if not is_so or not done:
            # "Are you going to call?", "I'm going to bed"
            continue
        verb, head = done[0], node.head
        to = [p for p in tree.children(verb, "aux") if p < verb and tree.nodes[p].lower == "to"]
        behind = [p for p in tree.children(going) if p != verb and p not in be]
        tree = tree.hung((*be, *to), going, "dep").hung(behind, verb)
        tree = tree.changed(verb, relation=node.relation, head=verb if head == going else head)
        tree = tree.changed(going, tag="MD", relation="aux", head=verb)
    return tree


def with_owners_place(tree: Tree) -> Tree:
    """Give "visit the vet's before noon" its order, where the mark of whose place it is was taken for "is".

    So of "I'm at mum's till four".
    """
    marked = tree.lexicon.closed.clipped_be
    marks = [p for p, node in enumerate(tree.nodes) if node.lower in marked and not node.text[0].isalnum()]
    place = next((p for p in marks if tree.nodes[p - 1].relation == "pobj"), tree.root)
    if place < LEAST or place not in marks:
        return tree
    if place != tree.root and not tree.children(place, *SUBJECTS):
        tree = tree.hung(tree.children(place), tree.root)
        return tree.changed(place, tag="POS", lemma=tree.nodes[place].lower, relation="case", head=place - 1)
    order, owner = tree.nodes[0], tree.nodes[place - 1]
    led = order.head == place and order.may_act and order.lower == order.lemma
    told = any(tree.nodes[p].relation not in OF_ORDERS for p in tree.children(place) if p)
    if not led or not owner.tag.startswith("NN") or place - 1 not in tree.below(0) or told:
        return tree
    tree = tree.hung([p for p in tree.children(place) if p], 0)
    tree = tree.changed(0, tag="VB", relation="ROOT", head=0)
    return tree.changed(place, tag="POS", lemma=tree.nodes[place].lower, relation="case", head=place - 1)


def with_states(tree: Tree) -> Tree:
    """Give "once the tank's full or after an hour" its "is", which was taken for the mark of an owner.

    Nothing that is owned stands behind the state.
    """
    for place, node in enumerate(tree.nodes[:-1]):
        owner, state = tree.nodes[place - 1], tree.nodes[place + 1]
        owned = [behind.tag.startswith(("NN", "JJ")) for behind in tree.nodes[place + 2 : place + 3]]
        marked = node.tag == "POS" and owner.tag.startswith("NN") and state.tag == "JJ" and not any(owned)
        marker = _marker_before(tree, place - 1) if marked else None
        if marker is None or node.lower not in tree.lexicon.closed.clipped_be:
            continue
        outside = [top for top in tree.above(place) if not marker < top <= place + 1]
        tree = tree.changed(place, tag="VBZ", lemma="be", relation="advcl", head=next(iter(outside), place))
        tree = tree.changed(place - 1, relation="nsubj", head=place)
        tree = tree.changed(place + 1, relation="acomp", head=place)
        tree = tree.changed(marker, relation="advmod", head=place)
    return tree


def _marker_before(tree: Tree, subject: int) -> int | None:
    """Give the word that begins a clause, before the words of its subject: "once the tank"."""
    named = subject
    while named and tree.nodes[named - 1].head == subject and tree.nodes[named - 1].tag not in {"IN", "WRB"}:
        named -= 1
    marker = tree.nodes[named - 1].lower if named else ""
    # "Keep it as Ann's own"
    return named - 1 if (marker,) in tree.lexicon.clauses and marker != AS else None
