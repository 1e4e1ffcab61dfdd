"""Whether a wall-clock expression is a time where it stands, and not a number or a part of a noun."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.standing import Standing
from fuzzytime.language.grammar.words import joins
from fuzzytime.language.meaning.calendar import Cycle, Fields
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.language.meaning.feasts import Season
from fuzzytime.language.meaning.relations import Deictic, Which
from fuzzytime.requirement import Unit

UNBINDING = frozenset({None, "to", "at", "for", "of", "on", "in", "from", "starting"})
"""Prepositions behind which a meal is a thing, or a place: "sugar in tea", "home from work"."""

NAMING = frozenset({"on", "to", "for", "of"})
"""Prepositions behind which an article and a time begin a noun: "the slides for the 3 pm meeting"."""

PRESENT = tuple(Deictic(Which.THIS, Cycle(unit)) for unit in (Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR))
"""Periods that "the week" and "the year" are, behind a preposition."""

THING = "thing"
"""The last word of a time that may be any thing: "first thing"."""

DEGREES_DIGITS = 3
"""Digits of an oven's temperature, and of few clock times."""

CLOCK_DIGITS = 4
"""Digits of a clock time without a colon, as in 1745: more than most amounts have."""


class Walls(Standing):
    """What stands around days and clock times, and whether it makes one doubtful."""

    def accept(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether a day, a part of the day or a clock time is one here."""
        counted = self._is_counted_part(piece, wall) or self._is_unbound(piece, said, wall)
        counted = counted or self._goes_on(piece, wall) or self._is_of_event(piece, wall)
        counted = counted or self._counts_several(piece, wall)
        if counted or self._is_thing(piece, wall) or self._is_part_of_noun(piece, said, wall):
            return False
        if wall.bare:
            return self._accepts_number(piece, said, wall)
        if self.around.is_unit(piece.end) and isinstance(wall.days, Fields) and not wall.days.weekly:
            # "The 18th century table"
            return False
        if said.preposition == "of" and (self._is_ordinal(piece.end - 1) or isinstance(wall.days, Season)):
            # "Within a minute of the first", "within an hour of the fall"
            return False
        whole = wall.clock is not None and not wall.clock.shift
        if whole and said.preposition is None and self.measures.named(piece):
            # "Seat 12A"; but "at the gate five past nine"
            return False
        if wall.clock is not None and wall.clock.pair and wall.days is None and wall.part is None:
            return self._accepts_pair(piece, said)
        if (
            wall.part is not None
            and wall.part.place
            and self.texts[piece.end - 2] in self.closed.noun_openers
        ):
            # "Before bed", but "before the bed is made"
            return False
        if wall.weak:
            unbinding = UNBINDING if wall.part is not None else {None, "to", "at"}
            # "Ask about lunch": what a meal is asked about.
            bound = said.preposition not in unbinding or bool(set(said.hedges) - {"about"})
            # "After the 10 o'clock feed"
            clocked = self.around.follower(piece) in self.beside.of_hours
            return bound and not clocked and self.around.may_end(piece)
        part = wall.days is None and wall.clock is None
        ends = self.around.may_end(piece) or self.around.is_spent(piece)
        if part and said.preposition in {None, "to", "of"} and not ends:
            # "Switch to night mode"
            return False
        owned = self.texts[piece.end - 2] in self.closed.noun_openers and piece.end - piece.start > 1
        inside = piece.start > 0 and self.around.before(piece) not in self.beside.sentence_starts
        if part and owned and inside and not ends:
            # "The kettle for the night staff"
            return False
        weekly = isinstance(wall.days, Fields) and wall.days.weekly
        if (
            weekly
            and self.texts[piece.end - 2 : piece.end - 1] == ["the"]
            and self._is_ambiguous(piece.end - 1)
        ):
            # "Before the sun goes down"
            return False
        # "The sun", "in the sun": a weekday never stands with "in".
        words = [text for text in self.texts[piece.start : piece.end] if text not in {"the", "in"}]
        alone = len(words) == 1 and words[0] in self.lexicon.ambiguous and said.preposition in {None, "in"}
        return not alone or (weekly and self._is_listed(piece))

    def _is_of_event(self, piece: Piece, wall: Wall) -> bool:
        """Whether it is of a day that an event says: "the morning of the party"."""
        part = wall.part is not None and wall.days is None and wall.clock is None
        return part and self.texts[piece.end - 2] == "the" and self.around.follower(piece) == "of"

    def _is_listed(self, piece: Piece) -> bool:
        """Whether another day of the week stands beside it: "on mon, wed and fri"."""
        before, behind = piece.start - 1, piece.end
        while before > 0 and self.texts[before] in self.closed.coordinators_of_days:
            before -= 1
        while behind < len(self.texts) and self.texts[behind] in self.closed.coordinators_of_days:
            behind += 1
        return any(place >= 0 and self.around.is_weekday(place) for place in (before, behind))

    def _goes_on(self, piece: Piece, wall: Wall) -> bool:
        """Whether what is behind it, or in it, makes it what a thing is for, or one of several things."""
        led = self.texts[piece.start] == "for" or (piece.start > 0 and self.texts[piece.start - 1] == "for")
        if led and self._is_of_thing(piece):
            return True
        return self.around.follower(piece) in self.closed.coordinators_of_days and self._counts_things(
            piece, wall
        )

    def _is_of_thing(self, piece: Piece) -> bool:
        """Whether it is what is prepared for then: "send the rota for next week by thursday"."""
        places = range(piece.start + 1, piece.end + 1)
        if self.texts[piece.start] == "for":
            # "For tomorrow by noon" is one time.
            places = range(piece.end, piece.end + 1)
        bounds = (
            p.end for at in places for p in self.around.pieces(at) if p.category == "preposition_before"
        )
        return any(self.around.is_day(end) for end in bounds)

    def _counts_things(self, piece: Piece, wall: Wall) -> bool:
        """Whether ordinals count things and no days: "on the first and second floor"."""
        numbered = isinstance(wall.days, Fields) and wall.days.is_day_of_month and wall.clock is None
        if not numbered or not self._is_ordinal(piece.end - 1):
            return False
        behind = piece.end + 1 + (self.texts[piece.end + 1 : piece.end + 2] == ["the"])
        if behind >= len(self.texts) or not self._is_ordinal(behind):
            return False
        return not self.around.may_end(replace(piece, end=behind + 1))

    def _is_unbound(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether it names a period that no preposition makes a time: "check the year on the coin"."""
        return said.preposition is None and wall.days in PRESENT and self.texts[piece.start] == "the"

    def _accepts_pair(self, piece: Piece, said: Said) -> bool:
        """Whether two numbers are hour and minute: "at five thirty", not the "to three fifty" of an oven."""
        if said.preposition == "to" and self.measures.measured(piece) and not self.around.puts_off(piece):
            return False
        # "At five thirty pick up bread": no amount is said like that.
        worded = all(text in self.lexicon.numbers for text in self.texts[piece.end - 2 : piece.end])
        sure = said.preposition == "at" and worded
        unit = self.around.is_unit(piece.end) or self.measures.measured(piece)
        bound = said.preposition is not None or bool(said.hedges)
        # "Pick up the kids three fifteen": it is no number that is picked.
        alone = not (bound or self.around.is_unit(piece.end)) and self._ends_behind_object(piece)
        return alone or (bound and (self.around.may_end(piece) or (sure and not unit)))

    def _counts_several(self, piece: Piece, wall: Wall) -> bool:
        """Whether its last number counts what is behind it: "paint it tomorrow, two coats"."""
        if wall.days is None or wall.clock is None or not self.measures.is_number(piece.end - 1):
            return False
        follower, led = self.around.follower(piece), self.texts[piece.end - 2]
        several = follower.endswith("s") and follower not in self.lexicon.function_words
        return several and follower.isalpha() and led not in self.closed.prepositions_of_points

    def _ends_behind_object(self, piece: Piece) -> bool:
        """Whether it ends an order with a person, an animal or a call: "meet me five thirty"."""
        place = piece.start - (self.around.before(piece) in self.beside.put_off)
        before = self.texts[place - 1] if place else ""
        met = self.lexicon.persons | self.lexicon.animals | self.lexicon.events | self.beside.calls
        someone = before in self.closed.object_pronouns | met
        named = place > 1 and self.words[place - 1].capital
        spelt = all(text.isalpha() or text == "-" for text in self.texts[piece.start : piece.end])
        happens = before in self.lexicon.happening - self.lexicon.measure_nouns
        ends = {"", ".", "!", ",", ";"} | self.closed.further_clause
        return spelt and (someone or named or happens) and self.around.follower(piece) in ends

    def _is_thing(self, piece: Piece, wall: Wall) -> bool:
        """Whether it is served, described, wished: "with tea", "the first thing you see", "good morning"."""
        if self.texts[piece.end - 1] == THING:
            return self.around.follower(piece) not in ({""} | self.beside.behind_things)
        served = self._is_ambiguous(piece.end - 1) or not self.around.may_end(piece)
        greeting = self.around.before(piece) in self.beside.greeting and (
            wall.clock is None or wall.days is not None
        )
        return greeting or (self.texts[piece.start] == "with" and served)

    def _is_part_of_noun(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether it only names something, or belongs to what does."""
        before = self.around.before(piece)
        if said.preposition is None and wall.clock is not None and self.around.is_caught(piece):
            # What is caught is caught then: "catch the 7:42 to York".
            return False
        if said.preposition is None and (self.around.describes(piece) or self.around.names(piece, wall)):
            return True
        counting = self.words[piece.end - 1].is_digits and self.around.follower(piece).endswith("s")
        if said.preposition is None and counting and self._is_ambiguous(piece.start):
            # "March 3 steps forward"
            return not self.around.may_end(piece)
        if said.preposition is None and wall.clock is not None and self.around.is_owned(piece):
            # "Cancel my three o'clock", "move tomorrow's ten o'clock"
            return True
        if wall.clock is not None and self._is_called(piece, said, wall):
            return True
        if (said.preposition is None or wall.clock is not None) and self._is_next_in_row(piece, wall):
            return True
        if said.preposition is None and wall.clock is not None and self.around.is_put_off(piece):
            # "Move the 3 pm to five"
            return True
        last, behind = self.texts[piece.end - 1], self.around.follower(piece)
        if (
            last in {"before", "after"}
            and self.texts[piece.end - 2] not in {"or", "and", "not", "time"}
            and wall.days is not None
            and behind[:1].isalpha()
            and behind != "and"
        ):
            # "The day before the flight"
            return True
        followed = self.around.follower(piece) in {"before", "after"}
        *_, bound, article = ("", "", *self.texts[piece.start : piece.end - 1])
        inner = article == "the" and (bound == "on" or bound not in self.lexicon.function_words)
        if wall.part is not None and followed and ("the" in {self.texts[piece.start], before} or inner):
            # "The evening before the trip", "at ten the evening before": which evening, is not said.
            return True
        if "to" in {said.preposition, before} and self.around.names_place(piece):
            return True
        # "Turn on the ten o'clock news", "the slides for the Monday meeting"
        owned = bool(self.closed.noun_openers & set(self.texts[piece.start + 1 : piece.end][:1]))
        inside = said.preposition == "in" and isinstance(wall.days, Fields) and wall.days.weekly
        if (said.preposition in NAMING or inside) and owned and not self.around.may_end(piece):
            return True
        # "My day planner"
        return (
            said.preposition is None
            and self.texts[piece.start] in self.closed.possessives
            and not self.around.may_end(piece)
        )

    def _is_next_in_row(self, piece: Piece, wall: Wall) -> bool:
        """Whether an ordinal counts things and no days: "the first piece at nine and the second at ten"."""
        days, begin = wall.days, piece.start - (self.around.before(piece) == "the")
        if not isinstance(days, Fields) or days != Fields(day=days.day):
            return False
        if wall.clock is not None and self._is_ordinal(piece.end - 1):
            # "Spray the first coat at noon, the second an hour later"
            begin = piece.end - 2
        joined = begin > 0 and self.texts[begin - 1] in {"and", ","}
        joined = joined and self.texts[begin] == "the"
        return joined and any(text in self.lexicon.ordinals for text in self.texts[:begin])

    def _is_called(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether something is called by a clock time, or by two numbers that look like one."""
        if said.preposition in {None, "of"} and self.around.cites(piece.start):
            # As in "Read John 3:16".
            return True
        if wall.days is not None or wall.clock is None:
            return False
        if said.preposition is None and self.around.before(piece) == "the":
            # As in "Cancel the 7:42".
            return True
        # As in "Book me on the 7:42", "on the nine thirty".
        pair = wall.clock.pair and said.preposition != "on"
        minutes = wall.clock.grain is Unit.MINUTE and not pair
        return minutes and said.preposition in {"on", "for"} and self.texts[piece.start + 1] == "the"

    def _is_ambiguous(self, place: int) -> bool:
        return self.texts[place] in self.lexicon.ambiguous

    def _accepts_number(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether a number alone is a clock time: "at six", not the "at 180" of an oven."""
        ends = self.around.may_end(piece) or self._leads_to_distance(piece)
        if not ends or self.around.is_unit(piece.end):
            return False
        if said.preposition == "for" and self.around.follower(piece) == "at":
            # "Make dinner for eight at seven"
            return False
        if self.around.follower(piece) == "to" and self.measures.is_number(piece.end + 1):
            # "At three to one"
            return False
        before = piece.start - 1
        counted = self.measures.is_number(before)
        if piece.start > 1 and joins(self.words, before):
            # "A two-by-four"
            return False
        named = before > 0 and self.texts[before - 1] in self.lexicon.machines
        if said.preposition == "by" and counted and not named and not self.measures.is_amount(before):
            # "Two by four"
            return False
        if said.preposition == "through" and counted:
            # "Pages 3 through 7"
            return False
        digits = self.words[piece.end - 1].is_digits and len(self.texts[piece.end - 1]) == CLOCK_DIGITS
        hour = digits or (wall.clock is not None and wall.clock.grain is Unit.HOUR)
        sure = said.preposition == "at" and hour and not self.measures.named(piece)
        if not sure and said.preposition != "for" and self.measures.measured(piece):
            return False
        degrees = self.words[piece.end - 1].is_digits and len(self.texts[piece.end - 1]) == DEGREES_DIGITS
        if degrees and self.lexicon.measure_verbs & set(self.texts):
            # "Bake it at 180 for an hour, then half an hour at 200"
            return False
        if said.preposition == "to" and self.around.puts_off(piece):
            # "Move my three o'clock to five"
            return True
        if said.preposition in {None, "to", "in", "on", "of", "during", "sometime"}:
            return said.preposition is None and bool(said.hedges)
        return True

    def _leads_to_distance(self, piece: Piece) -> bool:
        """Whether so long before or after something follows: "at ten two days before the fair"."""
        unit = piece.end + 1
        counted = self.measures.is_number(piece.end) and self.around.is_unit(unit)
        return counted and self.texts[unit + 1 : unit + 2] in (["before"], ["after"])

    def _is_counted_part(self, piece: Piece, wall: Wall) -> bool:
        """Whether an ordinal counts parts of the day, and is no date: "cancel the second night"."""
        dated = isinstance(wall.days, Fields) and wall.days == Fields(day=wall.days.day)
        return dated and wall.part is not None and self._is_ordinal(piece.end - 2)

    def _is_ordinal(self, place: int) -> bool:
        return self.texts[place] in self.lexicon.ordinals
