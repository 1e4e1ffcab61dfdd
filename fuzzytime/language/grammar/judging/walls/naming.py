"""Whether days and clock times name something ("the Monday meeting"), or count it ("two christmas cards")."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.surroundings.surroundings import THING
from fuzzytime.language.meaning.calendar import Fields, is_day_of_month, is_weekday
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.language.meaning.feasts import Feast
from fuzzytime.requirement import Unit

NAMING = frozenset({"on", "to", "for", "of"})
"""Prepositions behind which an article and a time begin a noun: "the slides for the 3 pm meeting"."""

SHORT_YEAR = 2
"""Digits of a year without its century."""


class Naming(Standing):
    """The nouns around days and clock times, and whether they hold one."""

    def hold(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether it only names something, or belongs to what does."""
        before = self.around.before(piece)
        if said.preposition is None and wall.clock is not None and self.given.is_caught(piece):
            # What is caught is caught then: "catch the 7:42 to York".
            return False
        if said.preposition is None and (self.around.describes(piece) or self.around.names(piece, wall)):
            return True
        counting = self.words[piece.end - 1].is_digits and self.around.follower(piece).endswith("s")
        if said.preposition is None and counting and self.is_ambiguous(piece.start):
            # "March 3 steps forward"
            return not self.around.may_end(piece)
        if said.preposition is None and wall.clock is not None and self.around.is_owned(piece):
            # "Cancel my three o'clock", "move tomorrow's ten o'clock"; but "lunch at Nan's 1ish"
            return not self._is_at_home(piece)
        if (wall.clock is not None and self._is_called(piece, said, wall)) or self.around.is_of_several(
            piece.start
        ):
            return True
        if (said.preposition is None or wall.clock is not None) and self._is_next_in_row(piece, wall):
            return True
        limited = self.texts[0] in self.closed.limiting | self.closed.negators
        helping = limited and self.texts[piece.end - 1] in self.closed.inverted_auxiliaries
        if helping and self.around.follower(piece) in self.closed.personal_pronouns:
            # "Only after eight may you ring the bell"
            return True
        if self._is_beside_event(piece, wall) or (said.preposition is None and self._is_subject(piece, wall)):
            return True
        if "to" in {said.preposition, before} and self.around.names_place(piece):
            return True
        # "Turn on the ten o'clock news", "the slides for the Monday meeting"
        owned = bool(self.closed.noun_openers & set(self.texts[piece.start + 1 : piece.end][:1]))
        inside = said.preposition == "in" and is_weekday(wall.days)
        about = self.texts[piece.start] == "about"
        if (said.preposition in NAMING or inside or about) and owned and not self.around.may_end(piece):
            return True
        # "My day planner"
        return (
            said.preposition is None
            and self.texts[piece.start] in self.closed.possessives
            and not self.around.may_end(piece)
        )

    def _is_at_home(self, piece: Piece) -> bool:
        """Whether somebody's home stands before it, and it is more than a number."""
        at, owner = ["", "", *self.texts[: piece.start]][-2:]
        home = at in self.beside.whereabouts and owner.endswith("'s")
        return home and piece.end > piece.start + 1 and self.around.may_end(piece)

    def _is_beside_event(self, piece: Piece, wall: Wall) -> bool:
        """Whether it counts from what is named behind it, or is not: "the day before the flight"."""
        last, behind = self.texts[piece.end - 1], self.around.follower(piece)
        counted = last in self.beside.before_or_after and self.texts[piece.end - 2] not in {
            "or",
            "and",
            "not",
            "time",
        }
        if counted and wall.days is not None and behind[:1].isalpha() and behind != "and":
            return True
        # "The evening before the trip", "at ten the evening before": which evening, is not said.
        *_, bound, article = ("", "", *self.texts[piece.start : piece.end - 1])
        # "Bring the lambs in the night before the sale"
        brought = piece.start > 0 and bound in self.lexicon.particles
        bare = bound == "on" or brought or bound not in self.lexicon.function_words
        inner = article in self.closed.the and bare
        led = inner or "the" in {self.texts[piece.start], self.around.before(piece)}
        return wall.part is not None and behind in {"before", "after"} and led

    def _is_subject(self, piece: Piece, wall: Wall) -> bool:
        """Whether it is in the name of what is said to be then: "parents evening is tuesday"."""
        feast = isinstance(wall.days, Feast)
        if wall.clock is not None or (wall.days is not None and not feast):
            return False
        before, (behind, further) = self.around.before(piece), (*self.texts[piece.end :], "", "")[:2]
        be, unnamed = self.closed.present_be, self.lexicon.function_words
        if behind in be:
            named = before.isalpha() and before not in unnamed and not self.around.timely(piece.start - 1)
            return named or feast
        # "Morning assembly is at nine"
        named = behind.isalpha() and behind not in unnamed and not self.around.timely(piece.end)
        return further in be and named and self.around.opens(piece.start)

    def _is_next_in_row(self, piece: Piece, wall: Wall) -> bool:
        """Whether an ordinal counts things and no days: "the first piece at nine and the second at ten"."""
        days, begin = wall.days, piece.start - (self.around.before(piece) in self.closed.the)
        if not isinstance(days, Fields) or days != Fields(day=days.day):
            return False
        if wall.clock is not None and self.texts[piece.end - 1] in self.lexicon.ordinals:
            # "Spray the first coat at noon, the second an hour later"
            begin = piece.end - 2
        joined = begin > 0 and self.texts[begin - 1] in self.lexicon.closed.joints_of_things
        joined = joined and self.texts[begin] in self.closed.the
        return joined and any(text in self.lexicon.ordinals for text in self.texts[:begin])

    def _is_called(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether something is called by a clock time, or by two numbers that look like one."""
        if said.preposition in {None, "of"} and not said.hedges and self.around.cites(piece.start):
            # As in "Read John 3:16"; but "prepare the slide sixish".
            return True
        if wall.days is not None or wall.clock is None:
            return False
        if said.preposition is None and self.around.before(piece) in self.closed.the:
            # As in "Cancel the 7:42".
            return True
        met = self.is_met(piece.start) or self.around.before(piece) in self.lexicon.doing.meeting
        if wall.clock.pair and said.preposition == "at" and met and self._is_at_clock(piece.end):
            # "Meet at seven eleven at noon": that is where.
            return True
        # As in "Book me on the 7:42", "on the nine thirty".
        pair = wall.clock.pair and said.preposition != "on"
        minutes = wall.clock.grain is Unit.MINUTE and not pair
        return (
            minutes and said.preposition in {"on", "for"} and self.texts[piece.start + 1] in self.closed.the
        )

    def _is_at_clock(self, place: int) -> bool:
        """Whether "at" and a clock time stand at a place."""
        led = self.texts[place : place + 1] == ["at"]
        parts = (one.value for one in self.around.pieces(place + 1) if one.category == "part")
        return led and (self.measures.is_number(place + 1) or any(part.is_point for part in parts))


class Counts(Standing):
    """What is counted beside days and clock times."""

    def hold(self, piece: Piece, wall: Wall) -> bool:
        """Whether one of its numbers counts something else."""
        several = self._counts_several(piece, wall) or self._counts_feast(piece, wall)
        return several or self._is_of_parts(piece, wall) or self._counts_things(piece, wall)

    def _counts_things(self, piece: Piece, wall: Wall) -> bool:
        """Whether ordinals count things and no days: "on the first, second and fifth floors"."""
        numbered = is_day_of_month(wall.days) and wall.clock is None
        last = piece.end - 1
        if not numbered or not (self.is_ordinal(last) or self.is_ordinal(last - 1)):
            return False
        end = self._end_of_ordinals(piece.end)
        return end is not None and not self.around.may_end(piece._replace(end=end))

    def _end_of_ordinals(self, place: int) -> int | None:
        """Give where ordinals end that are joined at a place: "on the 2nd | to 3rd"; None without one."""
        joints = self.closed.coordinators_of_days | self.closed.range_joints
        end, at = place, place
        while at < len(self.texts):
            if self.is_ordinal(at) and at > end:
                at += 1 + self.words[at].is_digits
                end = at
            elif self.texts[at] in joints | {",", "the"}:
                at += 1
            else:
                break
        return end if joints.intersection(self.texts[place:end]) else None

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
