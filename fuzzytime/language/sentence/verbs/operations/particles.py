"""The word that belongs to a verb, and what its object becomes: "put the kettle on", "keep it warm"."""

from collections.abc import Sequence
from dataclasses import dataclass

from fuzzytime.language.sentence.trees.tags import SUBJECTS
from fuzzytime.language.sentence.verbs.meant.actions import FINITE
from fuzzytime.language.sentence.verbs.meant.small_clauses import SmallClause
from fuzzytime.language.sentence.verbs.statements.stated import Stated


@dataclass(frozen=True, slots=True)
class VerbWords(Stated):
    """Reads off a tree which words belong to a verb."""

    def _participle(self, verb: int) -> list[int]:
        """Give the participle behind "get", with what hangs on it: "get dressed", "get rid of the boxes"."""
        done = self.tree.nodes[verb].head
        if self.tree.nodes[verb].relation != "auxpass" or self.timed(done):
            return []
        return [done, *self.words(self.tree.children(done, "prep"), done)]

    def _let(self, verb: int) -> list[int]:
        """Give what is let be done with what is not named again: "cover and let stand"."""
        if self.tree.nodes[verb].lemma not in self.lexicon.letting:
            return []
        nodes = self.tree.nodes
        done = verb + 1 + (nodes[verb + 1 : verb + 2] != () and nodes[verb + 1].lower == "to")
        below = self.tree.children(verb, "xcomp", "ccomp", "dobj", "acomp")
        rests = done in below and nodes[done].lower in self.lexicon.doing.resting
        acts = below == (done,) and nodes[done].tag in {"VB", "VBP"}
        return self.words([done], verb) if rests or acts else []

    def _joined_result(self, verb: int) -> list[int]:
        """Give what "and" joins to a particle as what somebody is then: "get him up and washed".

        Or to what is done with something as what is done with it next: "it must be signed and sent back".
        """
        node = self.tree.nodes[verb]
        done = node.tag == "VBN" and self.tree.children(verb, "auxpass")
        if not done and (node.lemma not in self.lexicon.causing or not self.tree.children(verb, "dobj")):
            return []
        for place in self.tree.children(verb, "conj"):
            state = self.tree.nodes[place].tag in {"VBN", "VBD", "JJ"} and not self.timed(place)
            own = self.tree.children(place, *SUBJECTS, "dobj", "aux", "auxpass")
            if state and not own and place > 1 and self.tree.nodes[place - 1].tag == "CC":
                return [place - 1, *(self.words([place], verb) if done else [place])]
        return []

    def _whole_verb(self, verb: int) -> list[int]:
        """Give a verb with the word in front that makes another of it: "deep clean it", "test drive it"."""
        front = verb - 1
        if (
            front < 0
            or not self.tree.children(verb, "dobj")
            or self.tree.nodes[verb].tag not in {"VB", "VBP"}
        ):
            return [verb]
        node = self.tree.nodes[front]
        opens = not front or self.tree.nodes[front - 1].text in {",", ":"} or self.timed(front - 1)
        alone = node.head == verb and not self.tree.children(front) and not self.timed(front)
        known = self.lexicon.function_words | self.lexicon.vague_adverbs | self.lexicon.persons
        named = node.lower in known | self.lexicon.machines | self.lexicon.workers | self.lexicon.places
        flat = node.tag in {"JJ", "RB"} and not node.lower.endswith(
            tuple(self.lexicon.closed.endings_of_manner)
        )
        acts = node.tag == "NN" and node.may_act
        return [front, verb] if opens and alone and not named and (flat or acts) else [verb]

    def _before_noun(self, words: Sequence[int], verb: int) -> list[int]:
        """Give the words right before an object that a tree took for a time: "install the night light"."""
        between = list(range(verb + 1, words[0])) if words else []
        measured = between and self.tree.nodes[between[-1]].relation == "npadvmod"
        return between if measured and not any(self.timed(place) for place in between) else []


@dataclass(frozen=True, slots=True)
class Particles(VerbWords):
    """The words around a verb that say what becomes of its object."""

    def _result(self, clause: SmallClause) -> list[int]:
        """Give the words that say what an object does or becomes, without those about time."""
        # "Until the end of the film": of what, belongs to the time.
        timed = {place for place in clause.result(self.tree) if self.timed(place)}
        words = [p for p in clause.result(self.tree) if timed.isdisjoint((p, *self.tree.above(p)))]
        words = [place for place in words if self.has_content(place, words)]
        # "Have it inspected every week and after each storm"
        return words[:-1] if words and self.tree.nodes[words[-1]].tag == "CC" else words

    def _particle(self, verb: int, result: Sequence[int]) -> int | None:
        """Give the word that belongs to the verb: "put the kettle on", "turn on the oven".

        A tree has it for a preposition where a time follows ("on in ten minutes").
        """
        level = self.level(verb)
        named = next(
            (p for p in self.tree.children(verb, "prt") if not self.timed(p) and p not in level), None
        )
        if named is not None:
            return named
        if any(node.lower in self.lexicon.doing.sure for node in self.tree.nodes[verb + 1 : verb + 2]):
            # "Make sure everyone is out"
            return None
        for place in range(verb + 1, len(self.tree.nodes)):
            text = self.tree.nodes[place].lower
            verbs = self.lexicon.doing.taking_care if text == "after" else self.lexicon.particles.get(text)
            if self.tree.nodes[place - 1].tag == "CC" or self._is_between(place):
                # "To the gate and back", "with a rest in between"
                continue
            if (
                verbs is None
                or place in level
                or place in result
                or self.timed(place)
                or not self._hangs_on(place, verb)
            ):
                continue
            stands_before = place == verb + 1 and self.tree.nodes[verb].lemma in verbs
            bare = not self.tree.children(verb, "dobj") or not self.tree.children(place)
            if (self._governs_nothing(place) and text != "after") or (stands_before and bare):
                return place
        return None

    def _is_between(self, place: int) -> bool:
        return place + 1 < len(self.tree.nodes) and self.tree.nodes[place + 1].lower == "between"

    def _hangs_on(self, place: int, verb: int) -> bool:
        node = self.tree.nodes[place]
        # "On the way back"
        owned = self.tree.nodes[node.head].relation == "pobj"
        above = list(self.tree.above(place))
        if verb not in above:
            return False
        # "Remind me to take it out", "tell Ann that the meeting is off"; but "turn it on | before I leave"
        below = [p for p in above[: above.index(verb)] if self.tree.reach(p)[0] != place]
        # "Sow peas for planting out"
        inner = any(self.has_to(p) or self._is_told(p) for p in below)
        inner = inner or any(self.tree.nodes[p].relation == "pcomp" for p in below)
        return not inner and node.tag in {"IN", "RP", "RB"} and not owned

    def _is_told(self, verb: int) -> bool:
        """Whether a verb with who or what it is about tells something: "the meeting is off"."""
        verbs = (verb, *self.tree.children(verb, "aux", "auxpass"))
        finite = any(self.tree.nodes[p].tag in FINITE | {"MD"} for p in verbs)
        return finite and any(p < verb for p in self.tree.children(verb, *SUBJECTS))

    def _governs_nothing(self, place: int) -> bool:
        """Whether what follows is no noun for a preposition: a time, another preposition, a mark, the end."""
        if any(child > place and not self.timed(child) for child in self.tree.children(place)):
            return False
        following = place + 1
        if following >= len(self.tree.nodes) or self.timed(following):
            return True
        node = self.tree.nodes[following]
        return node.tag in {"IN", "CC"} or not node.text[0].isalnum()
