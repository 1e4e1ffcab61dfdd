"""Where a clause says that something is, and what was asked for puts it: "before they go in the oven"."""

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.mentions import ways_of
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.language.sentence.trees.named import is_several

SIDES = frozenset({"when", "after", "before", "by the time"})
"""Clauses for which it counts when something gets where they say that it is."""


def elsewhere(clause: Clause, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether a clause is about something done or being at another place than an operation, or the other way.

    "Before we go to the bank" is no going to the station, "before you turn it on" no turning off.
    """
    if clause.where is None or _is_result(clause, lexicon):
        return False
    gets = clause.verb in lexicon.doing.being_somewhere
    place, there = _place(operation), _places(clause)
    if gets and place and _leaves(_words(clause.where), lexicon) != _leaves(_of_place(operation), lexicon):
        # "Before they come out of the oven" is no putting in.
        return True
    placed = place or (gets and operation.is_asked and operation.particle is None)
    if there and placed and there.isdisjoint(place):
        return gets or clause.verb == operation.lemma
    particles = _words(clause.where) & lexicon.particles.keys()
    particle = (operation.particle or "").lower()
    same = clause.verb == operation.lemma and particle in lexicon.particles
    return same and bool(particles) and particle not in particles


def gets_there(clause: Clause, operation: Operation, lexicon: Lexicon) -> bool:
    """Whether something gets where a clause has it by what is asked for: "once the kids are in bed".

    What is said of a thing that was named, as "when the lamp is on", may also be told by readings, and waits
    for them.
    """
    condition, doing = clause.condition, lexicon.doing
    if clause.where is None or condition is None or condition.negated or clause.kind not in SIDES:
        return False
    if clause.verb not in doing.being_somewhere or not (place := _place(operation) | ways_of(operation)):
        return False
    there = _places(clause)
    way = clause.where.split()[0].lower()
    if place.isdisjoint(there if there and _place(operation) else {way}):
        return False
    subject, closed = condition.subject or "", lexicon.closed
    if subject in closed.first_and_second_person:
        return bool(there) and operation.object is None and operation.lemma in doing.leaving | doing.getting
    if subject in closed.anaphors:
        return operation.object is not None and (
            is_several(operation.object, lexicon) == (subject not in closed.singular_anaphors)
        )
    read = clause.verb == "be" and clause.kind == "when" and condition.word is not None
    return not read and not content_words(subject).isdisjoint(content_words(operation.object))


def _is_result(clause: Clause, lexicon: Lexicon) -> bool:
    """Whether a word that may say where says that something is done: "when the incubation is over"."""
    return clause.condition is not None and clause.condition.word in lexicon.results


def _leaves(words: frozenset[str], lexicon: Lexicon) -> bool:
    """Whether words say from where something gets: "out of the oven"."""
    return not words.isdisjoint(lexicon.beside.away_from)


def _words(text: str | None) -> frozenset[str]:
    return frozenset(word.text for word in words_of(text or ""))


def _places(clause: Clause) -> frozenset[str]:
    """Give the words that name where a clause says something is, or gets."""
    return content_words(clause.where) - content_words(clause.object)


def _place(operation: Operation) -> frozenset[str]:
    """Give the words that name where something is done, or put."""
    return content_words(operation.place) | content_words(operation.complement)


def _of_place(operation: Operation) -> frozenset[str]:
    """Give all words that say where something is done or put."""
    return _words(operation.particle) | _words(operation.place)
