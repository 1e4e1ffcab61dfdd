"""Which words of an order hold for another thing too: "take the chairs to room 2 and the tables to 3"."""

from fuzzytime.language.sentence.segments.borrowed_words.further_wishes import (
    Stretch,
    Wish,
    front_of,
    ordered,
)
from fuzzytime.language.sentence.trees.named import is_of_its_own, may_have_it_done
from fuzzytime.language.sentence.trees.tags import DETERMINERS, FINITE
from fuzzytime.language.sentence.trees.tree import Tree

LEADING = frozenset({"TO", "PRP", "MD", "CC", "UH", "RB"})
"""Tags of words that an order may stand behind: "can you", "to", "please"."""

WHERE = frozenset({"IN", "TO"})
"""Tags of words that begin what says where."""


def is_done_elsewhere(wish: Wish) -> list[Stretch] | None:
    """Give what is done with another, of whom it is said: "take" Tom swimming at ten and Ella to ballet."""
    tree, verb, closed = wish.tree, _acting(wish), wish.lexicon.closed
    here = next((p for p in range(wish.start, len(tree.nodes)) if p not in wish.timed), len(tree.nodes))
    if verb is None or here == len(tree.nodes):
        return None
    end = _end_behind(wish, here)
    # "Feed the hens when you get up and the ducks at nine": that "up" is none of the feeding.
    clauses = wish.lexicon.clauses
    said_when = (p for p in range(verb.stop, here) if p in wish.timed or (tree.nodes[p].lower,) in clauses)
    time = next(said_when, here)
    in_front = here > wish.start
    if not wish.apart and ((time < wish.start) is in_front or (end == len(tree.nodes) and not in_front)):
        return None
    named = _others(wish, here, end, verb.stop)
    said = range(here + named, end)
    if not named or any(_tells(wish, place, said.start) for place in range(here + 1, end)):
        return None
    done = may_have_it_done(tree.nodes[verb.start].lemma, tree.nodes[here], wish.lexicon)
    if not done or is_of_its_own(wish.text(here, said.start), wish.lexicon):
        # "Walk bella at six, biscuit at seven", "feed the cat at six and the match at eight"
        return None
    front = front_of(wish, verb.start)
    joined = any(tree.nodes[p].lower in closed.joints_of_orders for p in front)
    found = [(here, verb if joined else range(front.start, verb.stop))]
    shared = _shared(wish, range(verb.start, time), said)
    if shared is not None:
        found.append((said.start, shared))
    return found


def _end_behind(wish: Wish, here: int) -> int:
    """Give where what is said of another ends: at a time or a clause, or at a joint before one."""
    nodes, joints = wish.tree.nodes, wish.lexicon.closed.joints_of_orders
    behind = range(here + 1, len(nodes))
    ends = (p for p in behind if p in wish.timed or (nodes[p].lower,) in wish.lexicon.clauses)
    joined = (p for p in behind if nodes[p].lower in joints and p + 1 in wish.timed)
    return min(next(ends, len(nodes)), next(joined, len(nodes)))


def _shared(wish: Wish, order: range, said: range) -> range | None:
    """Give what holds for another, too: a verb's particle, or "in order"; None where nothing does.

    Before what is ``said`` of another, that is a particle with the same behind it: picked "up from" chess,
    and "from" drums.
    """
    nodes, lexicon = wish.tree.nodes, wish.lexicon
    lemma = nodes[order.start].lemma
    for place in range(order.start + 2, order.stop):
        carried = nodes[place].tag == "RP" or lemma in lexicon.particles.get(nodes[place].lower, ())
        alike = nodes[place + 1].lower == nodes[said.start].lower if said else place + 1 == order.stop
        if carried and alike:
            return range(place, place + 1)
    where = nodes[order.stop - 2]
    bare = where.lower in lexicon.places | {"to"} and where.tag in WHERE and nodes[order.stop - 1].tag == "NN"
    return range(order.stop - 2, order.stop) if bare and not said else None


def _acting(wish: Wish) -> range | None:
    """Give the last bare verb before a wish that has a thing or somebody behind it, with its particle."""
    nodes, lexicon, openers = wish.tree.nodes, wish.lexicon, wish.lexicon.closed.noun_openers
    for place in range(wish.start - 2, -1, -1):
        node, before = nodes[place], nodes[place - 1] if place else None
        led = before is None or place - 1 in wish.timed or before.tag in LEADING or before.text == ","
        bare = (node.may_act or node.tag == "VB") and node.lower == node.lemma and place not in wish.timed
        # "Before you leave the house"
        clause = any((other.lower,) in lexicon.clauses for other in nodes[max(0, place - 2) : place])
        if clause or not led or not bare or node.lower in lexicon.function_words:
            continue
        carried = node.lower in lexicon.particles.get(nodes[place + 1].lower, ())
        verb = range(place, place + 1 + carried)
        thing = nodes[verb.stop]
        somebody = openers | lexicon.people
        alone = place and verb.stop in wish.timed and node.is_verb and node.lower in lexicon.needing_nothing
        if alone and nodes[wish.start].lower not in openers:
            # "Pick up kids at 3, swim at 4, tea at 5.30"
            return None
        if verb.stop in wish.timed or not (thing.lower in somebody or thing.tag.startswith("NN")):
            continue
        asked = lexicon.addressing - lexicon.doing.recalling
        asks = any(
            other.lemma in asked and wish.tree.children(p, "xcomp", "ccomp")
            for p, other in enumerate(nodes[:place])
        )
        asks = asks or (node.lemma in asked and any(n.tag == "TO" for n in nodes[place : wish.start]))
        return None if asks or any(other.relation == "neg" for other in nodes[:place]) else verb
    return None


def _others(wish: Wish, here: int, end: int, first: int) -> int:
    """Give how many words name another thing, or somebody, as those from ``first`` on do; 0 for none."""
    nodes, lexicon = wish.tree.nodes, wish.lexicon
    node, openers = nodes[here], lexicon.closed.noun_openers
    given = {nodes[p + 1].lower in openers for p in (here, first) if p + 1 < len(nodes)}
    # "And show Bob the flat"; but "and mark the book at nine", "and groom the horse"
    alike = len(given) == 1
    somebody = (wish.is_name(here) and (alike or not node.may_act)) or node.lower in openers
    called = node.lower in lexicon.names_like_words and alike
    # "Bring wine to dad at six and cheese to mum at seven"
    numbered = all(nodes[p + 1].tag == "CD" for p in (here, first) if p + 1 < len(nodes))
    acts = node.may_act and not numbered
    acts = acts or node.lower in lexicon.addressing | lexicon.closed.negative_pronouns
    # "Clean kitchen at ten, windows at noon", "revise biology at ten, french at noon"
    moving = lexicon.orders | lexicon.needing_nothing | lexicon.timing | lexicon.doing.moments
    moving |= lexicon.results | lexicon.particles.keys()
    alone = node.tag in {"VBZ", "JJ", "NN"} and here + 1 in wish.timed and node.may_name
    named = (alone and node.lower not in moving) or (node.tag.startswith("NN") and not acts)
    bare = named and nodes[first].lower not in openers
    if not (somebody or called or bare):
        return 0
    ends = (p for p in range(here + 1, end) if not wish.names(p, p + 1) or nodes[p].lower in openers)
    return next(ends, end) - here


def _is_somebody(wish: Wish, place: int) -> bool:
    """Whether somebody is named, or an animal is."""
    return wish.tree.nodes[place].lower in wish.lexicon.people | wish.lexicon.animals


def _tells(wish: Wish, place: int, named: int) -> bool:
    """Whether a word says what somebody or something does: "and the kids come home at seven".

    So may a plural behind who is ``named``: "and Bob cooks tonight".
    """
    node, before = wish.tree.nodes[place], wish.tree.nodes[place - 1]
    if before.tag == "POS" or node.tag == "POS":
        # "And gran's coming tomorrow", "and the meeting's at two"
        return (node.lemma != node.lower and node.may_act) or place + 1 == named
    finite = node.tag in FINITE or (node.tag == "VB" and before.lower != "to")
    acts = place < named and node.may_act and node.lower != node.lemma and _is_somebody(wish, place - 1)
    # "And the doors open at eight"
    opens = node.lower in wish.lexicon.doing.timed | wish.lexicon.doing.several_timed
    return finite or acts or opens


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
