"""Whether a repetition is one where it stands: not "buy the daily", "every 10th customer"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing


class Repeats(Standing):
    """What stands around repetitions, and whether it makes one doubtful."""

    def accept(self, piece: Piece) -> bool:
        """Whether what is repeated is a time here."""
        if (
            self.around.follower(piece) in self.beside.before_or_after
            and self.texts[piece.end - 2] in self.closed.singular_determiners
        ):
            # "Gate 22 an hour before take-off"
            return False
        if "to" in {piece.value.preposition, self.around.before(piece)} or self._counts_things(piece):
            # "Hand over to nights"
            return False
        named = self.around.before(piece) in self.closed.sure_noun_openers and piece.value.preposition is None
        if named and self.around.may_end(piece):
            # "Buy the daily"; but "a twice daily walk"
            return False
        if self.texts[piece.end - 1] == "annual" and not self.around.may_end(piece):
            # "Book annual leave"
            return False
        if piece.rule == "repeated_days.parts_alone":
            # "The morning and evening", "dawn, noon and dusk", "morning and evening classes"
            led = self.around.before(piece) in self.closed.noun_openers | self.beside.binding_ranges | {
                "this",
                "in",
                ",",
            }
            if led or (piece.start and self.around.timely(piece.start - 1)) or not self.around.may_end(piece):
                return False
        # "Most evenings": which, is not said.
        some = self.around.before(piece) in self.beside.which_is_not_said
        parted = any(wall.part is not None for wall in piece.value.time.walls)
        # "To twenty | at seven each weekday"
        bound = self.texts[piece.start] in self.closed.prepositions_of_points
        return not some and (parted or bound or not self.measures.is_rate(piece))

    def _counts_things(self, piece: Piece) -> bool:
        """Whether its last word counts things: "every 10th customer", "twice a week for two children"."""
        if self.texts[piece.end - 2 : piece.end - 1] == ["for"] and self.measures.is_number(piece.end - 1):
            return not self.around.may_end(piece)
        each, last = self.texts[piece.start], self.texts[piece.end - 1]
        spelt = last in self.lexicon.ordinals and piece.end - piece.start == len((each, last))
        typed = last in self.beside.ordinal_endings and not self.around.may_end(piece)
        return each in self.closed.distributives and bool(piece.value.time.walls) and (spelt or typed)

    def is_number_for(self, piece: Piece) -> bool:
        """Whether a number alone stands before a repetition: "cook for six on sundays" names people."""
        place = piece.start + 1
        behind = self.beside.of_clocks & {*self.texts[place + 1 : place + 2]}
        joined = self.measures.is_number(place + 1) or bool(behind) or self.around.is_unit(place + 1)
        return self.measures.is_number(place) and not joined and not self.measures.is_sure(place)
