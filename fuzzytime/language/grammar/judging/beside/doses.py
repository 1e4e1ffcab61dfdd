"""Numbers that say how many are taken, and are no hours: "take one in the morning and one at night"."""

from collections.abc import Iterator
from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.joined.distances import BEYOND, UPPER

BETWEEN = 3
"""Words from a verb to the number that it governs, at most: "give the cat two"."""

IN_EACH = frozenset({"in", "within", "per", "a", "an", "any", "each", "every"})
"""What stands before the time in which there are so many at most."""


class Doses(Around):
    """The numbers of a text that count what is given, taken or used."""

    def cap(self, piece: Piece) -> bool:
        """Whether a reading has a part of how many there are at most: "no more than eight | in 24 hours".

        What is all of that, or begins with it, is how often something is done at most.
        """
        inside = (first for first, end in self._caps if first < piece.end and piece.start < end)
        return any(piece.start != first for first in inside)

    @cached_property
    def _caps(self) -> tuple[tuple[int, int], ...]:
        """Where "no more than eight tablets in 24 hours" begins and ends, in which "more than" does, too."""
        return tuple(
            (min(first for first, last in self._most() if last == end), end) for _, end in self._most()
        )

    def _most(self) -> Iterator[tuple[int, int]]:
        hedges = (one for place in range(len(self.texts)) for one in self.around.pieces(place))
        for hedge in (one for one in hedges if one.category == "hedge" and one.value in UPPER | {BEYOND}):
            each = hedge.end + 1
            things = self.texts[each : each + 1]
            # "At most three times a day" is how often.
            each += things != ["times"] and IN_EACH.isdisjoint(things)
            unit = each + 1 + self._is_number(each + 1)
            counts = self._is_number(hedge.end) and not IN_EACH.isdisjoint(self.texts[each : each + 1])
            if counts and unit < len(self.texts) and self.around.is_unit(unit):
                yield hedge.start, unit + 1

    def count(self, place: int) -> bool:
        """Whether the number at a place counts what is taken at the time behind it."""
        if not self._is_number(place) or not self._is_before_time(place + 1):
            return False
        return self._governed(place) or (self._is_further(place) and self._any_before(place))

    def _is_number(self, place: int) -> bool:
        known = self.lexicon.numbers
        return place < len(self.texts) and (self.texts[place] in known or self.texts[place].isdecimal())

    def _is_before_time(self, place: int) -> bool:
        """Whether a preposition and a part of the day, or "now", stand at a place: "one at lunch"."""
        if place + 1 >= len(self.texts):
            return False
        led = self.texts[place] in self.closed.prepositions_of_times_taken
        article = self.texts[place + 1] in self.closed.articles
        return led and self.around.is_part_or_meal(place + 1 + article)

    def _governed(self, place: int) -> bool:
        """Whether a verb of taking stands right before, or its recipient between: "give him two"."""
        near = range(max(0, place - BETWEEN), place)
        verbs = [p for p in near if self.texts[p] in self.lexicon.dosing]
        return bool(verbs) and not any(self.around.timely(p) for p in range(verbs[-1] + 1, place))

    def _is_further(self, place: int) -> bool:
        return place > 0 and self.texts[place - 1] in self.closed.additions

    def _any_before(self, place: int) -> bool:
        """Whether how many are taken is said before: "two pills in the morning, and one …"."""
        return any(self._is_number(p) and self._governed(p) for p in range(place))
