"""Meals that say when, behind "for": what is done at the table, as "meet Sam for lunch", is done then.

"Buy bread for dinner" says what the bread is for. Where another time is said it is what counts, and the meal
is what for: "stop for lunch at one".
"""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.expressions import Wall

BETWEEN = 6
"""Words from what is done at a meal to "for", at most: "meet Sam at the cafe for lunch"."""


class Dining(Around):
    """The meals of a text for which something is done."""

    def is_purpose(self, piece: Piece) -> bool:
        """Whether a piece says of a meal what something is for, and not when it is done."""
        led = next((place for place in range(piece.start, piece.end) if self._leads(place)), None)
        if led is None or self._ends_preposition(piece.start, led):
            return False
        time = piece.value.time
        timed = (
            not isinstance(time, Wall)
            or time.clock is not None
            or any(map(self._is_time, self._beside(piece)))
        )
        if self._is_said_of_day(piece):
            return False
        # "Come over for dinner"
        return timed or led == piece.start + 1 or not self._dines(led)

    def is_covered(self, piece: Piece) -> bool:
        """Whether something is put on a meal: "pour the water over the tea"."""
        over = self.texts[piece.start] == "over" and self.around.is_meal(piece.end - 1)
        # "Pour the wine and talk over dinner"
        said = {self.texts[place] for place in self._beside(piece) if place < piece.start}
        return over and not self.lexicon.doing.covering.isdisjoint(said)

    def is_subject(self, piece: Piece) -> bool:
        """Whether it ends in a meal of which a clause says how it is: "before lunch | is served"."""
        said = self.texts[piece.end : piece.end + 2]
        being = self.around.closed.third_person_be | self.around.closed.past_be
        led = (self.texts[piece.start],) in self.lexicon.clauses and self.around.is_meal(piece.end - 1)
        return led and len(said) > 1 and said[0] in being and not self.around.timely(piece.end + 1)

    def _is_said_of_day(self, piece: Piece) -> bool:
        """Whether it ends in a part of a day that the meal is in: "cook pasta for dinner tonight"."""
        said = self.around.pieces(piece.end - 1)
        return any(part.category == "day_part" and part.end == piece.end for part in said)

    def _leads(self, place: int) -> bool:
        return self.texts[place] == "for" and place + 1 < len(self.texts) and self.around.is_meal(place + 1)

    def _ends_preposition(self, start: int, led: int) -> bool:
        """Whether "for" is the end of a longer preposition: "in time for dinner"."""
        begun = (said for place in range(start, led) for said in self.around.pieces(place))
        return any(said.category.startswith("preposition") and said.end == led + 1 for said in begun)

    def _dines(self, place: int) -> bool:
        near = range(max(0, place - BETWEEN), place)
        verbs = [p for p in near if self.texts[p] in self.lexicon.dining]
        return bool(verbs) and all(self.texts[p][:1].isalnum() for p in range(verbs[-1], place))

    def _beside(self, piece: Piece) -> list[int]:
        """Give the places of the other words of its order."""
        ends = [
            place
            for place, text in enumerate(self.texts)
            if text in self.around.closed.end_of_an_order
            # "Between 12 and 1"
            and not (place + 1 < len(self.texts) and self._counts(place + 1))
        ]
        first = max((place for place in ends if place < piece.start), default=-1)
        last = min((place for place in ends if place >= piece.end), default=len(self.texts))
        return [*range(first + 1, piece.start), *range(piece.end, last)]

    def _is_time(self, place: int) -> bool:
        """Whether a word elsewhere is a number that counts nothing."""
        behind = self.texts[place + 1 : place + 2]
        counts = bool(behind) and behind[0].isalpha() and not self.around.timely(place + 1)
        return self._counts(place) and not counts

    def _counts(self, place: int) -> bool:
        return self.texts[place] in self.lexicon.numbers or self.texts[place][:1].isdigit()
