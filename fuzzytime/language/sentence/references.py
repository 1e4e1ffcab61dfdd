"""Which instruction words refer to: "after setting the table", "when the rice is done", "it"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses import Clause

PRONOUNS = frozenset({"it", "them", "that", "this", "those", "these", "one", "ones", "they"})
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


def target_of(clause: Clause, operations: Sequence[Operation | None], lexicon: Lexicon) -> int | None:
    """Give the position of the instruction that a clause refers to, the latest of the best, or None."""
    best, found = 0.0, None
    for position, operation in enumerate(operations):
        if operation is None or operation.negated:
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
        return shared if named and shared else 0.0
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


def resolved_object(operation: Operation, before: Sequence[Operation | None]) -> str | None:
    """Give what "it" or "them" stands for: the object of the latest instruction that has one."""
    if operation.object is None or operation.object.lower() not in PRONOUNS:
        return operation.object
    for earlier in reversed(before):
        if earlier is not None and earlier.object is not None and earlier.object.lower() not in PRONOUNS:
            return earlier.object
    return operation.object
