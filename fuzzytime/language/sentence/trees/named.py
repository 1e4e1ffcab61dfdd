"""What an object names: a thing or a person, one or several; what pronouns may stand for."""

from collections.abc import Sequence

from fuzzytime.english import singular
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation


def names_person(thing: str, lexicon: Lexicon) -> bool:
    """Whether an object names somebody: by a word for persons or animals, or a name without an article."""
    closed = lexicon.closed
    words = [word.text for word in words_of(thing)]
    if not words or words[0] in closed.anaphors | closed.third_person_objects:
        return False
    # "Gym at six" begins with a capital as it begins a sentence.
    capital = thing[:1].isupper() and (lexicon.happening | lexicon.taken).isdisjoint(words)
    # "Next dose is at ten"
    capital = capital and words[0] not in closed.general_ordinals
    return capital or not (lexicon.persons | lexicon.animals).isdisjoint(words)


def may_be_it(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether "it" or "them" may stand for its object: a thing that is named, and no person."""
    named = operation.object is not None and operation.object.lower() not in lexicon.closed.anaphors
    # "It takes an hour to warm up"
    named = named and not (operation.object or "").startswith("to ")
    return named and not _is_person(operation, lexicon)


def is_event(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether it is told when something is that goes on, and at which no thing is: "handover at noon"."""
    words = [word.text for word in words_of(operation.object or "")]
    timed = lexicon.happening | lexicon.events | lexicon.taken
    return operation.stated and not timed.isdisjoint(words)


def _is_person(operation: Operation, lexicon: Lexicon) -> bool:
    words = [word.text for word in words_of(operation.object or "")]
    # "A meeting with Tom" is no person.
    named = words[: _head_of(words, lexicon)]
    return operation.lemma in lexicon.addressing or not lexicon.persons.isdisjoint(named)


def _head_of(words: Sequence[str], lexicon: Lexicon) -> int:
    """Give how many words of an object stand before "of" or another preposition."""
    prepositions = lexicon.closed.prepositions_of_nouns
    return next((place for place, word in enumerate(words) if place and word in prepositions), len(words))


def is_several(thing: str, lexicon: Lexicon) -> bool:
    """Say whether a noun looks like a plural: by what stands before "of" or another preposition."""
    words = [word.text for word in words_of(thing)]
    end = _head_of(words, lexicon)
    return "and" in words or singular(words[end - 1]) != words[end - 1]
