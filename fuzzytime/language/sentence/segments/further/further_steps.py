"""Steps of bare words: "wash, rinse, dry", "wait a minute, read plate", "open the lid, press start"."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE
from fuzzytime.language.sentence.trees.tree import Node, Tree

SURE = frozenset({"UH", "RB", "IN", "RP", "CD"})
"""Tags of words that are no step, whatever else they may be."""

THINGS = ("dobj", "npadvmod", "attr")
"""How a tree joins what is named to a verb."""


def is_further_step(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether a bare word behind a joint is a step behind the first, which a tree took for a thing."""
    root = tree.root
    if root >= place or tree.nodes[root].tag not in IMPERATIVE:
        return False
    if not _may_be_step(tree, place):
        return False
    joint, behind = tree.nodes[place - 1].lower, tree.nodes[place + 1 : place + 2]
    ends = not behind or _ends(behind[0], tree.lexicon)
    things = [p for p in tree.children(root, *THINGS) if p < place and p not in timed]
    if tree.nodes[root].lemma in tree.lexicon.doing.waiting and place - 2 in timed:
        # "Wait a minute, read plate": nobody waits a plate.
        return not things and (ends or behind[0].tag.startswith("NN") or behind[0].tag in DETERMINERS)
    if joint == "," and place == root + 2:
        # "Rinse, dry"
        return ends and not things
    return joint == "," and place - 2 not in timed and _names_control(tree, place, root, timed)


def _may_be_step(tree: Tree, place: int) -> bool:
    """Whether a bare word behind a joint may say what is done, and calls nobody and names no event."""
    lexicon = tree.lexicon
    node = tree.nodes[place]
    behind = tree.nodes[place + 1 : place + 2]
    kinds = [lexicon.persons, lexicon.addresses, lexicon.happening, lexicon.taken]
    if not behind or _ends(behind[0], lexicon):
        # "Wait a minute, robot"; but "press start"
        kinds.append(lexicon.machines)
    named = any(node.lower in kind for kind in kinds)
    known = node.may_act and node.lower == node.lemma.lower()
    joined = tree.nodes[place - 1].lower in {",", "and", "&"}
    bare = node.tag not in SURE and not tree.children(place, "det")
    return known and joined and bare and not named and not node.text[0].isupper()


def _names_control(tree: Tree, place: int, root: int, timed: AbstractSet[int]) -> bool:
    """Whether what follows is named like a verb, behind a thing with an article: "…, press start"."""
    behind, further = tree.nodes[place + 1 : place + 2], tree.nodes[place + 2 : place + 3]
    # "Clean the table, work surface and sink"
    pressed = tree.nodes[place].lower in tree.lexicon.ordering and bool(behind)
    named = pressed and behind[0].tag == "NN" and behind[0].may_act and place + 1 not in timed
    opened = any(tree.nodes[p].tag in DETERMINERS for p in range(root + 1, place - 1))
    return named and opened and (not further or place + 2 in timed or _ends(further[0], tree.lexicon))


def _ends(node: Node, lexicon: Lexicon) -> bool:
    return node.lower in lexicon.closed.joints_of_orders | ENDS
