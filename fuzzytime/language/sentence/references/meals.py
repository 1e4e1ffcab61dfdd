"""The meal at which they eat: "light the candles before we eat", where dinner is at seven."""

from itertools import chain

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.trees.content_words import content_words


def meal_of(clause: Clause, anchors: Anchors) -> int | None:
    """Give the instruction, the latest before it or else the next, about the meal that a clause speaks of."""
    if clause.verb not in anchors.lexicon.doing.eating:
        return None
    # "Before serving", "before we eat lunch"
    named = content_words(clause.object)
    last = anchors.first + len(anchors.own) if not anchors.awaits else len(anchors.mentions.operations)
    places = chain(range(anchors.position - 1, -1, -1), range(anchors.position + 1, last))
    return next((place for place in places if _is_of_meal(anchors.operation_at(place), named, anchors)), None)


def _is_of_meal(operation: Operation | None, named: frozenset[str], anchors: Anchors) -> bool:
    """Whether something is done with a meal that may be ``named``, or one is told of."""
    if operation is None or operation.object is None or not named <= content_words(operation.object):
        return False
    return names_meal(operation.object, anchors.lexicon)


def names_meal(thing: str | None, lexicon: Lexicon) -> bool:
    """Whether words name a meal: "a late dinner"."""
    words = words_of(thing or "")
    pieces = chain.from_iterable(lexicon.pieces(words, place) for place in range(len(words)))
    return any(piece.category == "meal" and not piece.value.place for piece in pieces)
