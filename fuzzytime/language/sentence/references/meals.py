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


def hours_of_meal(operation: Operation | None, lexicon: Lexicon) -> tuple[int, int] | None:
    """Give from when to when a meal is that is had, in seconds of its day: "lunch with Ann", "have dinner".

    None for what is done with one ("cook dinner"), or what it is of ("a cup of tea").
    """
    if operation is None:
        return None
    had = operation.stated or operation.lemma in lexicon.doing.having
    named = operation.object is None or operation.verb in lexicon.happening
    words = words_of((operation.object if had else operation.name if named else None) or "")
    for place, word in enumerate(words):
        for piece in lexicon.pieces(words, place):
            if piece.category == "meal" and not piece.value.place:
                return piece.value.start, piece.value.end
        if word.text in lexicon.function_words - lexicon.closed.noun_openers:
            return None
    return None
