"""Which words of an order hold for another thing too: "take the chairs to room 2 and the tables to 3"."""

from fuzzytime.language.sentence.segments.borrowed_words.further_wishes import (
    Stretch,
    Wish,
    is_opened,
    ordered,
)
from fuzzytime.language.sentence.trees.tags import DETERMINERS
from fuzzytime.language.sentence.trees.tree import Tree

WHERE = frozenset({"IN", "TO"})
"""Tags of words that begin what says where."""


def goes_elsewhere(wish: Wish) -> list[Stretch] | None:
    """Give what is done with another thing elsewhere: "take" the chairs to room 2, the tables to room 3."""
    verb, nodes = ordered(wish), wish.tree.nodes
    if verb is None or not is_opened(wish):
        return None
    where = next((p for p in range(wish.start + 1, wish.end) if nodes[p].tag in WHERE), None)
    if where is None or where + 1 >= wish.end or not wish.names(wish.start, where):
        return None
    before = (p for p in range(verb[-1] + 1, wish.start) if p not in wish.timed and nodes[p].tag in WHERE)
    first = next((p for p in before if wish.names(verb[-1] + 1, p)), None)
    alike = first is not None and nodes[first].lower == nodes[where].lower
    return [(wish.start, verb)] if alike else None


def is_given_too(wish: Wish) -> list[Stretch] | None:
    """Give what another is given too: "give" Rex "a walk" at four and Bella at five, "give Rex" a bath."""
    verb, tree = ordered(wish), wish.tree
    if verb is None or not wish.names(wish.start, wish.end):
        return None
    given, whom = tree.children(verb[0], "dobj"), tree.children(verb[0], "dative")
    if not given or not whom or not verb[0] < whom[0] < given[0]:
        return None
    thing = min(tree.below(given[0]))
    end = next((p for p in range(thing, wish.start) if p in wish.timed), wish.start)
    if any(tree.nodes[p].tag in DETERMINERS for p in range(wish.start + 1, wish.end)):
        # "… and the cat her drops at seven"
        return [(wish.start, verb)]
    kinds = [_kind(tree, place) for place in (wish.start, min(tree.below(whom[0])), thing)]
    if kinds[1] == kinds[2] or kinds[0] not in kinds[1:]:
        return None
    if kinds[0] == kinds[1]:
        return [(wish.start, verb), (wish.end, range(thing, end))] if wish.end < len(tree.nodes) else None
    return [(wish.start, range(verb[0], thing))]


def _kind(tree: Tree, place: int) -> str:
    """Give how a name begins: by itself, or with an article that means one, or any."""
    node = tree.nodes[place]
    if node.tag == "CD" or node.lower in {"a", "an", "some"}:
        return "any"
    return "this" if node.tag in DETERMINERS else "named"


def is_put_too(wish: Wish) -> list[Stretch] | None:
    """Give what becomes of another thing too: "put" room 101 "in order" and room 102."""
    verb, nodes = ordered(wish), wish.tree.nodes
    if verb is None or not is_opened(wish) or not wish.names(wish.start, wish.end) or wish.end == len(nodes):
        return None
    time = next(p for p in range(verb[0], wish.start) if p in wish.timed)
    where, what = nodes[time - 2], nodes[time - 1]
    bare = where.tag in WHERE and where.lower in wish.lexicon.places | {"to"} and what.tag == "NN"
    whole = bare and wish.names(verb[-1] + 1, time - 2)
    return [(wish.start, verb), (wish.end, range(time - 2, time))] if whole else None


def is_done_then(wish: Wish) -> list[Stretch] | None:
    """Give what is done with another thing when something is so: "start" it and the dryer when it's done."""
    verb, nodes = ordered(wish), wish.tree.nodes
    clause = wish.end < len(nodes) and wish.end not in wish.timed
    opened = nodes[wish.start].tag in DETERMINERS and wish.names(wish.start, wish.end)
    return [(wish.start, verb)] if verb is not None and clause and opened else None
