"""Where a clause ends: at a mark, or before another time or clause."""

from collections.abc import Sequence

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.segments.waiting import goes_on_behind

ENDS = frozenset({",", "(", ")"})
"""Marks at which a clause ends: "until golden (about ten minutes)"."""


class ClauseEnds:
    """The ends of clauses among the words of an instruction, of which some are covered by times."""

    def __init__(
        self, words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon, covered: set[int]
    ) -> None:
        self.words, self.phrases, self.lexicon, self.covered = words, phrases, lexicon, covered

    def of(self, first: int) -> int:
        """Give where a clause ends that begins at a word: at a mark, or at "and" and a time."""
        return next((p for p in range(first, len(self.words)) if self._is_mark(p)), len(self.words))

    def _is_mark(self, place: int) -> bool:
        """Whether a clause ends before a word: a mark, or "and", "or" before a time or another clause."""
        text = self.words[place].text
        if text == "," and (self._is_inside(place) or self._goes_on(place)):
            return False
        if text not in {"and", "but", "or"} or place + 1 >= len(self.words) or place - 1 in self.covered:
            return text in ENDS
        # "Before you leave and again when you get back"
        behind = place + 1 + (self.words[place + 1].text == "again" and place + 2 < len(self.words))
        clause = longest_match(self.words, behind, self.lexicon.clauses)
        bound = any(phrase.first == place + 1 and phrase.said.preposition for phrase in self.phrases)
        return bound or bool(clause and self.lexicon.clauses[clause])

    def _goes_on(self, place: int) -> bool:
        """Whether a clause in front goes on behind a comma: "when it is hot, and the oil shimmers, …"."""
        last = len(self.words) - 1
        return self.words[last].text == "," and goes_on_behind(self.words, place, last, self.lexicon)

    def _is_inside(self, place: int) -> bool:
        """Whether a mark joins digits, as in "below 1,200", or words of one time."""
        if place in self.covered:
            return True
        around = self.words[place - 1 : place + 2]
        return len(around) == 3 and all(word.glued for word in around[1:]) and around[2].is_digits
