"""What is moved on: "help mr jones to the lounge at ten and back to his room at twelve", "…, off at five"."""

from fuzzytime.language.sentence.segments.borrowed_words.further_wishes import Stretch, Wish, front_of
from fuzzytime.language.sentence.verbs.places import says_where

NAMES = frozenset({"NN", "NNS", "NNP", "NNPS", "PRP", "CD"})
"""Tags of words that end what something is done with."""


def is_moved_on(wish: Wish) -> list[Stretch] | None:
    """Give what holds for another place, or state, too: "turn the cooker" to low at eleven and off at five.

    That is all in front of the first place, where it ends in a thing; the wish has neither verb nor thing.
    """
    nodes, said = wish.tree.nodes, range(wish.start, wish.end)
    verbs = any(nodes[place].is_verb or nodes[place].tag == "MD" for place in said)
    if wish.end == len(nodes) or verbs or not _says_where(wish, wish.start):
        return None
    time = next((place for place in range(1, wish.start) if place in wish.timed), wish.start)
    first = front_of(wish, time)
    where = next((place for place in first[1:] if _says_where(wish, place)), None)
    if where is None or nodes[where - 1].tag not in NAMES:
        return None
    # "Walk to the shop at ten, home at eleven" moves nothing; what is turned down is turned up.
    particles = wish.lexicon.particles
    carried = any(node.lemma in particles.get(nodes[where].lower, ()) for node in nodes[first.start : where])
    turned = wish.lexicon.closed.adverbs_of_repetition | particles.keys() | {"to"}
    carried = carried and all(nodes[p].lower in turned or nodes[p].tag == "CD" for p in said)
    alone = where - 1 == first.start and nodes[first.start].may_act
    return None if alone or carried else [(wish.start, range(first.start, where))]


def _says_where(wish: Wish, place: int) -> bool:
    """Whether a word begins where something is to be, or what it is set to."""
    lexicon, word = wish.lexicon, wish.tree.nodes[place].lower
    return says_where(word, lexicon) or word in lexicon.beside.states | lexicon.particles.keys() | {"to"}
