"""When something is on a day for which no time of day is said: dinner, the cinema, to bed."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.references.meals import meal_at

Seconds = tuple[int, int]
"""From when to when, in seconds of a day."""


def hours_on_a_day(operation: Operation | None, lexicon: Lexicon) -> Seconds | None:
    """Give the hours of a meal that is had, or of what else is on: "lunch with Ann", "go to the cinema".

    None for what is done with it ("cook dinner", "book the cinema"), or what it is of ("a cup of tea").
    """
    if operation is None:
        return None
    words = words_of(_what_is_on(operation, lexicon))
    for place, word in enumerate(words):
        meal = meal_at(words, place, lexicon)
        hours = _of_table(words, place, lexicon) if meal is None else (meal.start, meal.end)
        if hours is not None and operation.lemma in lexicon.doing.having:
            return None if _is_of_thing(words, place + 1, lexicon) else hours
        if hours is not None:
            return hours
        if word.text in lexicon.function_words - lexicon.closed.noun_openers:
            break
    if lexicon.doing.attending.isdisjoint({operation.lemma, operation.phrase}):
        return None
    named = words_of(operation.name)
    found = (_of_table(named, place, lexicon) for place in range(len(named)))
    return next((hours for hours in found if hours is not None), None)


def _what_is_on(operation: Operation, lexicon: Lexicon) -> str:
    """Give the words for what happens, or is had."""
    if operation.stated or operation.lemma in lexicon.doing.having:
        return operation.object or ""
    named = operation.place is None or operation.verb in lexicon.happening
    return operation.name if named and operation.object is None else ""


def _is_of_thing(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a thing is behind a meal: "get lunch boxes", "get tea and milk"; not in "have lunch out"."""
    known = lexicon.function_words | lexicon.places
    joints = lexicon.closed.joints_of_orders
    return any(
        word.text in joints or (word.is_letters and word.text not in known)
        for word in words[place : place + 1]
    )


def _of_table(words: Sequence[Word], place: int, lexicon: Lexicon) -> Seconds | None:
    form = longest_match(words, place, lexicon.hours_on_days)
    first, last = (None, None) if form is None else lexicon.hours_on_days[form]
    if first is None or last is None:
        return None
    begin, end = ((hour.hour * 60 + hour.minute) * 60 for hour in (first, last))
    return begin, end
