"""What is to be done, by the words below a verb: its object, its place, its particle."""

from collections.abc import Iterator
from dataclasses import dataclass

from fuzzytime.language.grammar.words import is_quoted
from fuzzytime.language.instruction import Operation, overlap
from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.verbs.meant.actions import FINITE, Action
from fuzzytime.language.sentence.verbs.meant.small_clauses import SmallClause, small_clause
from fuzzytime.language.sentence.verbs.operations.particles import Particles
from fuzzytime.language.sentence.verbs.statements.called import person_due, worker_doing
from fuzzytime.language.sentence.verbs.statements.statements import others_do

OBJECTS = ("dobj", "attr", "oprd", "acomp", "xcomp", "ccomp", "dative")
AIMS = ("advcl", "xcomp", "acl", "relcl")
NAMING = ("NN", "DT", "PRP$")
"""Tags of words that show that a thing is named."""


@dataclass(frozen=True, slots=True)
class Reader(Particles):
    """Reads operations off a tree."""

    def operation(self, action: Action) -> Operation:
        """Give the operation of an action."""
        verb, node = action.place, self.tree.nodes[action.place]
        clause = small_clause(self.tree, verb)
        result = self._participle(verb) if clause is None else self._result(clause)
        result = result or self._joined_result(verb) or self._let(verb)
        particle = self._particle(verb, result)
        moved = self._moved_object(verb, particle)
        whole = moved or self._object(verb, particle, clause)
        split = self.place_within(whole)
        places = [*result, *moved, *([] if particle is None else [particle])]
        doer = worker_doing(self.tree, verb) or person_due(self.tree, verb)
        stated = doer is None and self._is_stated(verb)
        subject = self._subject(verb) if doer is None else None
        direct, complement = self._named(verb, subject, whole[:split], result, stated=stated)
        attended = stated and self._is_attended(verb)
        where = sorted({*whole[split:], *self.place(verb, [*whole[:split], *places])})
        if attended and not where and direct is complement is None:
            attending = self.attending(verb)
            direct, particle = self.said(attending), None if particle in attending else particle
        whole_verb = self._whole_verb(verb)
        taken = [*whole, *places, *whole_verb[:-1], *where]
        purpose = [] if stated else self._purpose(verb, taken)
        how = [] if stated and node.lemma == "be" else self.manner(verb, [*taken, *purpose])
        return Operation(
            # "Robot 2 cleans the tank" asks it to clean the tank.
            verb=" ".join(self.tree.nodes[p].lower for p in whole_verb) if doer is None else node.lemma,
            lemma="be" if stated and (self._has_then(verb) or self._is_standing(verb)) else node.lemma,
            span=(self.tree.nodes[whole_verb[0]].start, node.end),
            object=direct,
            place=self._within_sentence(where),
            particle=None if particle is None else self.tree.nodes[particle].lower,
            complement=complement,
            manner=self._within_sentence(how),
            purpose=self.said(purpose),
            addressee=doer,
            due=None if stated or subject is None or direct != subject else self._must(verb),
            negated=action.negated,
            stated=stated,
            attended=attended,
        )

    def _named(
        self, verb: int, subject: str | None, words: list[int], result: list[int], *, stated: bool
    ) -> tuple[str | None, str | None]:
        """Give what is done something with, or happens, and what it becomes."""
        direct, complement = self.said(words), self.said(result)
        if direct is None and not stated:
            direct = self._due(verb)
        elif stated and subject is None and self._takes(verb):
            # "It needs an hour in the oven"
            direct = None
        if subject is not None and (stated or direct is None or self._is_needed_by(verb)):
            acted = self._is_needed_by(verb) or others_do(self.tree, verb, self._helping(verb))
            return subject, complement or (direct if acted else None)
        if subject is not None and self.tree.nodes[verb].lemma == "be":
            # "The coffee should be ready by then"
            return subject, direct
        return direct, complement

    def _is_needed_by(self, verb: int) -> bool:
        """Whether somebody or something needs a thing, and none is asked to need it: "the car needs fuel"."""
        node = self.tree.nodes[verb]
        return node.tag in FINITE and node.lemma in self.lexicon.doing.needing

    def _purpose(self, verb: int, taken: list[int]) -> list[int]:
        """Give what it is done for: "go to the shop at six to buy milk"."""
        asked = [p for p in self.tree.children(verb, "xcomp", "ccomp", "dobj") if p > verb]
        # "Set a reminder for six to feed the cat": a tree may hang it on the time.
        over = [verb, *asked, *(p for p in self.tree.below(verb) if self.timed(p))]
        for aim in sorted(p for place in over for p in self.tree.children(place, *AIMS)):
            to = next((p for p in self.tree.children(aim, "aux") if self.tree.nodes[p].lower == "to"), aim)
            said = self.words([aim], to - 1)
            if self.has_to(aim) and not self.timed(aim) and set(taken).isdisjoint(said):
                return said
        return []

    def _within_sentence(self, words: list[int]) -> str | None:
        """Give words without the capital that begins a sentence."""
        said = self.said(words)
        return said if said is None or 0 not in words else said[:1].lower() + said[1:]

    def _takes(self, verb: int) -> bool:
        """Whether a verb says how long something takes, and of nothing that is done."""
        taking = self.tree.nodes[verb].lemma in self.lexicon.doing.taking
        return taking and not self.tree.children(verb, "xcomp")

    def _moved_object(self, verb: int, particle: int | None) -> list[int]:
        """Give the words below a particle that was taken for a preposition: "put on the kettle"."""
        if particle is None or particle != verb + 1:
            return []
        return self.words(self.tree.children(particle, "pobj"), particle)

    def _object(self, verb: int, particle: int | None, clause: SmallClause | None) -> list[int]:
        if clause is not None:
            about = clause.about(self.tree)
            return [place for place in self.words([clause.noun], verb) if place in about]
        words = next((found for found in self._objects(verb, particle) if found), [])
        kept = [*self._before_noun(words, verb), *(place for place in words if place != particle)]
        return self._with_quoted(self._called_by_time(self.with_numbers(kept)), verb)

    def _with_quoted(self, words: list[int], verb: int) -> list[int]:
        """Give an object with what is quoted behind it, or behind the verb: "send mum the word "hello""."""
        behind = max(words, default=verb) + 1
        said = self.tree.nodes[behind : behind + 1]
        quoted = any(
            is_quoted(n.text) and not any(overlap((n.start, n.end), t) for t in self.times) for n in said
        )
        return [*words, behind] if quoted else words

    def _objects(self, verb: int, particle: int | None) -> Iterator[list[int]]:
        """Give what may be a verb's object, the likeliest first; some are empty."""
        level = self.level(verb)
        found = (*self.tree.children(verb, *OBJECTS), *self._asked(verb))
        level = [*level, *self._let(verb)]
        direct = [p for p in found if p > verb and p not in level and not self._is_apart(p)]
        direct = [p for p in direct if not self.names_company(p)]
        # "Do ten minutes of yoga", "give the patient five minutes of oxygen"
        of = (p for d in direct if self.timed(d) for p in self.tree.children(d, "prep"))
        thing = [p for o in of for p in self.tree.children(o, "pobj", "pcomp")]
        yield self.words([*(p for p in direct if not self.timed(p)), *thing], verb)
        yield self._inquired(verb)
        # "Empty the bin first thing tomorrow": the tree took the time for the object's noun.
        named = self.words(direct, verb)
        yield named if any(self.tree.nodes[p].tag.startswith(NAMING) for p in named) else []
        # "Do the backup daily"
        often = [p for p in self.tree.children(verb, "advmod", "npadvmod") if p > verb and self.timed(p)]
        below = ((p, self.tree.nodes[d]) for p in often for d in self.tree.below(p) if not self.timed(d))
        yield self.words([p for p, node in below if node.relation == "det"], verb)
        yield self._taken_for_measure(verb, particle)
        # "Say hello"
        yield [p for p in self.tree.children(verb, "intj") if p == verb + 1]
        if particle == verb + 1:
            # "Turn off oven": without an article, the tree has the thing for an adverb.
            near = [p for p in self.tree.children(verb, "advmod") if p == verb + 2 and not self.timed(p)]
            yield [p for p in near if self.tree.nodes[p].lower not in self.lexicon.places]
        # "Clear it away": a pronoun behind the verb was taken for who does it, "put both away" for how much.
        yield [p for p in self.tree.children(verb, *SUBJECTS) if p == verb + 1]
        yield [p for p in range(verb + 1, verb + 2) if self._are_all(p)]
        yield self.numbers_from(verb + 1)
        if particle is not None:
            # "Let the dog out": the tree has it for a sentence, "the dog is out".
            yield self.words(self.tree.children(particle, *SUBJECTS), verb)

    def _inquired(self, verb: int) -> list[int]:
        """Give what is found out: "check if the parcel is there", which trees take for a condition."""
        node, words = self.tree.nodes[verb], self.tree.nodes[verb : verb + 2]
        found = " ".join(word.lower for word in words) in self.lexicon.doing.finding_out
        if not found and node.lemma not in self.lexicon.doing.inquiring | {"find"}:
            return []
        # "Find out when the next bus leaves"
        marks = {"if", "when"} if found else {"if"}
        asked = (
            p
            for p in self.tree.children(verb, "advcl", "ccomp")
            if any(self.tree.nodes[m].lower in marks for m in self.tree.children(p, "mark", "advmod"))
        )
        return self.words([p for p in asked if p > verb], verb)

    def _taken_for_measure(self, verb: int, particle: int | None) -> list[int]:
        """Give what is named where a tree has it for a measure: "wake Tim up", "move my three o'clock"."""
        names = self.tree.children(verb, "npadvmod")
        behind = verb + 2 if particle == verb + 1 else verb + 1
        near = [p for p in names if self.tree.reach(p)[0] == behind]
        owned = [p for p in names if self.tree.children(p, "poss")]
        # "Text Jo Smith at five"
        owned += [p for p in near if self.tree.children(p, "det") or self.tree.nodes[p].tag == "NNP"]
        named = owned or [p for p in names if p == behind and self._is_named(p)]
        return self.words([p for p in named if not self.timed(p)], verb)

    def _is_apart(self, place: int) -> bool:
        """Whether a sentence says what for, or is its own: "so it's done by seven", ", he never eats"."""
        if self.tree.nodes[place].relation != "ccomp":
            return False
        subjects = [p for p in self.tree.children(place, *SUBJECTS) if p < place]
        starts = {self.tree.reach(place)[0], *(self.tree.reach(p)[0] for p in subjects)}
        behind_mark = any(self.tree.nodes[p - 1].text == "," for p in starts if p)
        return self.tree.nodes[min(starts) - 1].lower == "so" or (bool(subjects) and behind_mark)

    def _are_all(self, place: int) -> bool:
        """Whether a word alone is all that is meant: "put both away"."""
        node = self.tree.nodes[place] if place < len(self.tree.nodes) else None
        alone = node is not None and node.lower in self.lexicon.closed.both | self.lexicon.closed.wholes
        return alone and self.tree.nodes[place + 1 : place + 2] != ()

    def _is_named(self, place: int) -> bool:
        """Whether a word names somebody, or what has no article: "move bingo to two"; but "walk home"."""
        node = self.tree.nodes[place]
        return node.tag in {"NNP", "NN"} and node.lower not in self.lexicon.places

    def _called_by_time(self, words: list[int]) -> list[int]:
        """Give an object with the time that it is called by: "catch the 7:42", "the 4.15 train"."""
        articles = [place for place in words if self.tree.nodes[place].lower == "the"]
        here = first = articles[-1] + 1 if articles else len(self.tree.nodes)
        while here < len(self.tree.nodes) and self.timed(here) and self._is_clock(here):
            here += 1
        train = here < len(self.tree.nodes) and self.tree.nodes[here].lower in self.lexicon.travelling
        called = range(first, here + train) if here > first else ()
        return sorted({*words, *called}) if train or first == max(words, default=0) + 1 else words

    def _is_clock(self, place: int) -> bool:
        """Whether a word is of a clock time, and no day."""
        return (
            self.tree.nodes[place].tag == "CD"
            or self.tree.nodes[place].lower in self.lexicon.beside.of_clocks
        )

    def _asked(self, verb: int) -> list[int]:
        """Give what somebody is asked to do, where a time stands between: "remind me on Thursday to call"."""
        if self.tree.nodes[verb].lemma not in self.lexicon.addressing | {"get"}:
            return []
        # "Remind me every day for a week to call"
        of_times = self.tree.children(verb, "prep", "npadvmod") if self.tree.children(verb, "dobj") else ()
        below = [p for time in of_times if self.timed(time) for p in self.tree.below(time)]
        aims = [p for p in below if self.has_to(p) and self.timed(self.tree.nodes[p].head)]
        return aims or [
            place
            for place in self.tree.children(verb, "advcl")
            if "to" in self.tree.said(self.tree.children(place, "aux"))
        ]
