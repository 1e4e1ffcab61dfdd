"""Which instruction words refer to: "after setting the table", "when the rice is done", "it"."""

from collections.abc import Sequence
from functools import lru_cache

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses import Clause

PRONOUNS = frozenset({"it", "them", "that", "this", "those", "these", "one", "ones", "they"})
SEVERAL = frozenset({"them", "those", "these", "ones", "they"})
PREPOSITIONS = frozenset({"of", "for", "with", "from", "to", "in", "on", "at", "about"})
EMPTY = frozenset(
    [
        "the",
        "a",
        "an",
        "my",
        "your",
        "our",
        "his",
        "her",
        "their",
        "some",
        "all",
        "any",
        "this",
        "that",
        "these",
        "those",
        "few",
        "couple",
        "of",
        "and",
        "is",
        "are",
        "has",
        "have",
        "been",
        "with",
        "in",
        "on",
        "to",
        "for",
    ]
)
"""Words that name nothing."""

REMEMBERED = 16384
"""Texts whose words are remembered: each reference asks for those of every instruction."""


@lru_cache(maxsize=REMEMBERED)
def content_words(text: str | None) -> frozenset[str]:
    """Give the words of a text that name something, in the singular."""
    if text is None:
        return frozenset()
    return frozenset(_singular(w.text) for w in words_of(text) if w.is_letters and w.text not in EMPTY)


def _singular(word: str) -> str:
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith("oes"):
        return word[:-2]
    return word[:-1] if word.endswith("s") and not word.endswith("ss") and len(word) > 3 else word


def target_of(
    clause: Clause, operations: Sequence[Operation | None], lexicon: Lexicon, own: int | None = None
) -> int | None:
    """Give the position of the instruction that a clause refers to, the latest of the best, or None.

    ``own`` is the position of the instruction that the clause belongs to.
    """
    best, found = 0.0, None
    named = content_words(clause.object)
    words = named | content_words(clause.condition.subject if clause.condition is not None else None)
    for position, operation in enumerate(operations):
        if operation is None or operation.negated or position == own:
            continue
        verb = operation.lemma == clause.verb or operation.lemma in named
        if not verb and words.isdisjoint(content_words(operation.object)):
            # Nothing in common: most of a long list.
            continue
        worth = _likeness(clause, operation, lexicon)
        if worth > 0 and worth >= best:
            best, found = worth, position
    return found


def _likeness(clause: Clause, operation: Operation, lexicon: Lexicon) -> float:
    """How well an operation fits a clause: 0 where it does not."""
    named = content_words(clause.object)
    known = content_words(operation.object) | content_words(operation.place)
    shared = len(named & content_words(operation.object))
    if clause.is_event:
        # "Before the walk", where the dog is walked; "into the roast", where the meat is roasted.
        return shared + (operation.lemma in named) if named else 0.0
    same_verb = clause.verb == operation.lemma
    if same_verb and (shared or not named or named <= PRONOUNS or not known):
        return 2.0 + shared
    condition = clause.condition
    if condition is not None and condition.word is not None:
        # "When the rice is done", "once the table is set": its result.
        subject = content_words(condition.subject)
        finished = condition.word in lexicon.results or clause.verb in {"finish", "do", "cook", "boil"}
        if finished and subject & content_words(operation.object):
            return 1.0 + len(subject & content_words(operation.object))
    return 0.0


def resolved_object(operation: Operation, before: Sequence[Operation | None], lexicon: Lexicon) -> str | None:
    """Give what "it" or "them" stands for: the object of the latest instruction that fits in number.

    Neither stands for a person: in "call mum, then wash it", it is something else.
    """
    if operation.object is None or operation.object.lower() not in PRONOUNS:
        return operation.object
    things = [
        earlier.object
        for earlier in reversed(before)
        if earlier is not None and earlier.object is not None and not _is_person(earlier, lexicon)
    ]
    several = operation.object.lower() in SEVERAL
    named = [thing for thing in things if thing.lower() not in PRONOUNS]
    fitting = [thing for thing in named if _is_several(thing) is several]
    return next(iter(fitting or named), operation.object)


def _is_person(operation: Operation, lexicon: Lexicon) -> bool:
    words = {word.text for word in words_of(operation.object or "")}
    return operation.lemma in lexicon.addressing or bool(words & lexicon.persons)


def _is_several(thing: str) -> bool:
    """Whether a noun looks like a plural: by what stands before "of" or another preposition."""
    words = [word.text for word in words_of(thing)]
    end = next((place for place, word in enumerate(words) if place and word in PREPOSITIONS), len(words))
    return "and" in words or _singular(words[end - 1]) != words[end - 1]
