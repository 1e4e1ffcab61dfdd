"""What is named with its time, and done with behind that: "gas bottles one o'clock swap them"."""

from collections.abc import Set as AbstractSet

from fuzzytime.language.sentence.trees.named import TOPIC
from fuzzytime.language.sentence.trees.tree import Tree

NAMING = ("NN", "JJ", "DT", "PRP$", "POS", "CD", "IN")
"""How tags begin of the words of a thing's name."""


def with_topic(tree: Tree, timed: AbstractSet[int]) -> Tree:
    """Give an order behind a time the thing in front as what "it" and "them" are."""
    verb = next((place for place in range(2, len(tree.nodes)) if _is_about(tree, place, timed)), None)
    if verb is None:
        return tree
    thing, pronoun, particles = min(timed) - 1, verb + 1, tree.lexicon.particles
    while not tree.nodes[thing].text[0].isalnum():
        thing -= 1
    behind = [p for p in range(pronoun, len(tree.nodes)) if not pronoun <= tree.nodes[p].head != p]
    tree = tree.hung(range(thing), thing, "compound").hung(range(thing + 1, verb), verb, "npadvmod")
    tree = tree.hung(behind, verb, "dep").hung(
        [p for p in behind if tree.nodes[p].lower in particles], verb, "prt"
    )
    tree = tree.changed(thing, head=verb, relation=TOPIC).changed(pronoun, head=verb, relation="dobj")
    return tree.changed(verb, head=verb, relation="ROOT", tag="VB", lemma=tree.nodes[verb].lower)


def _is_about(tree: Tree, place: int, timed: AbstractSet[int]) -> bool:
    """Whether an order with "it" stands right behind a time, and nothing but a name in front of that."""
    lexicon = tree.lexicon
    before, node, behind = place - 1, tree.nodes[place], tree.nodes[place + 1 : place + 2]
    apart = not tree.nodes[before].text[0].isalnum()
    before -= apart
    about = [one for one in behind if one.lower in lexicon.closed.it_or_them]
    acts = (node.may_act and node.lower == node.lemma) or node.lower in lexicon.orders
    if not about or not acts or before not in timed or place in timed:
        return False
    first = min(timed)
    named = [one for one in tree.nodes[:first] if one.text[0].isalnum()]
    event = bool(named) and named[-1].lower in lexicon.happening | lexicon.taken
    # "Dentist at four cancel it"
    moved = lexicon.doing.revoking | lexicon.doing.dropping | (lexicon.moving if event else frozenset())
    thing = len(named) == 1 or (bool(named) and all(one.tag.startswith(NAMING) for one in named))
    named_so = thing and (named[-1].may_name or not named[-1].may_act)
    return named_so and set(range(first, before + 1)) <= timed and node.lower not in moved
