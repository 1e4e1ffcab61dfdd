"""Where the root of a tree is no first order: "weld it, wait" has its first below the second."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.trees.tags import GRAMMATICAL_SUBJECTS
from fuzzytime.language.sentence.trees.tree import Node, Tree
from fuzzytime.language.sentence.verbs.meant.orders_before import denied_from

ANY_SUBJECTS = (*GRAMMATICAL_SUBJECTS, "csubj")
COORDINATE = ("conj", "dep", "parataxis", "ccomp", "advcl", "appos")
"""Relations of what stands beside an order and may be another."""


def order_behind_order(tree: Tree, root: int, timed: AbstractSet[int]) -> int | None:
    """Give where the root begins, if it is a second order: "weld it, wait" has its first below it.

    So has a statement behind an order: "bring my coat, we leave at three". What is ``timed`` before the root
    is its time: "clean the oven, tomorrow mop the floor".
    """
    closed = tree.lexicon.closed
    # "Dust, lock the door": a tree may have an order for who does the second.
    subjects = [p for p in tree.children(root, *ANY_SUBJECTS) if not _names_nothing(tree, p)]
    start = min([root, *tree.below(subjects[0])]) if subjects else first_of(tree, root)
    helping = tree.children(root, "aux", "auxpass")
    brought = [p for p in helping if p == start - 1 and tree.nodes[p].lower in {"have", "be"}]
    denied = denied_from(tree, root)
    if denied is not None:
        # "Mix the paint, don't touch the lid"
        brought.append(denied)
    # "Scrub the potatoes, have them peeled", "tidy the kitchen, be gone by four"
    start = min([start, *brought])
    start = start if subjects else behind_joint(tree, start, timed)
    joint = tree.nodes[start - 1].lower if start else ""
    left = {tree.nodes[p].lower for p in tree.children(root, "aux") if p not in brought}
    telling = set(closed.predicting_modals)
    if tree.nodes[root].tag == "VBG":
        telling |= closed.present_be
    if tree.nodes[root].lemma in tree.lexicon.doing.waiting:
        # "Wash the dishes now, the pans can wait until tonight"
        telling |= {"can"}
    if joint not in closed.joints_of_orders or (subjects and joint != ",") or not left <= telling:
        return None
    orders = _orders_before(tree, root, start, joint, timed)
    if subjects and not brought:
        bare = (p for p in orders if tree.nodes[p].tag == "VB" and first_of(tree, p) == 0)
        orders = [*bare, *(p for p in orders if _is_passive(tree, p))]
    wished = any(_is_wished(tree, p) for p in tree.children(root, *COORDINATE) if p < start)
    ordered = wished or any(
        not tree.children(p, *ANY_SUBJECTS, "aux", "mark") and all(a > p for a in tree.children(p, "advmod"))
        for p in orders
    )
    return start if ordered else None


def _is_wished(tree: Tree, place: int) -> bool:
    """Whether somebody says that it is to be done: "we should mop the hall, the floor is sticky"."""
    whose = tree.said(tree.children(place, *ANY_SUBJECTS))
    helping = any(tree.nodes[p].tag == "MD" for p in tree.children(place, "aux"))
    return helping and bool(whose) and whose <= tree.lexicon.closed.first_and_second_person


def behind_joint(tree: Tree, start: int, timed: AbstractSet[int]) -> int:
    """Give where an instruction begins with the time in front: "…, and by seven have the soup ready"."""
    first = start
    while first and first - 1 in timed:
        first -= 1
    behind = first
    while behind and (behind - 1 in timed or tree.nodes[behind - 1].lower == ","):
        behind -= 1
    # "Boil it, and before that, wash it"
    if behind > 0 and tree.nodes[behind - 1].lower in tree.lexicon.closed.conjunctions_of_clauses:
        return behind
    # "Feed the cat at six, tomorrow, wash the car"
    own = first == start and tree.nodes[behind].text == "," and any(p in timed for p in range(behind))
    return behind + 1 if own and behind + 1 < start - 1 else first


def _orders_before(tree: Tree, root: int, start: int, joint: str, timed: AbstractSet[int]) -> list[int]:
    """Give what may be orders below a root, before where it begins behind a joint."""
    before = [p for p in tree.children(root, *COORDINATE, "csubj", "csubjpass") if p < start]
    # "Saw the board, sand the edges": a past form in front is an order, as nobody is named.
    # "Using a fork, mash them" says how.
    # "In the morning feed the hens, in the evening lock them in": the first word behind its time.
    firsts = (p for p in before if timed >= {*range(p)})
    verbs = [p for p in firsts if _is_verb(tree, p) and tree.nodes[p].tag != "VBG"]
    orders = [*(p for p in before if tree.nodes[p].tag == "VB"), *verbs]
    # "Get dressed, we start in ten minutes"
    orders += [p for p in before if _is_passive(tree, p)]
    if joint == ",":
        # "Deglaze with wine, reduce it": a verb that the model does not know; "hoover, put the bins out".
        taken = tree.children(root, "advmod", "nsubj", "npadvmod")
        orders += [p for p in taken if _is_unknown(tree, p, start)]
    orders += [0] if tree.nodes[0].head == root and _names_nothing(tree, 0) else []
    return orders


def _is_passive(tree: Tree, place: int) -> bool:
    """Whether a participle stands behind a "get" that begins an order: "get dressed"."""
    helping = tree.children(place, "auxpass")
    return tree.nodes[place].tag == "VBN" and 0 in helping and tree.nodes[0].lemma == "get"


def _is_verb(tree: Tree, place: int) -> bool:
    """Whether a word is a verb, or has an object: "lower the hook", "sign for it"."""
    objects = [*tree.children(place, "dobj")]
    for preposition in tree.children(place, "prep"):
        told = tree.children(preposition, "pobj")
        objects += (p for p in told if tree.nodes[p].lower in tree.lexicon.closed.object_pronouns)
    return tree.nodes[place].is_verb or (tree.nodes[place].may_act and bool(objects))


def _is_unknown(tree: Tree, place: int, end: int) -> bool:
    """Whether the first word of some before a comma is an order that was taken for a thing, or a place."""
    if place or not 1 < tree.reach(place)[1] <= end:
        return False
    # "Home the arm, pick the part up"
    named = tree.nodes[0].tag == "NN" and bool(tree.children(0, "prep"))
    return named or bool(tree.children(0, "dobj"))


def _names_nothing(tree: Tree, place: int) -> bool:
    """Whether the first word of all is an order that needs no thing: "dust, lock the door"."""
    alone = place == 0 and tree.nodes[0].lower in tree.lexicon.needing_nothing and not tree.children(0)
    return alone and tree.nodes[1].lower in tree.lexicon.closed.joints_of_orders


def first_of(tree: Tree, place: int) -> int:
    """Give where the instruction of a verb begins: adverbs right before it belong to it."""
    start = place
    while start and _is_own_adverb(tree.nodes[start - 1], place):
        start -= 1
    return start


def _is_own_adverb(node: Node, verb: int) -> bool:
    return node.tag in {"RB", "UH"} and node.head == verb and node.lower != "so"
