"""Orders that a tree takes for something else: "wipe the rug and empty the bins"."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.segments.orders_beside_times import (
    is_order_before_time,
)
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE
from fuzzytime.language.sentence.trees.tree import Node, Tree
from fuzzytime.language.sentence.verbs.places import says_where

DESCRIBING = ("det", "amod", "poss", "nummod", "compound")
"""How a tree calls what says which thing it is."""

SURE = frozenset({"UH", "RB", "IN", "RP", "CD"})
"""Tags of words that are no step, whatever else they may be."""

THINGS = ("dobj", "npadvmod", "attr")
"""How a tree joins what is named to a verb."""


def is_overlooked(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether it is an order that a tree took for something else: "wipe the rug and empty the bins"."""
    alone = tree.nodes[place].lower in tree.lexicon.alone
    return (
        (_governs(tree, place) and (alone or place + 1 not in timed))
        or _follows_turning(tree, place)
        or _is_done_between(tree, place, timed)
        or is_further_step(tree, place, timed)
        or is_order_before_time(tree, place, timed)
        or (place - 2 in timed and _has_numbered(tree, place))
    )


def is_bare_order(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether what was taken for a thing is done to somebody, or with things: several, behind a time."""
    behind_time = not timed.isdisjoint({place - 1, place - 2})
    ordered = tree.nodes[place].lower in tree.lexicon.ordering
    chore = (behind_time or ordered) and _is_chore(tree, place)
    return chore or _is_done_to_somebody(tree, place)


def _is_done_to_somebody(tree: Tree, place: int) -> bool:
    """Whether what may be a verb has somebody behind it: "feed the cat and text ann"; not "and aunt ann"."""
    lexicon = tree.lexicon
    node, who = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    if node.lower in lexicon.persons - lexicon.names_like_words:
        return False
    calls = node.lower in lexicon.addressing
    # "Ring jane": a tree may have it for what goes on, and "email mrs lane" for a part of her name.
    taken = not node.is_verb or node.relation == "compound" or (node.tag == "VBG" and calls)
    bare = taken and (calls or (node.may_act and node.lower == node.lemma.lower()))
    known = lexicon.people if calls else lexicon.names | lexicon.beside.titles_of_persons
    return bare and any(one.lower in known for one in who)


def _is_chore(tree: Tree, place: int) -> bool:
    """Whether a chore taken for a thing has several behind it, or where: "… at noon and water plants at two".

    What is bought may be called so: "order bread today and paint brushes tomorrow".
    """
    lexicon = tree.lexicon
    node, things = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    bought = tree.nodes[tree.root].lemma in lexicon.ordering | lexicon.doing.errands
    if not node.tag.startswith(("NN", "JJ")):
        return False
    if node.lower in lexicon.ordering:
        # "… and order pizza at seven"
        return any(one.tag == "NNS" or (one.tag == "NN" and not one.may_act) for one in things)
    several = any(one.tag == "NNS" or says_where(one.lower, lexicon) for one in things)
    return node.lower in lexicon.chores and several and not bought


def _is_done_between(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether a chore alone, or done somewhere, is one of several: "make the beds, hoover upstairs and …".

    What is bought may be called so: "buy bread, water and call Ann".
    """
    lexicon = tree.lexicon
    node, before, joints = tree.nodes[place], tree.nodes[place - 1].lower, lexicon.closed.joints_of_orders
    errands = frozenset() if node.lower in lexicon.needing_nothing else lexicon.doing.errands
    bought = tree.nodes[tree.root].lemma in lexicon.ordering | errands
    known = lexicon.chores | lexicon.alone | lexicon.timing_alone | lexicon.needing_nothing
    if bought or node.lower not in known or before not in joints or tree.children(place, *DESCRIBING):
        return False
    behind = [*tree.nodes[place + 1 :]]
    where = bool(behind) and says_where(behind[0].lower, lexicon)
    behind = behind[where:]
    if where and (not behind or behind[0].tag == "IN"):
        return True
    further = behind[1:2] if behind and behind[0].lower in joints else []
    goes_on = any(one.is_bare and (where or tree.children(tree.nodes.index(one), "dobj")) for one in further)
    return goes_on or _names_nothing(tree, place, timed)


def _names_nothing(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether an order that names nothing ends all, or one like it follows: "clean the bath and hoover".

    It may be a thing beside another like it: "move the mop and vacuum".
    """
    orders = tree.lexicon.needing_nothing
    behind, further = tree.nodes[place + 1 : place + 2], tree.nodes[place + 2 : place + 3]
    goes_on = all(word.tag in IMPERATIVE or word.lower in orders for word in further)
    joined = all(word.lower in tree.lexicon.closed.joints_of_orders | ENDS for word in behind) and goes_on
    ends = joined or place + 1 in timed or any((word.lower,) in tree.lexicon.clauses for word in behind)
    named = [p for p in tree.children(tree.root, "dobj") if tree.children(p, *DESCRIBING)]
    beside = orders.intersection(tree.nodes[p].lower for p in named)
    return ends and not beside and tree.nodes[place].lower in orders


def _follows_turning(tree: Tree, place: int) -> bool:
    """Whether what may be a verb stands behind where to turn, beside which is no thing: "left and park"."""
    node, before = tree.nodes[place], tree.nodes[place - 1].lower
    turning = tree.nodes[place - 2].lower in tree.lexicon.closed.sides | tree.lexicon.beside.turnings
    bare = node.may_act and node.lower == node.lemma.lower() and not tree.children(place, "det", "amod")
    return turning and before in tree.lexicon.closed.joints_of_orders and bare and node.relation == "conj"


def _has_numbered(tree: Tree, place: int) -> bool:
    """Whether what may be a verb stands before what is called by a number: "…, clear bay 3"."""
    behind = tree.nodes[place + 1 : place + 3]
    called = len(behind) > 1 and behind[0].lower in tree.lexicon.machines and behind[1].tag == "CD"
    return called and tree.nodes[place].may_act and tree.nodes[place - 1].text == ","


def _governs(tree: Tree, place: int) -> bool:
    """Whether a word taken for no verb has an object, or a particle: "wipe the rug and empty the bins"."""
    lexicon = tree.lexicon
    closed = lexicon.closed
    node, before = tree.nodes[place], tree.nodes[place - 1].lower
    if (
        before in closed.joints_of_things
        and node.lower in lexicon.alone
        and (node.tag == "NN" or _stands_apart(tree, place))
    ):
        return True
    # "Lock the shed and reboot the router": it names nothing.
    taken = node.tag in {"NN", "NNP", "JJ", "JJR"} or (
        node.may_act and (node.tag == "RB" or not node.may_name)
    )
    if not taken or node.is_verb or before not in closed.joints_of_orders:
        return False
    if before == "," and _is_before_object(tree, place):
        return True
    if place + 1 >= len(tree.nodes):
        return False
    behind, further = tree.nodes[place + 1].lower, next((n.lower for n in tree.nodes[place + 2 :]), "")
    if not further and not (node.may_act and behind in closed.it_or_them):
        return False
    if node.lower in lexicon.particles.get(behind, ()):
        return True
    if node.lower in lexicon.measure_verbs and node.may_act and behind == "to":
        # "Dissolve the salt, heat to 60 degrees"
        return True
    # "Raise the blinds, water the fern, lower them at six"
    # "Sow carrots, thin them": no adjective stands before a pronoun.
    # "Wash the car, hoover it": nor does an adverb.
    known = {"NN", "JJR", "JJ", "NNP", "RB"} if node.may_act and node.text.islower() else {"NN", "JJR"}
    # "Bin anything old"
    pronouns = closed.it_or_them | (closed.behind_verbs - closed.noun_openers - lexicon.particles.keys())
    bare = node.tag in known and not tree.children(place, "det", "amod", "compound", "poss", "nummod")
    if bare and (behind in pronouns or (tree.nodes[place + 1].tag == "IN" and further in closed.it_or_them)):
        # "Leave it for an hour and pat it dry", "move the sofa, vacuum behind it"
        return True
    return (
        node.relation == "conj" and before in closed.additive_conjunctions and behind in closed.noun_openers
    )


def _is_before_object(tree: Tree, place: int) -> bool:
    """Whether a bare word behind a comma has a thing or a person behind it: "…, hoover the seats"."""
    if place + 1 >= len(tree.nodes):
        return False
    node, behind = tree.nodes[place], tree.nodes[place + 1]
    described = tree.children(place, "det", "amod", "poss", "nummod")
    called = node.lower in tree.lexicon.addressing and (
        behind.lower in tree.lexicon.persons or behind.tag == "NNP"
    )
    thing = node.may_act and behind.tag in DETERMINERS
    return node.lower == node.lemma.lower() and not described and (thing or called)


def _stands_apart(tree: Tree, place: int) -> bool:
    """Whether what a tree takes for an adjective describes nothing: "chop the onions, fry, then serve"."""
    node, behind = tree.nodes[place], tree.nodes[place + 1 : place + 2]
    ends = all(word.lower in tree.lexicon.closed.joints_of_orders | ENDS for word in behind)
    # "Keep it dark, cool"
    named = any(tree.nodes[p].tag.startswith("NN") for p in tree.children(tree.root, "dobj"))
    return node.tag == "JJ" and ends and named and tree.nodes[node.head].tag.startswith(("NN", "VB"))


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
    joined = tree.nodes[place - 1].lower in lexicon.closed.joints_of_things
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
