"""Where and how something is done, by the words below a verb: "in the pan", "back to the dock", "twice"."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.english import WHITHER
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.wording import Wording
from fuzzytime.language.sentence.verbs.meant.complements import is_numbered_place

HOW = ("RB", "JJ", "IN")
"""How tags of words begin that say how: "quite slowly", "at least twice"."""

PLACES = ("prep", "advmod", "npadvmod")
AGENT = "agent"
"""What a tree takes "by" for behind any verb; with an order it is a place: "sit by the fire"."""

TIMES = ("part", "unit", "weekday", "month", "day")
"""Categories of words that say no place: "on a clear night"."""


def says_where(word: str, lexicon: Lexicon) -> bool:
    """Say whether a word alone may say where: "upstairs", "backwards"."""
    return word in lexicon.places or word.endswith(WHITHER)


@dataclass(frozen=True, slots=True)
class Places(Wording):
    """Reads places off a tree."""

    def place(self, verb: int, taken: Iterable[int]) -> list[int]:
        """Give the words that say where."""
        # "Turn it down to 30 degrees": a tree may hang it on the particle.
        particles = self.tree.children(verb, "prt")
        led = (p for particle in particles for p in self.tree.children(particle, "prep"))
        beside = () if self.tree.nodes[verb].tag == "VBN" else self.tree.children(verb, AGENT)
        # "Buy bread for me"
        given = (p for p in self.tree.children(verb, "dative") if self.names_company(p))
        below = [
            p
            for p in (*self.tree.children(verb, *PLACES), *beside, *led, *given)
            if p > verb and not self.timed(p)
        ]
        kept = [p for p in below if self._is_place(p) or self.names_company(p)] + list(
            self._behind_times(verb)
        )
        kept += [p for p in self.tree.children(verb, "advcl", "xcomp") if is_numbered_place(self.tree, p)]
        kept += self.level(verb)
        # "Turn left": a participle too.
        kept += [
            p
            for p in self.tree.children(verb, "acl", "ccomp")
            if self.tree.nodes[p].lower in self.lexicon.closed.sides
        ]
        manners = [p for p in self.tree.children(verb, "advcl", "conj", "xcomp") if self._is_manner(p)]
        kept += [p for p in manners if p > verb]
        words = [p for p in self.words(kept, verb) if p not in set(taken)]
        how = [word for p in manners if p < verb for word in sorted(self.tree.below(p))]
        words = self.with_numbers([p for p in words if self.has_content(p, words)])
        return [*self._in_front(verb), *words, *(p for p in how if self.tree.nodes[p].relation != "punct")]

    def _in_front(self, verb: int) -> list[int]:
        """Give the words in front of all others that say where: "in a bowl, whisk the eggs"."""
        for place in self.tree.children(verb, "prep"):
            words = sorted(self.tree.below(place))
            things = self.tree.children(place, "pobj")
            # "On the way back drop the cheque"
            where = any(self.tree.nodes[thing].lower != "way" for thing in things)
            where = where and self.tree.nodes[place].lower in self.lexicon.places
            timely = any(self.lexicon.means(self.tree.nodes[p].lower, *TIMES) or self.timed(p) for p in words)
            led = place == words[0] and all(self.timed(p) for p in range(place))
            if led and where and words[-1] < verb and not timely:
                return [word for word in words if self.tree.nodes[word].relation != "punct"]
        return []

    def manner(self, verb: int, taken: Iterable[int]) -> list[int]:
        """Give the words that say how something is done, or how often: "read it aloud", "stir it twice"."""
        kept = {*taken, *self.level(verb)}
        # "Slice it thinly at noon": a tree may hang it on the time.
        times = [p for p in self.tree.children(verb) if self.timed(p)]
        beside = [p for time in times for p in self.tree.children(time, "advmod") if p < time]
        found: list[int] = []
        for place in sorted((*self.tree.children(verb, "advmod"), *beside)):
            said = [p for p in sorted(self.tree.below(place)) if p not in kept]
            if all(self.tree.nodes[p].tag.startswith(HOW) and not self.timed(p) for p in said):
                known = self.lexicon.vague_adverbs | self.lexicon.particles.keys()
                found += [p for p in said if self.tree.nodes[p].lower not in known]
        return found

    def _is_manner(self, place: int) -> bool:
        """Whether a participle says how something is done: "using a fork", "topped with parsley"."""
        node = self.tree.nodes[place]
        alone = not self.tree.children(place, "nsubj", "nsubjpass", "mark", "aux", "auxpass")
        apart = place == 0 or self.tree.nodes[place - 1].text == ","
        return node.tag in {"VBG", "VBN"} and apart and alone and not self.timed(place)

    def _is_place(self, place: int) -> bool:
        node = self.tree.nodes[place]
        numbers = (
            child for child in (place, *self.tree.children(place)) if self.tree.nodes[child].tag == "CD"
        )
        each = any(
            self.tree.nodes[p].lower in self.lexicon.closed.distributives
            for p in self.tree.children(place, "det")
        )
        counted = node.relation == "npadvmod" and (each or any(numbers))
        if node.relation == "advmod" and node.lower in self.lexicon.particles:
            # "Go back to the dock"
            return bool(self.tree.children(place, "prep"))
        known = node.lower in self.lexicon.places | self.lexicon.becoming
        # "Text Sam about tomorrow"
        led = (self.tree.nodes[p].lower for p in self.tree.children(place, "advmod"))
        about = not self.lexicon.closed.prepositions_of_nouns.isdisjoint(led)
        return node.relation in {"prep", AGENT} or counted or known or about

    def _behind_times(self, verb: int) -> Iterator[int]:
        """Give the prepositions that a tree hangs on a time: "flip it in two minutes in the pan"."""
        for place in self.tree.below(verb):
            node = self.tree.nodes[place]
            said = (
                node.relation == "prep"
                and node.lower in self.lexicon.places | self.lexicon.closed.prepositions_behind_times
            )
            if said and not self.timed(place) and self.timed(node.head):
                yield place

    def has_content(self, place: int, words: Sequence[int]) -> bool:
        """Whether a preposition still has what it governs: that may have been a time."""
        if self.tree.nodes[place].relation not in {"prep", AGENT}:
            return True
        return any(below in words for below in self.tree.below(place) if below != place)

    def place_within(self, words: Sequence[int]) -> int:
        """Give where, in an object, the words begin that say where it is: "the pancakes in the pan".

        So do those that say for whom something is done, and with whom: "hoover the stairs for Ann".
        """
        inside = set(words)
        for position, place in enumerate(words[1:], start=1):
            node = self.tree.nodes[place]
            head = self.tree.nodes[node.head]
            of_noun = node.relation == "prep" and node.head in inside and head.relation in {"dobj", "pobj"}
            said = node.lower in self.lexicon.places or self.names_company(place)
            where = said and of_noun and self.has_content(place, words)
            if where and set(words[position:]) <= set(self._preposed(words[position:])):
                return position
        return len(words)

    def names_company(self, place: int) -> bool:
        """Whether a preposition says for whom something is done, or with whom."""
        node, closed = self.tree.nodes[place], self.lexicon.closed
        if node.lower not in closed.prepositions_of_company:
            return False
        persons = (self.lexicon.persons | closed.object_pronouns) - closed.it_or_them
        said = (self.tree.nodes[p] for p in self.tree.children(place, "pobj"))
        known = any(one.lower in persons or one.tag == "NNP" for one in said)
        # "A chat with Ann"
        events = self.lexicon.happening | self.lexicon.taken | self.lexicon.events
        return known and self.tree.nodes[node.head].lower not in events

    def _preposed(self, words: Sequence[int]) -> Iterator[int]:
        """Give the words that are below a preposition among them."""
        for place in words:
            if self.tree.nodes[place].relation == "prep":
                yield from self.tree.below(place)
