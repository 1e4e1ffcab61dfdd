"""Whether words that alone are no sure time are one where they stand: "in May", "before lunch"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.judging.walls.bare_hours import YEARS
from fuzzytime.language.grammar.judging.walls.dated_entries import dates_entry
from fuzzytime.language.grammar.timetables import has_time
from fuzzytime.language.meaning.calendar import is_day_of_month
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.requirement import Constraint

UNBINDING = frozenset({None, "to", "at", "for", "of", "on", "in", "from", "starting"})
"""Prepositions behind which a meal is a thing, or a place: "sugar in tea", "home from work"."""


class WeakWalls(Standing):
    """What stands around months, meals and numbers of days, and whether it makes one a time."""

    def accept(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether words that alone are no sure time are one here: "in May", "before lunch"."""
        unbinding = UNBINDING if wall.part is not None else {None, "to", "at"}
        # "Ask about lunch": what a meal is asked about.
        bound = said.preposition not in unbinding or bool(set(said.hedges) - {"about"})
        bound = bound or self._begins_at_meal(piece, said, wall)
        numbered = is_day_of_month(wall.days)
        if said.preposition == "in" and numbered and wall.clock is None:
            # "The blue car is in first"
            return False
        if said.preposition == "of" and numbered:
            # "The corner of 5th and Main", "remind me of the 2 for 1 offer"
            return self.texts[piece.start + 1] in self.closed.the and not self.words[piece.end - 1].is_digits
        if said.preposition == "to" and self.given.gets_month(piece, wall):
            # "Move the wedding to June"
            return self.around.may_end(piece)
        if self._is_left_out(piece):
            # "Every monday except the 16th", "every hour from nine to five but lunch"
            return self.around.may_end(piece)
        if numbered and said.preposition is None and self.around.follower(piece) == "as":
            # "Mark the 28th as a holiday"; but "mark the third as done"
            named = not self.closed.noun_openers.isdisjoint(self.texts[piece.end + 1 : piece.end + 2])
            return named and self.around.before(piece) in self.lexicon.appointing
        # "After the 10 o'clock feed"
        clocked = self.around.follower(piece) in self.beside.of_hours
        dated = dates_entry(self.words, piece.start, piece.end, self.lexicon)
        # "In the summer of 2031 fly to Rome": nothing is counted by a year.
        ends = self.around.may_end(piece) or (piece.start == 0 and self.texts[piece.end - 1] in YEARS)
        dated = dated or self._dates_meeting(piece) or (numbered and self._ends_order(piece))
        return dated or (bound and not clocked and ends)

    def _dates_meeting(self, piece: Piece) -> bool:
        """Whether a typed date ends what is said of a meeting: "dentist 9/15", "call mum 15.9."."""
        first, *rest = self.words[piece.start : piece.end]
        mark, last = ("".join(word.text for word in rest[:1]), "".join(word.text for word in rest[1:2]))
        # "Call mum 7.30."
        typed = mark == "/" or (mark == "." and len(last) == 1)
        ends = self.around.follower(piece) in self.beside.polite_ends | {"", ".", ",", ";", ")"}
        # "Rate lunch 9/10"
        rated = not self.lexicon.rating.isdisjoint(self.texts[: piece.start])
        met = ends and not rated and self.is_met(piece.start)
        return first.is_digits and last.isdecimal() and typed and (met or self.reminds(piece))

    def _ends_order(self, piece: Piece) -> bool:
        """Whether a typed day of a month ends what is asked for: "call mum the 9th", not "take the 2nd".

        Or begins it: "the 9th, call mum".
        """
        before, place = self.around.before(piece), piece.start - 1
        typed = (
            self.texts[piece.start] in self.closed.the
            and self.texts[piece.end - 1] in self.beside.ordinal_endings
        )
        comma = self.around.follower(piece) == ","
        order, thing, *_ = (*self.texts[piece.end + comma :], "", "")
        if typed and piece.start == 0 and order in self.lexicon.orders:
            return comma or thing in self.closed.noun_openers
        if not typed or not before.isalpha():
            return False
        ends = self.around.follower(piece) in self.beside.polite_ends | {""}
        if self.around.opens(place):
            # "Dentist the 9th"; but "call the 9th", "Henry the 8th"
            met = has_time(before, self.lexicon) and before not in self.lexicon.names
            return ends and met and before not in self.lexicon.orders
        if before in self.closed.object_pronouns | self.lexicon.persons or self.words[place].capital:
            # "Call Bob the 9th", "remind me the 9th to call him", but "show Bob the 9th"
            called = self.texts[place - 1] in self.lexicon.addressing
            return called and (ends or self.around.follower(piece) in self.closed.to)
        return ends and before not in self.lexicon.function_words | self.lexicon.called_by_number

    def _begins_at_meal(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether more than "from" makes a meal a start: "starting from lunch", not "dishes from lunch"."""
        first, second = self.texts[piece.start], {*self.texts[piece.start + 1 : piece.end]}
        more = first != said.preposition or not second.isdisjoint(self.beside.binding_ranges)
        led = said.constraint is Constraint.AFTER and more
        return led and wall.part is not None and not wall.part.place

    def _is_left_out(self, piece: Piece) -> bool:
        """Whether it is left out of days: "every monday except the 16th"; but "every page but the first"."""
        place = piece.start - 1 - (self.around.before(piece) in self.closed.the)
        leaving = self.beside.leaving_out | self.beside.leaving_out_of_all
        if place < 0 or self.texts[place] not in leaving:
            return False
        return any(self.texts[p] in self.beside.repeating and self.around.timely(p + 1) for p in range(place))
