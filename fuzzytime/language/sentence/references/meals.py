"""The meal at which they eat: "light the candles before we eat", where dinner is at seven."""

from collections.abc import Sequence
from itertools import chain

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.times_of_day import Part
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
    return any(meal_at(words, place, lexicon) is not None for place in range(len(words)))


def meal_at(words: Sequence[Word], place: int, lexicon: Lexicon) -> Part | None:
    """Give the meal that stands at a place; "work" is none, as it is where somebody is."""
    meals = (piece.value for piece in lexicon.pieces(words, place) if piece.category == "meal")
    return next((meal for meal in meals if not meal.place), None)
