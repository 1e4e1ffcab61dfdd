"""A text as those see it who decide whether something is a time where it stands."""

from collections.abc import Sequence

from fuzzytime.language.grammar.given_times import GivenTimes
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.measuring import Measures
from fuzzytime.language.grammar.run_on_hours import RunOnHours
from fuzzytime.language.grammar.surroundings import Surroundings
from fuzzytime.language.grammar.words import Word


class Standing:
    """Words, what measures stand among them, and what stands around any of them."""

    def __init__(
        self, words: Sequence[Word], lexicon: Lexicon, measures: Measures, around: Surroundings
    ) -> None:
        self.words = words
        self.lexicon, self.closed, self.beside = lexicon, lexicon.closed, lexicon.beside
        self.texts = [word.text for word in words]
        self.measures = measures
        self.around = around
        self.given = GivenTimes(lexicon, around)
        self.run_on = RunOnHours(lexicon, around)

    def is_ambiguous(self, place: int) -> bool:
        """Whether the word at a place is an English word with another meaning, too: "may", "sun"."""
        return self.texts[place] in self.lexicon.ambiguous
