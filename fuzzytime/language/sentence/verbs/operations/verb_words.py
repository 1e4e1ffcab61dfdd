"""The words that a verb has beside its object: "deep clean", "get dressed", "get him up and washed"."""

from collections.abc import Sequence
from dataclasses import dataclass

from fuzzytime.language.sentence.trees.tags import SUBJECTS
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
        """Give what "and" joins to a particle as what somebody is then: "get him up and washed"."""
        node = self.tree.nodes[verb]
        if node.lemma not in self.lexicon.causing or not self.tree.children(verb, "dobj"):
            return []
        for place in self.tree.children(verb, "conj"):
            state = self.tree.nodes[place].tag in {"VBN", "VBD", "JJ"} and not self.timed(place)
            own = self.tree.children(place, *SUBJECTS, "dobj", "aux", "auxpass")
            if state and not own and place > 1 and self.tree.nodes[place - 1].tag == "CC":
                return [place - 1, place]
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
