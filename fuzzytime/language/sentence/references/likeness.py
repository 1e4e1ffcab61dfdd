"""How well what was asked for, or told, fits what a clause names: the best is what it refers to."""

from collections.abc import Iterable

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.mentions import names_of, nouns_of
from fuzzytime.language.sentence.references.whereabouts import elsewhere, gets_there
from fuzzytime.language.sentence.trees.content_words import content_words, stems

SAME_VERB = 2.0
"""The worth of the very verb of a clause, to which words that are shared add 1 each."""

ALIKE = 0.5
"""The worth of a word that is only alike."""


def best_of(
    clause: Clause,
    candidates: Iterable[tuple[int, Operation | None]],
    lexicon: Lexicon,
    whose: frozenset[str] = frozenset(),
) -> int | None:
    """Give the position of the operation that a clause refers to, the first of the best; None for none.

    Of those that are as good, one that is about ``whose`` it is said to be: "feed Rolo after his walk".
    """
    best, found = (0.0, False), None
    named, words = names_of(clause)
    most = SAME_VERB + max(len(named), len(words) - 1) + ALIKE * clause.is_event
    for position, operation in candidates:
        if operation is None or operation.negated:
            continue
        worth = _likeness(clause, operation, lexicon)
        own = not whose.isdisjoint(content_words(operation.object))
        if worth and (worth, own) > best:
            best, found = (worth, own), position
        if best >= (most, bool(whose)):
            break
    return found


def all_alike(
    clause: Clause, candidates: Iterable[tuple[int, Operation | None]], lexicon: Lexicon
) -> list[int]:
    """Give the positions of all operations that fit a clause as well as the best of them."""
    asked = [(place, one) for place, one in candidates if one is not None and not one.negated]
    worth = {place: _likeness(clause, one, lexicon) for place, one in asked}
    best = max(worth.values(), default=0.0)
    return sorted(place for place, found in worth.items() if found == best > 0)


def _likeness(clause: Clause, operation: Operation, lexicon: Lexicon) -> float:
    """How well an operation fits a clause: 0 where it does not."""
    if clause.is_event:
        return _likeness_of_event(clause, operation)
    if elsewhere(clause, operation, lexicon):
        return 0.0
    named = content_words(clause.object)
    shared = len(named & content_words(operation.object))
    if gets_there(clause, operation, lexicon):
        return SAME_VERB + max(shared, 1)
    word = None if clause.condition is None else clause.condition.word
    if operation.attended and clause.verb == operation.lemma == "be" and word == operation.object:
        # "Half an hour before we're on"
        return SAME_VERB
    if _happens_as(clause, operation):
        return SAME_VERB
    if _is_same_verb(clause, operation, lexicon) or _says_when(clause, operation, lexicon):
        return SAME_VERB + shared
    return _likeness_of_result(clause, operation, lexicon)


def _likeness_of_event(clause: Clause, operation: Operation) -> float:
    """How well an operation fits a noun: "before the walk", where the dog is walked."""
    named = content_words(clause.object)
    shared = len(named & content_words(operation.object))
    if clause.kind == "length":
        # "We are at swimming by four. Swimming lasts an hour"
        shared = len(named & (content_words(operation.object) | content_words(operation.place)))
    same = shared + (not named.isdisjoint(nouns_of(operation.lemma))) if named else 0.0
    # "During the window" is while it goes on, whatever else is done with it.
    told = ALIKE if operation.stated and clause.kind == "while" else 0.0
    # "Into the roast", where the meat is roasted.
    return same + told if same else _named_after(named, operation)


def _is_same_verb(clause: Clause, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether a clause says that the very same is done, of the same thing or of none."""
    closed = lexicon.closed
    named, done = content_words(clause.object), {operation.lemma}
    if operation.lemma in lexicon.letting and operation.complement is not None:
        # "Let it rise. Fold it when it has risen for an hour"
        done.add(operation.complement)
    if clause.verb not in done:
        return False
    shared = not named.isdisjoint(content_words(operation.object))
    known = content_words(operation.object) | content_words(operation.place)
    anyone = not named or named <= closed.anaphors | closed.universal_pronouns or not known
    # "While she is there" names no dinner that is at seven.
    return shared or (anyone and clause.verb != "be")


def _happens_as(clause: Clause, operation: Operation) -> bool:
    """Whether what happens has the name of what a clause says is done: "while she naps", "before opening".

    Who does it, or with what, is said by neither.
    """
    if clause.verb is None or content_words(clause.object) or not operation.stated:
        return False
    named = {clause.verb, *nouns_of(clause.verb)}
    return not named.isdisjoint(content_words(operation.object))


def _says_when(clause: Clause, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether a clause says of the same thing that it comes, goes on, begins or ends."""
    if content_words(clause.object).isdisjoint(content_words(operation.object)):
        return False
    doing = lexicon.doing
    word = None if clause.condition is None else clause.condition.word
    goes_on = clause.verb == "be" and word in doing.going_on and clause.kind == "while"
    if operation.stated and (goes_on or clause.verb in doing.beginning | doing.ending):
        # "Five minutes before the meeting starts", where the meeting is at three.
        return True
    # "20 minutes before the cake goes in", where it is baked.
    return clause.verb == "go" and operation.lemma in doing.putting


def _likeness_of_result(clause: Clause, operation: Operation, lexicon: Lexicon) -> float:
    """How well an operation fits what it results in: "when the rice is done", "once the table is set"."""
    condition = clause.condition
    if condition is None or condition.word is None:
        return 0.0
    if condition.word not in lexicon.results and clause.verb not in lexicon.doing.finished:
        return 0.0
    subject = content_words(condition.subject)
    if not subject.isdisjoint(nouns_of(operation.lemma)):
        # "Once the print is done", where the bracket is printed.
        return SAME_VERB
    shared = len(subject & content_words(operation.object))
    return 1.0 + shared if shared else _named_after(subject, operation)


def _named_after(words: frozenset[str], operation: Operation) -> float:
    """How well a noun for what is done fits an operation: the incubation, where the incubator is used."""
    known = content_words(operation.object) | content_words(operation.place)
    return ALIKE * (not stems(words).isdisjoint(stems(known | {operation.lemma})))
