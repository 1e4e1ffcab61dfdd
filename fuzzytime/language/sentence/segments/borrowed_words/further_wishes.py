"""A further wish behind a joint and a time, and the words of the first that may hold in it too."""

from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.tags import NAMING, SUBJECTS
from fuzzytime.language.sentence.trees.tree import Tree
from fuzzytime.language.sentence.verbs.meant.actions import action_of

Stretch = tuple[int, range]
"""A place in a tree, and the places of the words that are heard again before it."""


@dataclass(frozen=True, slots=True)
class Wish:
    """A further wish in a tree: where it begins, and where its time does; it may stand ``apart``."""

    tree: Tree
    start: int
    end: int
    timed: AbstractSet[int]
    lexicon: Lexicon
    apart: bool = False

    def names(self, first: int, end: int) -> bool:
        """Whether words are there, and all name something."""
        return first < end and all(self._names(p) for p in range(first, end))

    def _names(self, place: int) -> bool:
        """Whether a word names something; a plural with an owner may be taken for a verb: "her drops"."""
        node, before = self.tree.nodes[place], self.tree.nodes[place - 1 : place]
        owned = node.tag == "VBZ" and any(other.tag == "PRP$" for other in before)
        return node.tag in NAMING or owned

    def text(self, first: int, end: int) -> str:
        """Give the words from one place on that are no time."""
        return " ".join(self.tree.nodes[p].text for p in range(first, end) if p not in self.timed)

    def is_name(self, place: int) -> int:
        """Give how many words name somebody at a place, a person or a worker with a number; 0 for none."""
        node, behind = self.tree.nodes[place], self.tree.nodes[place + 1 : place + 2]
        if node.lower in self.lexicon.workers and behind and behind[0].tag == "CD":
            return 2
        return int(
            (node.text[0].isupper() and node.text.isalpha() and not node.text.isupper())
            or node.lower in self.lexicon.persons
        )

    def is_called(self, place: int) -> int:
        """Give how many words name somebody at a place where a name stands, also one like a word: "bob"."""
        return self.is_name(place) or int(self.tree.nodes[place].lower in self.lexicon.names_like_words)

    def calls(self, first: int, end: int) -> bool:
        """Whether words before what somebody is asked name them: one word that is no pronoun, or a name."""
        return self.names(first, end) or (end == first + 1 and self.tree.nodes[first].tag != "PRP")


def front_of(wish: Wish, end: int) -> range:
    """Give the words in front of a place, behind a time in front of them all."""
    behind = (p + 1 for p in range(end - 1, -1, -1) if p in wish.timed or wish.tree.nodes[p].text == ",")
    return range(next(behind, 0), end)


def end_of(wish: Wish, verb: int) -> int:
    """Give where a verb with its particle ends."""
    particle = verb + 1
    return particle + (wish.tree.nodes[particle].tag == "RP")


def ordered(wish: Wish) -> range | None:
    """Give the verb of an order that has an object, with its particle; None without one."""
    tree, action = wish.tree, action_of(wish.tree)
    if (
        action is None
        or action.negated
        or action.place >= wish.start
        or tree.children(action.place, *SUBJECTS)
    ):
        return None
    verb = action.place
    bare = tree.nodes[verb].lower == tree.nodes[verb].lemma and tree.nodes[verb].may_act
    return range(verb, end_of(wish, verb)) if bare and tree.children(verb, "dobj", "xcomp") else None
