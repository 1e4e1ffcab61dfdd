"""What is to be done, by the words below a verb: its object, its place, its particle."""

import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings import OF_CLOCKS
from fuzzytime.language.instruction import Operation, Span
from fuzzytime.language.sentence.actions import SUBJECTS, Action
from fuzzytime.language.sentence.small_clauses import SmallClause, small_clause
from fuzzytime.language.sentence.tree import Tree

OBJECTS = ("dobj", "attr", "oprd", "acomp", "xcomp", "ccomp", "dative")
NAMING = ("NN", "DT", "PRP$")
"""Tags of words that show that a thing is named."""

FINITE = frozenset({"VBZ", "VBP", "VBD"})
PRESENT = frozenset({"am", "is", "are", "'m", "'s", "'re", "’m", "’s", "’re"})
FUTURE = frozenset({"will", "'ll", "’ll"})

PLACES = ("prep", "advmod", "npadvmod")
PEOPLE = frozenset(
    {"i", "you", "we", "he", "she", "they", "someone", "somebody", "anyone", "one", "who", "it", "there"}
)
STATED_OF = ("dobj", "acomp", "oprd", "xcomp", "ccomp")
DUE = frozenset({"due", "over", "back"})
"""What is said of things that have a time: "the delivery is due at two"."""

TRAVELLERS = frozenset({"i", "we", "he", "she", "they"})
"""Who may come and go, and asks nobody to: "we land at nine"."""


@dataclass(frozen=True, slots=True)
class Reader:
    """Reads operations off a tree; ``times`` are the stretches of characters that are about time."""

    tree: Tree
    lexicon: Lexicon
    times: Sequence[Span]

    def operation(self, action: Action) -> Operation:
        """Give the operation of an action."""
        verb = action.place
        node = self.tree.nodes[verb]
        clause = small_clause(self.tree, verb, self.lexicon)
        result = self._participle(verb) if clause is None else self._result(clause)
        particle = self._particle(verb, result)
        moved = self._moved_object(verb, particle)
        whole = moved or self._object(verb, particle, clause)
        split = self._place_within(whole)
        places = [*result, *moved, *([] if particle is None else [particle])]
        stated = self._is_stated(verb)
        return Operation(
            verb=node.lower,
            lemma=node.lemma,
            span=(node.start, node.end),
            object=(self._subject(verb) if stated else None)
            or self._said(whole[:split])
            or self._subject(verb),
            place=self._said(sorted({*whole[split:], *self._place(verb, [*whole[:split], *places])})),
            particle=None if particle is None else self.tree.nodes[particle].lower,
            complement=self._said(result),
            negated=action.negated,
            stated=stated,
        )

    def timed(self, place: int) -> bool:
        """Whether a word is about time."""
        node = self.tree.nodes[place]
        return any(first <= node.start < end for first, end in self.times)

    # -- particles --------------------------------------------------------------------------------------

    def _result(self, clause: SmallClause) -> list[int]:
        """Give the words that say what an object does or becomes, up to the first that is about time."""
        return list(takewhile(lambda place: not self.timed(place), clause.result(self.tree)))

    def _participle(self, verb: int) -> list[int]:
        """Give the participle behind "get", as in "get dressed"."""
        node = self.tree.nodes[verb]
        return [node.head] if node.relation == "auxpass" and not self.timed(node.head) else []

    def _particle(self, verb: int, result: Sequence[int]) -> int | None:
        """Give the word that belongs to the verb: "put the kettle on", "turn on the oven".

        A tree has it for a preposition where a time follows ("on in ten minutes").
        """
        named = next((p for p in self.tree.children(verb, "prt") if not self.timed(p)), None)
        if named is not None:
            return named
        for place in range(verb + 1, len(self.tree.nodes)):
            verbs = self.lexicon.particles.get(self.tree.nodes[place].lower)
            if verbs is None or place in result or self.timed(place) or not self._hangs_on(place, verb):
                continue
            stands_before = place == verb + 1 and self.tree.nodes[verb].lemma in verbs
            bare = not self.tree.children(verb, "dobj") or not self.tree.children(place)
            if self._governs_nothing(place) or (stands_before and bare):
                return place
        return None

    def _hangs_on(self, place: int, verb: int) -> bool:
        node = self.tree.nodes[place]
        # "On the way back"
        owned = self.tree.nodes[node.head].relation == "pobj"
        # "Remind me to take it out"
        nearest = next((above for above in self.tree.above(place) if self._acts(above)), verb)
        return (
            nearest == verb
            and verb in self.tree.above(place)
            and node.tag in {"IN", "RP", "RB"}
            and not owned
        )

    def _acts(self, place: int) -> bool:
        """Whether a word is a verb with "to", which has particles of its own."""
        marks = (self.tree.nodes[p].lower for p in self.tree.children(place, "aux"))
        return self.tree.nodes[place].tag == "VB" and "to" in marks

    def _governs_nothing(self, place: int) -> bool:
        """Whether what follows is no noun for a preposition: a time, another preposition, a mark, the end."""
        if any(child > place and not self.timed(child) for child in self.tree.children(place)):
            return False
        following = place + 1
        if following >= len(self.tree.nodes) or self.timed(following):
            return True
        node = self.tree.nodes[following]
        return node.tag in {"IN", "CC"} or not node.text[0].isalnum()

    def _moved_object(self, verb: int, particle: int | None) -> list[int]:
        """Give the words below a particle that was taken for a preposition: "put on the kettle"."""
        if particle is None or particle != verb + 1:
            return []
        return self._words(self.tree.children(particle, "pobj"), particle)

    # -- objects ----------------------------------------------------------------------------------------

    def _object(self, verb: int, particle: int | None, clause: SmallClause | None) -> list[int]:
        if clause is not None:
            about = clause.about(self.tree)
            return [place for place in self._words([clause.noun], verb) if place in about]
        direct = [*self.tree.children(verb, *OBJECTS), *self._asked(verb)]
        words = self._words([p for p in direct if p > verb and not self.timed(p)], verb)
        if not words:
            # "Empty the bin first thing tomorrow": the tree took the time for the object's noun.
            named = self._words([p for p in direct if p > verb], verb)
            words = named if any(self.tree.nodes[p].tag.startswith(NAMING) for p in named) else []
        if not words:
            # "Do ten minutes of yoga"
            of = (p for d in direct if self.timed(d) for p in self.tree.children(d, "prep"))
            words = self._words([p for o in of for p in self.tree.children(o, "pobj")], verb)
        if not words:
            # "Wake Tim up", "move my three o'clock": what is named was taken for a measure.
            names = self.tree.children(verb, "npadvmod")
            near = [p for p in names if self.tree.reach(p)[0] == verb + 1]
            owned = [p for p in names if self.tree.children(p, "poss")]
            owned += [p for p in near if self.tree.children(p, "det")]
            named = owned or [p for p in names if p == verb + 1 and self.tree.nodes[p].tag == "NNP"]
            words = self._words([p for p in named if not self.timed(p)], verb)
        if not words:
            # "Say hello"
            words = [p for p in self.tree.children(verb, "intj") if p == verb + 1]
        if not words:
            # "Clear it away": a pronoun behind the verb was taken for who does it.
            words = [p for p in self.tree.children(verb, *SUBJECTS) if p == verb + 1]
        if not words and particle is not None:
            # "Let the dog out": the tree has it for a sentence, "the dog is out".
            words = self._words(self.tree.children(particle, *SUBJECTS), verb)
        kept = [*self._before_noun(words, verb), *(place for place in words if place != particle)]
        return self._called_by_time(kept)

    def _called_by_time(self, words: list[int]) -> list[int]:
        """Give an object with the time that it is called by: "catch the 7:42"."""
        if not words or self.tree.nodes[words[-1]].tag != "DT" or self.tree.nodes[words[-1]].lower != "the":
            return words
        here = words[-1] + 1
        while here < len(self.tree.nodes) and self.timed(here) and self._is_clock(here):
            words.append(here)
            here += 1
        return words

    def _is_clock(self, place: int) -> bool:
        """Whether a word is of a clock time, and no day."""
        return self.tree.nodes[place].tag == "CD" or self.tree.nodes[place].lower in OF_CLOCKS

    def _asked(self, verb: int) -> list[int]:
        """Give what somebody is asked to do, where a time stands between: "remind me on Thursday to call"."""
        if self.tree.nodes[verb].lemma not in self.lexicon.addressing | {"get"}:
            return []
        return [
            place
            for place in self.tree.children(verb, "advcl")
            if any(self.tree.nodes[p].lower == "to" for p in self.tree.children(place, "aux"))
        ]

    def _before_noun(self, words: Sequence[int], verb: int) -> list[int]:
        """Give the words right before an object that a tree took for a time: "install the night light"."""
        between = list(range(verb + 1, words[0])) if words else []
        measured = between and self.tree.nodes[between[-1]].relation == "npadvmod"
        return between if measured and not any(self.timed(place) for place in between) else []

    def _place_within(self, words: Sequence[int]) -> int:
        """Give where, in an object, the words begin that say where it is: "the pancakes in the pan"."""
        inside = set(words)
        for position, place in enumerate(words[1:], start=1):
            node = self.tree.nodes[place]
            head = self.tree.nodes[node.head]
            of_noun = node.relation == "prep" and node.head in inside and head.relation in {"dobj", "pobj"}
            where = node.lower in self.lexicon.places and of_noun and self._has_content(place, words)
            if where and set(words[position:]) <= set(self._preposed(words[position:])):
                return position
        return len(words)

    def _preposed(self, words: Sequence[int]) -> Iterator[int]:
        """Give the words that are below a preposition among them."""
        for place in words:
            if self.tree.nodes[place].relation == "prep":
                yield from self.tree.below(place)

    def _subject(self, verb: int) -> str | None:
        """Give what a statement is about: "the assignment should start now"."""
        node = self.tree.nodes[verb]
        # "The sauce needs to simmer"
        verbs = (verb, node.head) if node.relation == "xcomp" else (verb,)
        subjects = [p for v in verbs for p in self.tree.children(v, *SUBJECTS) if not self.timed(p)]
        if not subjects or self.tree.nodes[subjects[0]].lower in PEOPLE:
            return None
        return self._said([p for p in sorted(self.tree.below(subjects[0])) if not self.timed(p)])

    def _is_stated(self, verb: int) -> bool:
        """Whether somebody or something is said to do it, and to nothing: "the guests arrive at six"."""
        subjects = [self.tree.nodes[p].lower for p in self.tree.children(verb, "nsubj")]
        helping = {self.tree.nodes[p].lower for p in self.tree.children(verb, "aux", "auxpass", "neg")}
        finite = self.tree.nodes[verb].tag in FINITE if not helping else helping <= FUTURE
        finite = finite or (self.tree.nodes[verb].tag == "VBG" and bool(helping) and helping <= PRESENT)
        told = bool(subjects) and subjects[0] not in PEOPLE - TRAVELLERS
        due = DUE | self.lexicon.results if helping & FUTURE else DUE
        rest = [p for p in self.tree.children(verb, *STATED_OF) if self.tree.nodes[p].lower not in due]
        return told and finite and not rest

    # -- places -----------------------------------------------------------------------------------------

    def _place(self, verb: int, taken: Iterable[int]) -> list[int]:
        below = [p for p in self.tree.children(verb, *PLACES) if p > verb and not self.timed(p)]
        kept = [p for p in below if self._is_place(p)] + list(self._behind_times(verb))
        kept += [p for p in self.tree.children(verb, "advcl", "xcomp") if self._is_numbered(p)]
        words = [p for p in self._words(kept, verb) if p not in set(taken)]
        return [p for p in words if self._has_content(p, words)]

    def _is_place(self, place: int) -> bool:
        node = self.tree.nodes[place]
        numbers = (
            child for child in (place, *self.tree.children(place)) if self.tree.nodes[child].tag == "CD"
        )
        counted = node.relation == "npadvmod" and any(numbers)
        if node.relation == "advmod" and node.lower in self.lexicon.particles:
            # "Go back to the dock"
            return bool(self.tree.children(place, "prep"))
        return node.relation == "prep" or counted or node.lower in self.lexicon.places

    def _is_numbered(self, place: int) -> bool:
        """Whether a verb with "to" is a place with a number: "take it to station 4"."""
        numbers = (p for p in self.tree.children(place, "dobj", "nummod") if self.tree.nodes[p].tag == "CD")
        known = self.lexicon.machines | self.lexicon.measure_nouns
        return self.tree.nodes[place].lower in known and self._acts(place) and any(numbers)

    def _behind_times(self, verb: int) -> Iterator[int]:
        """Give the prepositions that a tree hangs on a time: "flip it in two minutes in the pan"."""
        for place in self.tree.below(verb):
            node = self.tree.nodes[place]
            said = node.relation == "prep" and node.lower in self.lexicon.places
            if said and not self.timed(place) and self.timed(node.head):
                yield place

    def _has_content(self, place: int, words: Sequence[int]) -> bool:
        """Whether a preposition still has what it governs: that may have been a time."""
        if self.tree.nodes[place].relation != "prep":
            return True
        return any(below in words for below in self.tree.below(place) if below != place)

    # -- words ------------------------------------------------------------------------------------------

    def _words(self, parts: Sequence[int], verb: int) -> list[int]:
        """Give the words under some words, up to the first that is about time."""
        found: list[int] = []
        for part in parts:
            for place in sorted(self.tree.below(part)):
                if place <= verb:
                    continue
                if self.timed(place):
                    if place < part or self._describes(place):
                        # "Drive ten minutes north", "a ten minute walk"
                        continue
                    break
                found.append(place)
        return sorted(set(found))

    def _describes(self, place: int) -> bool:
        """Whether a word about time belongs to a noun behind it: "a ten minute walk"."""
        head = next((p for p in self.tree.above(place) if not self.timed(p)), place)
        return head > place and self.tree.nodes[head].lower in self.lexicon.lasting

    def _said(self, words: Sequence[int]) -> str | None:
        """Give words as typed, single spaces between those that stood apart, without marks at the ends."""
        kept = list(words)
        while kept and not _names(self.tree.nodes[kept[-1]].text[-1]):
            kept.pop()
        while kept and not _names(self.tree.nodes[kept[0]].text[0]):
            kept.pop(0)
        text = ""
        last = None
        for place in kept:
            node = self.tree.nodes[place]
            text += ("" if last is None or last == node.start else " ") + node.text
            last = node.end
        return text.strip() or None


def _names(character: str) -> bool:
    """Whether a character is no mark: a picture says as much as a word, "€" what is paid."""
    return character.isalnum() or unicodedata.category(character) in {"So", "Sk", "Sc", "Mn", "Me", "Cf"}
