"""Orders that trees overlook because a time stands beside them: "go to the gate, wait for ten seconds"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.sentence.trees.tags import DETERMINERS, IMPERATIVE
from fuzzytime.language.sentence.trees.tree import Tree

LEAST_ORDER = 2
"""Words of an order with an object, at least: "(ring)" may be a thing."""


def is_order_before_time(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether it is an order with nothing but a time: "go to the gate, wait for ten seconds".

    The tree may have it for a thing.
    """
    node = tree.nodes[place]
    if place + 1 not in timed or tree.nodes[place - 1].text != "," or not node.may_act:
        return False
    # "Open in two seconds, close in five"
    listed = place - 2 in timed
    # "Drive to A1, pause ten seconds"
    lasts = tree.nodes[place + 1].lower == "for" or node.lower in tree.lexicon.doing.waiting
    return node.lower == node.lemma and (listed or lasts or node.tag in IMPERATIVE)


def is_led_by_time(tree: Tree, place: int, timed: set[int]) -> bool:
    """Whether a joint and a time stand before a word with an object: "…, and at four clean the tank"."""
    closed = tree.lexicon.closed
    node = tree.nodes[place]
    behind = tree.nodes[place + 1].lower if place + 1 < len(tree.nodes) else ""
    first = place
    while first and first - 1 in timed:
        first -= 1
    led = 1 < first < place and tree.nodes[first - 1].lower in {*closed.joints_of_things, ";"}
    # "On the 6th and 8th feed the hens": two times of one order.
    led = led and not timed.issuperset(range(first - 1))
    addressing = node.lower in tree.lexicon.addressing
    called = addressing and bool(behind) and _is_called(tree, place + 1)
    bare = node.may_act and node.lower == node.lemma
    if node.lower in tree.lexicon.particles.get(behind, ()) and place + 2 < len(tree.nodes):
        # "…, and at noon top up the oil"
        behind = tree.nodes[place + 2].lower
    return led and bare and (called or behind in closed.noun_openers | closed.object_pronouns)


def is_done_alone(tree: Tree, first: int) -> bool:
    """Whether nothing but an order without an object stands before the root: "8:00 open up, feed the dogs".

    That is a verb with its particle, or one that needs no object, and a comma.
    """
    said = [node.lower for node in tree.nodes[first : tree.root]]
    if not said or said[-1] != ",":
        return False
    verb, *beside = said[: said.index(",")]
    if len(beside) == 1:
        return verb in tree.lexicon.particles.get(beside[0], ())
    # "8:00 open, feed the dogs": trees take such verbs for what things are like.
    return not beside and (verb in tree.lexicon.alone or tree.nodes[first].tag == "JJ")


def begins_order(tree: Tree) -> bool:
    """Whether a first word taken for a noun is an order: "order sushi for seven", "text karen at two"."""
    if _names_nothing(tree):
        return True
    if tree.root != 1 or not tree.nodes[0].tag.startswith("NN"):
        return False
    orders = tree.lexicon.ordering | (tree.lexicon.addressing if _is_called(tree, 1) else frozenset())
    return tree.nodes[0].lower in orders


def _names_nothing(tree: Tree) -> bool:
    """Whether a first noun stands before an article, or makes a name with a verb: "tape the match"."""
    if len(tree.nodes) <= tree.root or len(tree.nodes) < LEAST_ORDER:
        return False
    first, second = tree.nodes[:2]
    named = first.tag == "NN" and first.may_act and first.lower == first.lemma
    led = second.tag in DETERMINERS and first.relation in {"compound", "dep", "nmod"}
    # "Chase accounts at noon"
    return named and (led or (first.relation == "compound" and tree.root == 1 and second.tag == "VBZ"))


def _is_called(tree: Tree, place: int) -> bool:
    """Whether a noun may be somebody: not "interview" in "phone interview at two"."""
    lexicon = tree.lexicon
    node = tree.nodes[place]
    named = node.tag == "NNP" and node.text[0].isupper()
    event = node.lower in lexicon.happening | lexicon.taken or (node.may_act and not named)
    known = lexicon.people
    return node.lower in known or (node.tag.startswith("NN") and not event)


def is_numbered(tree: Tree) -> bool:
    """Whether a tree has what is called by a number for what is to be done: "close valve 3"."""
    root = tree.root
    named = root > 0 and tree.nodes[root].lower in tree.lexicon.machines
    return named and root + 1 < len(tree.nodes) and tree.nodes[root + 1].tag == "CD"


def asks_for_deed(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words begin with a verb that asks for something done, or say what is to be: "lights off"."""
    asked = lexicon.orders | lexicon.dosing | lexicon.doing.errands | lexicon.doing.finding
    asked |= lexicon.doing.leaving | lexicon.doing.setting
    states = [word.text for word in words if word.is_letters][1:] == ["off"]
    return len(words) >= LEAST_ORDER and (states or (words[0].text in asked and not words[1].is_digits))
