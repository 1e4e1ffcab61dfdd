"""Numbers that say how many are taken, and are no hours: "take one in the morning and one at night"."""

from fuzzytime.language.grammar.surroundings.surroundings import Around

BETWEEN = 3
"""Words from a verb to the number that it governs, at most: "give the cat two"."""


class Doses(Around):
    """The numbers of a text that count what is given, taken or used."""

    def count(self, place: int) -> bool:
        """Whether the number at a place counts what is taken at the time behind it."""
        if not self._is_number(place) or not self._is_before_time(place + 1):
            return False
        return self._governed(place) or (self._is_further(place) and self._any_before(place))

    def _is_number(self, place: int) -> bool:
        return place < len(self.texts) and self.texts[place] in self.lexicon.numbers

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
