"""Whether numbers and ordinals of a reading count something else: "two christmas cards"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.surroundings.surroundings import THING
from fuzzytime.language.meaning.calendar import Fields, is_day_of_month
from fuzzytime.language.meaning.expressions import Wall

SHORT_YEAR = 2
"""Digits of a year without its century."""


class Counts(Standing):
    """What is counted beside days and clock times."""

    def hold(self, piece: Piece, wall: Wall) -> bool:
        """Whether one of its numbers counts something else."""
        several = self._counts_several(piece, wall) or self._counts_feast(piece, wall)
        return several or self._is_of_parts(piece, wall) or self._goes_on(piece, wall)

    def _goes_on(self, piece: Piece, wall: Wall) -> bool:
        """Whether what is behind it, or in it, makes it what a thing is for, or one of several things."""
        joints = self.closed.coordinators_of_days | self.closed.range_joints
        return self.around.follower(piece) in joints and self._counts_things(piece, wall)

    def _counts_things(self, piece: Piece, wall: Wall) -> bool:
        """Whether ordinals count things and no days: "on the first and second floor", "on the 2nd to 3rd"."""
        numbered = is_day_of_month(wall.days) and wall.clock is None
        last = piece.end - 1
        if not numbered or not (self.is_ordinal(last) or self.is_ordinal(last - 1)):
            return False
        behind = piece.end + 1 + (self.texts[piece.end + 1 : piece.end + 2] == ["the"])
        if not self.is_ordinal(behind):
            return False
        typed = self.words[behind].is_digits
        return not self.around.may_end(piece._replace(end=behind + 1 + typed))

    def _counts_feast(self, piece: Piece, wall: Wall) -> bool:
        """Whether its first number counts what a feast has: "two christmas cards"."""
        if wall.clock is None or wall.days is None or not self.measures.is_number(piece.start):
            return False
        feast = any(one.category == "feast" for one in self.around.pieces(piece.start + 1))
        follower = self.around.follower(piece)
        return feast and follower.isalpha() and follower not in self.lexicon.function_words

    def _counts_several(self, piece: Piece, wall: Wall) -> bool:
        """Whether its last number counts what is behind it: "paint it tomorrow, two coats"."""
        year = isinstance(wall.days, Fields) and wall.days.year is not None and wall.clock is None
        # "Book 6 march 30 seats"
        last = wall.clock is not None or (year and len(self.texts[piece.end - 1]) <= SHORT_YEAR)
        if wall.days is None or not last or not self.measures.is_number(piece.end - 1):
            return False
        follower, led = self.around.follower(piece), self.texts[piece.end - 2]
        several = self.around.are_several(follower) and follower not in self.lexicon.function_words
        return several and follower.isalpha() and led not in self.closed.prepositions_of_points

    def _is_of_parts(self, piece: Piece, wall: Wall) -> bool:
        """Whether an ordinal counts parts of the day, and is no date: "cancel the second night"."""
        dated = is_day_of_month(wall.days)
        counted = self.texts[piece.end - 2] in self.lexicon.ordinals and self.texts[piece.end - 1] != THING
        return dated and wall.part is not None and counted

    def is_ordinal(self, place: int) -> bool:
        """Whether an ordinal is at a place: a word, or a number and its ending."""
        if not 0 <= place < len(self.texts):
            return False
        behind = {*self.texts[place + 1 : place + 2]}
        typed = self.words[place].is_digits and not behind.isdisjoint(self.beside.ordinal_endings)
        return typed or self.texts[place] in self.lexicon.ordinals
