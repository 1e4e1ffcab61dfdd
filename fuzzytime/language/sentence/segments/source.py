"""A text before it is cut: its times, its words of order, and what else is known of its words."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime

from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.instruction import Order, Remark, Span, blanked
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.phrases import places_in

DENIAL = 3
"""Words that forbid an order: "on no account"."""


@dataclass(frozen=True, slots=True)
class Source:
    """A text, scanned for times, words of order among others, and where orders begin beside what is told.

    Of its ``phrases``, a list of times is one, and its ``further`` times are not heard: "let the dog out at
    eleven, three and again at seven". Its ``openings`` ask for something and say nothing of it: "at noon,
    why don't you …". What begins ``meanwhile`` is so while what is before it goes on.
    """

    now: datetime | None
    scanned: Scanned
    phrases: tuple[Phrase, ...]
    remarks: tuple[Remark, ...]
    orders: tuple[tuple[Span, Order], ...] = ()
    apart: tuple[int, ...] = ()
    meanwhile: tuple[int, ...] = ()
    openings: tuple[Span, ...] = ()
    further: tuple[Span, ...] = ()

    @property
    def sound(self) -> str:
        """The text with spaces for words taken back ("at five, I mean six"), words of order and openings."""
        taken_back = (remark.span for remark in self.remarks)
        words = [(self._behind_preposition(start, end), end) for start, end in taken_back]
        text = blanked(
            self.scanned.text, [*(span for span, _ in self.orders), *self.openings, *self.further, *words]
        )
        for heard, spans in (("if", self._conditions()), ("don't", self._denials())):
            for start, end in spans:
                text = text[:start] + heard.ljust(end - start) + text[end:]
        return text

    def _denials(self) -> Iterator[Span]:
        """Give what forbids an order in words of its own: "under no circumstances call her"."""
        words, lexicon = self.scanned.words, self.scanned.lexicon
        for place in range(len(words) - DENIAL):
            end = place + DENIAL
            said = " ".join(word.text for word in words[place:end])
            # "There's no need to" says it with a verb of its own, "no need to hurry" when.
            before = words[place - 1].text if place else ","
            opens = not before.isalpha() or before in lexicon.closed.joints_of_orders
            opens = opens or (before,) in lexicon.conversation["answering"]
            if said not in lexicon.closed.denials or not opens or place in self.covered:
                continue
            if (words[end].text,) in lexicon.questions["helping"]:
                # "On no account should you call her"
                end += 2
                if lexicon.closed.personal_pronouns.isdisjoint(word.text for word in words[end - 1 : end]):
                    continue
            yield words[place].start, words[end - 1].end

    def _conditions(self) -> Iterator[Span]:
        """Give each "should" that begins a condition behind an order: "call me should it rain"."""
        words, lexicon = self.scanned.words, self.scanned.lexicon
        for before, word, behind in zip(words, words[1:], words[2:], strict=False):
            if word.text != "should" or behind.text not in lexicon.closed.condition_openers:
                continue
            asking = lexicon.questions["asking"], lexicon.questions["placing"]
            asks = any((one.text,) in kind for one in (words[0], before) for kind in asking)
            asks = asks or any(first <= word.start < end for first, end in self.openings)
            if not asks and before.text not in lexicon.closed.relatives | lexicon.closed.personal_pronouns:
                yield word.start, word.end

    def _behind_preposition(self, start: int, end: int) -> int:
        """Give where words begin that are taken back: the "at" in front of them stays."""
        words = {word.start: word for word in self.scanned.words}
        kept = start in words and end in words and words[start].text == "at" != words[end].text
        return words[start].end if kept else start

    @property
    def covered(self) -> frozenset[int]:
        """The places of the words that are about time."""
        return places_in(self.phrases)

    def places(self, first: int, end: int) -> list[int]:
        """Give the places of the words in a stretch of characters."""
        return [place for place, word in enumerate(self.scanned.words) if first <= word.start < end]
