"""Words of a tree as they are said, without those about time."""

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import is_quoted
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.trees.tree import Tree

SENTENCE_MARKS = frozenset({"!", "?"})
"""Marks that may stand before what closes: "bread (the brown one!)"."""

CLOSING = {">": "<", ")": "(", "]": "["}
"""Marks, and those that they close."""


@dataclass(frozen=True, slots=True)
class Wording:
    """The words of a tree; ``times`` are the stretches of characters that are about time."""

    tree: Tree
    times: Sequence[Span]

    @property
    def lexicon(self) -> Lexicon:
        """The words of its language."""
        return self.tree.lexicon

    def timed(self, place: int) -> bool:
        """Whether a word is about time."""
        node = self.tree.nodes[place]
        return any(first <= node.start < end for first, end in self.times)

    def level(self, verb: int) -> list[int]:
        """Give "on low", which trees take for a particle and an object: "cook on low"."""
        for place in self.tree.children(verb, "prt"):
            behind = place + 1
            if self.tree.nodes[place].lower == "on" and behind < len(self.tree.nodes):
                return [place, behind] if self.tree.nodes[behind].lower in self.lexicon.levels else []
        return []

    def has_to(self, place: int) -> bool:
        """Whether a word is a verb with "to", which has particles of its own."""
        marks = (self.tree.nodes[p].lower for p in self.tree.children(place, "aux"))
        return self.tree.nodes[place].tag == "VB" and "to" in marks

    def words(self, parts: Sequence[int], verb: int) -> list[int]:
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
                if self._is_contrasted(place, verb):
                    # "Serve the soup, not the salad"
                    continue
                found.append(place)
        return sorted(set(found))

    def with_numbers(self, words: Sequence[int]) -> list[int]:
        """Give words with the numbers that things are called by: "valve 1", "rooms 3, 4 and 5"."""
        closed = self.lexicon.closed
        found = set(words)
        found.update(p + 1 for p in words if self._is_called_by(p + 1))
        for place in sorted(found):
            joints = closed.coordinators
            if place and self.tree.nodes[place - 1].tag == "NNS":
                joints = closed.coordinators | closed.range_joints
            end: int | None = place
            while end is not None and self._counts(end):
                found.update(range(place, end + 1))
                end = self._next_number(end, joints)
        return sorted(found)

    def numbers_from(self, place: int) -> list[int]:
        """Give the numbers in a row from a place on: "dial 555 1234"."""
        end = place
        while self._is_called_by(end):
            end += 1
        return list(range(place, end))

    def _is_called_by(self, place: int) -> bool:
        """Whether a number counts nothing: "flight 815"; but "the dog 3 times", "run 2-3 miles"."""
        if not self._counts(place):
            return False
        machine = place > 0 and self.tree.nodes[place - 1].lower in self.lexicon.machines
        counted = max(self.tree.nodes[place].head, place + 1)
        return machine or self._counts(place + 1) or not self._is_noun(counted)

    def _is_noun(self, place: int) -> bool:
        return place < len(self.tree.nodes) and self.tree.nodes[place].tag.startswith("NN")

    def _counts(self, place: int) -> bool:
        inside = place < len(self.tree.nodes)
        return inside and self.tree.nodes[place].tag == "CD" and not self.timed(place)

    def _next_number(self, place: int, joints: frozenset[str]) -> int | None:
        """Give the number behind another and a joint, if it counts nothing itself."""
        nodes, behind = self.tree.nodes, place + 1
        while behind < len(nodes) and nodes[behind].lower in joints:
            behind += 1
        if not place + 1 < behind < len(nodes) or not self._counts(behind):
            return None
        return None if self._is_noun(behind + 1) else behind

    def _is_contrasted(self, place: int, verb: int) -> bool:
        """Whether a word is of something that is not meant: "the soup, not the salad"."""
        if self.tree.nodes[place].text == ",":
            # The comma on either side of it
            return self._contrasts(place + 1) or self._is_contrasted(place - 1, verb)
        while place > verb and self.tree.nodes[place].text != ",":
            if self._contrasts(place):
                return True
            place -= 1
        return False

    def _contrasts(self, place: int) -> bool:
        """Whether a "not" denies something else that is named behind it, and no verb or adjective."""
        nodes = self.tree.nodes
        if nodes[place].lower != "not" or not 0 < place < len(nodes) - 1:
            return False
        behind = nodes[place + 1]
        led = nodes[place - 1].text == "," and behind.tag.startswith(("NN", "PRP", "CD", "JJ", "IN", "DT"))
        return led or (behind.tag in {"DT", "PRP$"} and nodes[place - 1].tag.startswith("NN"))

    def _describes(self, place: int) -> bool:
        """Whether a word about time belongs to a noun behind it: "a ten minute walk"."""
        head = next((p for p in self.tree.above(place) if not self.timed(p)), place)
        return head > place and self.tree.nodes[head].lower in self.lexicon.lasting

    def _ends_named(self, place: int, end: int) -> bool:
        """Whether one end of a word is no mark, or it is quoted."""
        text = self.tree.nodes[place].text
        return _names(text[end]) or is_quoted(text)

    def _closing(self, kept: Sequence[int]) -> list[int]:
        """Give the marks behind some words that close what is opened among them: "flowers & <wine>"."""
        marks = list(range(kept[-1] + 1, min(kept[-1] + 3, len(self.tree.nodes))))
        if len(marks) > 1 and self.tree.nodes[marks[0]].text not in SENTENCE_MARKS:
            marks.pop()
        opened = CLOSING.get(self.tree.nodes[marks[-1]].text) if marks else None
        closes = opened is not None and any(self.tree.nodes[place].text == opened for place in kept[1:])
        return marks if closes else []

    def said(self, words: Sequence[int]) -> str | None:
        """Give words as typed, single spaces between those that stood apart, without marks at the ends."""
        kept = list(words)
        while kept and not self._ends_named(kept[-1], -1):
            kept.pop()
        while kept and not self._ends_named(kept[0], 0):
            kept.pop(0)
        kept += self._closing(kept) if kept else []
        text = ""
        last = None
        for place in kept:
            node = self.tree.nodes[place]
            # "Lunch with Ola at noon, the usual place": a time stood before the comma.
            apart = last is not None and last != node.start and node.text != ","
            text += " " * apart + node.text
            last = node.end
        return text.strip() or None


def _names(character: str) -> bool:
    """Whether a character is no mark: a picture says as much as a word, "€" what is paid."""
    return character.isalnum() or unicodedata.category(character) in {"So", "Sk", "Sc", "Mn", "Me", "Cf"}
