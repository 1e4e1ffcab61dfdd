"""Which instruction words refer to: "after setting the table", "when the rice is done", "it"."""

import heapq
import re
from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import groupby

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.references.told import Told
from fuzzytime.language.sentence.trees.content_words import content_words, stems
from fuzzytime.language.sentence.trees.named import is_event, is_several, may_be_it, names_person

NEAR = 50
"""Among how many that are put somewhere the one is looked for that a clause has there."""

_OWNERS = re.compile(r"(\w+) ?['\u2019]s\b")


def shares_thing(one: Operation, other: Operation) -> bool:
    """Whether two operations name the same thing, as what they are about or as its place."""
    named = (content_words(part.object) | content_words(part.place) for part in (one, other))
    return not frozenset.intersection(*named).isdisjoint(content_words(one.object))


def comes(happening: Operation, lexicon: Lexicon) -> bool:
    """Whether somebody or something is said to come, and is not there before."""
    return happening.stated and happening.lemma in lexicon.doing.arriving


def comes_by_name(happening: Operation, lexicon: Lexicon) -> bool:
    """Whether what is told has the name of what, or who, comes: a delivery, guests."""
    # "Delivery due between ten and eleven"
    words = [word for word in (happening.object or "").lower().split() if word not in lexicon.beside.due]
    comes_so = not (lexicon.closed.coming | lexicon.persons).isdisjoint(words[-1:])
    elsewhere = happening.particle or happening.place
    return happening.stated and happening.lemma == "be" and comes_so and not elsewhere


def comes_back(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether somebody who speaks is said to be back then: "we'll be home by six"."""
    said = {operation.particle, operation.place, operation.complement, operation.object}
    return (
        operation.stated
        and operation.lemma in {"be", "get", "come"}
        and not lexicon.closed.back_home.isdisjoint(said)
    )


def waits_for(operation: Operation, happening: Operation, lexicon: Lexicon) -> bool:
    """Whether something can be done only when what comes is there: "the truck arrives at ten. Unload it"."""
    return comes(happening, lexicon) and not operation.stated and shares_thing(happening, operation)


def undoes(operation: Operation, earlier: Operation, lexicon: Lexicon) -> bool:
    """Whether an operation undoes what was done before: it stops what was started, shuts what was opened."""
    undone = lexicon.undoing.get(operation.phrase, frozenset())
    if not undone and operation.place is not None:
        # "Take it off the heat"
        undone = lexicon.undoing.get(f"{operation.lemma} {operation.place.split()[0].lower()}", frozenset())
    # "Pour it in", "pour it out"
    same = operation.lemma == earlier.lemma and operation.particle is not None
    back = same and earlier.particle in lexicon.undoing.get(operation.particle or "", frozenset())
    return earlier.is_asked and (back or earlier.phrase in undone)


@dataclass(slots=True)
class Mentions:
    """The operations of all texts in order, and where each word and each verb names one.

    What was denied names nothing: nobody refers to "don't peel the apples". ``told`` is what was
    told of their times.
    """

    lexicon: Lexicon
    operations: list[Operation | None] = field(default_factory=list)
    told: Told = field(default_factory=Told)
    _by_word: dict[str, list[int]] = field(default_factory=dict)
    _by_verb: dict[str, list[int]] = field(default_factory=dict)
    _bare: dict[str, list[int]] = field(default_factory=dict)
    _by_way: dict[str, list[int]] = field(default_factory=dict)
    _things: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))
    _goods: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))
    _people: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))

    def add(self, operation: Operation | None) -> None:
        """Add the next operation, None for an instruction without one."""
        position = len(self.operations)
        self.operations.append(operation)
        if operation is None:
            return
        named = operation.object
        if named is not None and names_person(named, self.lexicon):
            self._people[is_several(named, self.lexicon)].append(position)
        if may_be_it(operation, self.lexicon):
            several = is_several(operation.object or "", self.lexicon)
            self._things[several].append(position)
            if not is_event(operation, self.lexicon):
                self._goods[several].append(position)
        if operation.negated:
            return
        words = content_words(operation.object)
        for noun in nouns_of(operation.lemma)[1:]:
            self._by_verb.setdefault(noun, []).append(position)
        known = words | content_words(operation.place)
        for word in known | stems(known | {operation.lemma}):
            self._by_word.setdefault(word, []).append(position)
        self._by_verb.setdefault(operation.lemma, []).append(position)
        for way in ways_of(operation):
            self._by_way.setdefault(way, []).append(position)
        if not words | content_words(operation.place):
            self._bare.setdefault(operation.lemma, []).append(position)

    def thing(self, before: int, *, several: bool, strictly: bool = False, goods: bool = False) -> str | None:
        """Give the latest object that "it" or "them" may be, of either number unless ``strictly``.

        Where ``goods`` are meant, "handover at noon" is what something is done before, and no object of it.
        """
        things = self._goods if goods else self._things
        one, many = (positions[: bisect_left(positions, before)][-1:] for positions in things)
        found = (many if several else one) or ([] if strictly else sorted(one + many)[-1:])
        operation = self.operations[found[0]] if found else None
        return None if operation is None else operation.object

    def person(self, before: int, pronoun: str, *, several: bool) -> str | None:
        """Give the latest person who was named in an object and is called so, or the latest persons."""
        called = self.lexicon.called
        others = {
            word for one, words in called.items() if pronoun in called and one != pronoun for word in words
        }
        found = self._people[several]
        for place in reversed(found[: bisect_left(found, before)]):
            operation = self.operations[place]
            person = None if operation is None else _person_of(operation, self.lexicon)
            if person is not None and others.isdisjoint(person.lower().split()):
                return person
        return None

    def about(self, words: frozenset[str], before: int) -> int | None:
        """Give the latest position before one whose object has all of some words."""
        runs = sorted((self._by_word.get(word, []) for word in words), key=len)
        for position in reversed(runs[0][: bisect_left(runs[0], before)] if runs else []):
            operation = self.operations[position]
            if operation is not None and words <= content_words(operation.object):
                return position
        return None

    def told_behind(self, words: frozenset[str], place: int) -> int | None:
        """Give the first position from one on where it is told when something is: "lunch is at twelve"."""
        runs = sorted((self._by_word.get(word, []) for word in words), key=len)
        for position in runs[0][bisect_left(runs[0], place) :] if runs else []:
            operation = self.operations[position]
            if operation is not None and words <= content_words(operation.object) and self.tells(operation):
                return position
        return None

    def telling(self) -> Iterator[Operation]:
        """Give what happens, and what is eaten."""
        return (operation for operation in self.operations if operation is not None and self.tells(operation))

    def tells(self, operation: Operation) -> bool:
        """Whether something happens, or a meal is eaten: by its time others may be told."""
        return operation.stated or (operation.is_asked and operation.lemma in self.lexicon.doing.eating)

    def touching(self, words: frozenset[str], before: int, owners: frozenset[str]) -> int | None:
        """Give the latest position before one of what is to be done with something that words name."""
        stretch = range(before)
        runs = [_within(by.get(word, []), stretch) for word in words for by in (self._by_word, self._by_verb)]
        for position in heapq.merge(*(reversed(run) for run in runs), reverse=True):
            if is_done_with(self.operations[position], words, owners):
                return position
        return None

    def named_by(
        self, clause: Clause, stretch: range, *, backwards: bool, every: bool = False
    ) -> Iterator[int]:
        """Give the positions in a stretch that a clause may be about, the nearest end first.

        Of those that only the verb names, the nearest is as good as any, unless ``every`` one is looked for.
        """
        closed = self.lexicon.closed
        named, words = names_of(clause)
        single = [self._bare.get(clause.verb or "", [])]
        single += [self._by_verb.get(noun, []) for noun in words]
        if clause.verb is not None and not named - closed.anaphors:
            # "While she naps": what happens may have that name.
            words |= frozenset(nouns_of(clause.verb))
        if not named or named <= closed.anaphors | closed.universal_pronouns:
            single.append(self._by_verb.get(clause.verb or "", []))
        end = slice(None) if every else slice(-1, None) if backwards else slice(1)
        runs = [_within(run, stretch)[end] for run in single]
        if clause.where is not None:
            # "Before they go in the oven", "after it comes out"
            words |= content_words(clause.where)
            run = _within(self._by_way.get(clause.where.partition(" ")[0].lower(), []), stretch)
            runs.append(run[-NEAR:] if backwards else run[:NEAR])
        runs += [_within(self._by_word.get(word, []), stretch) for word in words | stems(words)]
        ordered = (reversed(run) if backwards else iter(run) for run in runs)
        for position, _ in groupby(heapq.merge(*ordered, reverse=backwards)):
            yield position


def _person_of(operation: Operation, lexicon: Lexicon) -> str | None:
    """Give who is named by an operation: of "the physio comes for Mr Brandt", him."""
    _, _, whom = (operation.place or "").partition(" ")
    return whom if operation.stated and names_person(whom, lexicon) else operation.object


def ways_of(operation: Operation) -> frozenset[str]:
    """Give the particle of a verb, and the first word of where something is put: "in" of "in the oven"."""
    words = ((operation.particle or "").split(), (operation.place or "").split()[:1])
    return frozenset(word.lower() for said in words for word in said)


def nouns_of(verb: str) -> tuple[str, ...]:
    """Give the words that name what a verb says: the walk, the baking, the addition, the removal."""
    bare = verb.removesuffix("e")
    latin = (f"{bare}{ending}" for ending in ("ion", "ation", "ition", "al"))
    nouns = (verb, f"{bare}ing", f"{verb}{verb[-1:]}ing", f"{verb}ment", *latin)
    # The bath, where somebody is bathed.
    return (*nouns, bare) if verb.endswith("the") else nouns


def verb_forms(verb: str, lexicon: Lexicon) -> frozenset[str]:
    """Give a verb as it is said of now and of before: come, coming, came; of one or several."""
    bare, last = verb.removesuffix("e"), verb[-1:]
    regular = {verb, f"{bare}ing", f"{verb}{last}ing", f"{bare}ed", f"{verb}{last}ed"}
    return frozenset(regular | lexicon.past.get(verb, frozenset()))


def owners_in(thing: str | None) -> frozenset[str]:
    """Give whose a thing is said to be: "Beta's battery" is no other's."""
    return content_words(" ".join(_OWNERS.findall(thing or "")))


def is_done_with(operation: Operation | None, words: frozenset[str], owners: frozenset[str]) -> bool:
    """Whether an operation asks for something to be done with what words name, which may be its verb."""
    if operation is None or not operation.is_asked:
        return False
    known = content_words(operation.object) | content_words(operation.place)
    return owners <= known | owners_in(operation.object) and not words.isdisjoint(
        known.union(nouns_of(operation.lemma))
    )


def _within(positions: list[int], stretch: range) -> list[int]:
    return positions[bisect_left(positions, stretch.start) : bisect_left(positions, stretch.stop)]


def names_of(clause: Clause) -> tuple[frozenset[str], frozenset[str]]:
    """Give the words of a clause's object, and with them those of its subject."""
    named = content_words(clause.object)
    subject = None if clause.condition is None else clause.condition.subject
    return named, named | content_words(subject)
