"""Whether a number alone, or two that may be hour and minute, are a clock time where they stand."""

from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.judging.walls.dated_entries import LINE_STARTS
from fuzzytime.language.grammar.timetables import (
    HALF_DAY,
    counts_nothing,
    has_time,
    is_hour_of,
    leads_entry,
    timetable_of,
)
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.requirement import Unit

DEGREES_DIGITS = 3
"""Digits of an oven's temperature, and of few clock times."""

YEARS = frozenset(map(str, range(1900, 2100)))
"""Numbers of four digits in front of a thing that are hardly an hour: "2026 budget"."""

QUARTERS = frozenset({15, 30, 45})
"""Minutes that hardly a price has."""


class BareHours(Standing):
    """What stands around numbers that may be clock times, and whether it makes one doubtful."""

    def accept_number(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether a number alone is a clock time: "at six", not the "at 180" of an oven."""
        listed = said.preposition in {"at", "for"} and bool(self.run_on.behind(wall.clock, piece.end))
        # "Vet 9.15, pick up hay 10"; but "undock at 9.30, drive to shelf 4"
        alone = said.preposition is None and self.words[piece.start].is_digits
        alone = alone and not self.measures.named(piece)
        listed = listed or (alone and self._is_listed(piece))
        if listed or self.reminds(piece) or self._leads_entry(piece, said) or self._opens_line(piece, said):
            return True
        # "@1415 upstairs"
        marked = self.texts[piece.start] == "@" and self.measures.is_sure(piece.end - 1)
        ends = marked or self.around.may_end(piece) or self._leads_to_distance(piece)
        if not ends or self.around.is_unit(piece.end):
            return False
        if self.around.follower(piece) in self.closed.to and self.measures.is_number(piece.end + 1):
            # "At three to one"
            return False
        *before, led = ["", *self.texts[: max(0, piece.start - 1)]]
        sized = led == "a" or (led == "to" and not self.lexicon.no_times.sizing.isdisjoint(before))
        if said.preposition == "by" and sized and self.measures.is_number(piece.start - 1):
            # "Cut the plank to 6 by 2"; but "heat it to 200 by 6"
            return False
        if self._is_counted(piece, said) or self._counts_either(piece):
            return False
        if said.preposition is None and (self._ends_meeting(piece) or self._is_hour_of(piece)):
            return True
        # "At fourteen hundred"
        spelt = self.texts[piece.end - 1] == "hundred" and wall.clock is not None and wall.clock.full_day
        hour = (
            spelt
            or self.measures.is_sure(piece.end - 1)
            or (wall.clock is not None and wall.clock.grain is Unit.HOUR)
        )
        sure = said.preposition == "at" and hour and not self.measures.named(piece)
        if not sure and said.preposition != "for" and self.measures.measured(piece):
            return False
        degrees = self.words[piece.end - 1].is_digits and len(self.texts[piece.end - 1]) == DEGREES_DIGITS
        if degrees and (self.lexicon.measure_verbs & set(self.texts) or self._is_heat_beside(piece)):
            # "Bake it at 180 for an hour, then half an hour at 200"
            return False
        if said.preposition == "to" and self.given.puts_off(piece):
            # "Move my three o'clock to five"
            return True
        if said.preposition in {None, "to", "in", "on", "of", "during", "sometime"}:
            return said.preposition is None and (bool(said.hedges) or self._is_listed(piece))
        return True

    def _is_heat_beside(self, piece: Piece) -> bool:
        """Whether so long is said beside it, and nothing happens: "beans at 220 for 20 minutes"."""
        place = piece.end + (self.around.follower(piece) in {"for", ",", "/"})
        before = self.texts[: piece.start]
        long = self.around.is_unit(piece.start - 1) or (
            self.measures.is_number(place) and self.around.is_unit(place + 1)
        )
        ordered = not (self.lexicon.orders | self.lexicon.addressing).isdisjoint(before[:1])
        return long and not ordered and not any(has_time(text, self.lexicon) for text in before)

    def _counts_either(self, piece: Piece) -> bool:
        """Whether it is the first of two numbers that count what is behind them: "around 3 or 4 cats"."""
        offered = self.around.follower(piece) in self.closed.alternatives
        second = piece.end + 1
        if not offered or not self.measures.is_number(second):
            return False
        counted = "".join(self.texts[second + 1 : second + 2])
        several = counted.isalpha() and self.around.are_several(counted)
        return several and counted not in self.lexicon.function_words

    def _is_counted(self, piece: Piece, said: Said) -> bool:
        """Whether a number before it makes it the second of two: "two by four", "pages 3 through 7"."""
        before = piece.start - 1
        if not self.measures.is_number(before):
            return False
        called = self.texts[before - 1] if before else ""
        # "Answer question 9 by 9"; but "a table 4 by 6"
        named = called in self.lexicon.machines or self.measures.is_called(before)
        # "Choose one by five"
        named = named or self.texts[before] in self.closed.singular_determiners
        measures = not named and not self.measures.is_amount(before)
        return said.preposition == "through" or (said.preposition == "by" and measures)

    def accept_pair(self, piece: Piece, said: Said) -> bool:
        """Whether two numbers are hour and minute: "at five thirty", not the "to three fifty" of an oven."""
        if said.preposition == "to" and self.measures.measured(piece) and not self.given.puts_off(piece):
            return False
        if said.preposition is None and self.given.is_caught(piece):
            # "Catch the 4.15 train"
            return True
        # "At five thirty pick up bread": no amount is said like that.
        worded = all(text in self.lexicon.numbers for text in self.texts[piece.end - 2 : piece.end])
        sure = said.preposition == "at" and worded
        unit = self.around.is_unit(piece.end) or self.measures.measured(piece)
        bound = said.preposition is not None or bool(said.hedges)
        # "Pick up the kids three fifteen": it is no number that is picked.
        alone = not (bound or self.around.is_unit(piece.end)) and (
            self._ends_behind_object(piece)
            or self._is_told(piece)
            or self._is_listed(piece)
            or self._is_in_front(piece)
            or self._leads_entry(piece, said)
        )
        return alone or (bound and (self.around.may_end(piece) or (sure and not unit)))

    def _ends_behind_object(self, piece: Piece) -> bool:
        """Whether it ends an order with a person, an animal or a call: "meet me five thirty"."""
        place = piece.start - (self.around.before(piece) in {"(", *self.beside.put_off})
        before = self.texts[place - 1] if place else ""
        met = self.lexicon.persons | self.lexicon.animals | self.lexicon.events | self.beside.calls
        someone = before in self.closed.object_pronouns | met
        named = (place > 1 and self.words[place - 1].capital) or self.is_called(place)
        spelt = all(text.isalpha() or text == "-" for text in self.texts[piece.start : piece.end])
        happens = before in self.lexicon.happening - self.lexicon.measure_nouns
        begins = self._begins_then(before)
        if self.words[piece.start].is_digits and (begins or piece.value.time.clock.minute in QUARTERS):
            # "Dentist 9.30", but "lunch 12.50"
            taken = self.lexicon.taken - self.lexicon.measure_nouns
            known = (place == 1 and (happens or before in taken)) or self.is_met(place) or begins
            known = known or before in self.lexicon.events
            return known and self._ends_order(piece)
        told = someone or named or happens or self._ends_at_quarter(piece, place)
        return spelt and told and self._ends_order(piece)

    def _is_told(self, piece: Piece) -> bool:
        """Whether what happens is said to be then: "start time is 14.00"; but "the total is 14.00"."""
        if self.around.before(piece) not in self.closed.third_person_be or not self._ends_order(piece):
            return False
        doing, said = self.lexicon.doing, self.texts[: piece.start - 1]
        begins = doing.timed | doing.several_timed
        return any(word in begins or self._happens(word) for word in said)

    def _is_hour_of(self, piece: Piece) -> bool:
        """Whether a number is the hour of what happens: "curfew is 11", "they shut 6", "(opens 9)"."""
        clock = piece.value.time.clock if isinstance(piece.value.time, Wall) else None
        hour = clock is not None and clock.grain is Unit.HOUR and not clock.full_day
        place = piece.start - (self.around.before(piece) == "(")
        begins = self.lexicon.doing.hours | self.lexicon.doing.surely_timed
        opens = place > 0 and self.texts[place - 1] in begins and self._ends_order(piece)
        # "Close 2" is an order.
        opens = opens and (place > 1 or self.texts[place - 1].endswith("s"))
        return hour and (opens or (self._is_told(piece) and self._happens(self.texts[piece.start - 2])))

    def _happens(self, word: str) -> bool:
        """Whether a word names what has a time: "curfew", "meeting"."""
        lexicon = self.lexicon
        return any(word in words for words in (lexicon.happening, lexicon.taken, lexicon.events))

    def _begins_then(self, word: str) -> bool:
        """Whether what a word says is at a moment: "leave | 7.30", "the film starts | 8.10"."""
        doing = self.lexicon.doing
        moving = (doing.leaving | doing.arriving) - self.lexicon.lasting
        return word in doing.timed | doing.several_timed | moving

    def _ends_at_quarter(self, piece: Piece, place: int) -> bool:
        """Whether minutes that few numbers end in stand behind a thing: "feed the cat six fifteen".

        So do minutes to an hour, which are no range: "water the plants ten to five".
        """
        before = self.texts[place - 1] if place else ""
        kinds = self.lexicon.no_times
        costs = not (kinds.costing | kinds.betting | self.lexicon.rating).isdisjoint(self.texts[: place - 1])
        counted = self.lexicon.called_by_number | self.lexicon.amount_nouns | kinds.codes
        # "Mark questions ten to twelve"
        named = before.isalpha() and {before, before.removesuffix("s")}.isdisjoint(counted)
        named = named and before not in self.lexicon.function_words
        thing = named and not self.measures.is_number(place - 1) and not self.around.opens(place - 1)
        minutes = piece.value.time.clock.minute in QUARTERS or "to" in self.texts[piece.start : piece.end]
        return thing and not costs and minutes

    def _ends_meeting(self, piece: Piece) -> bool:
        """Whether a number ends what is said of a meeting: "call mum 5", "lunch 12", "dentist 1430"."""
        if piece.end - piece.start > 1 or not self._ends_order(piece):
            return False
        number = self.texts[piece.start]
        if self.measures.is_sure(piece.start):
            before, events = self.around.before(piece), self.lexicon.events - self.lexicon.addressing
            met = self.is_met(piece.start) or self._begins_then(before) or before in events
            return self.is_called(piece.start) or (met and number not in YEARS)
        return number.isdecimal() and 0 < int(number) <= HALF_DAY and self.is_met(piece.start)

    def _is_in_front(self, piece: Piece) -> bool:
        """Whether two typed numbers stand in front of what is then: "14.30 tea"; but "2.50 coffee"."""
        clock = piece.value.time.clock
        typed = clock is not None and self.words[piece.start].is_digits
        leads = self._begins_line(piece) and counts_nothing(self.words, piece.end, self.lexicon)
        if not typed or not leads:
            return False
        # "7.00 bake the rolls": no price is done.
        done = not self.closed.noun_openers.isdisjoint(self.texts[piece.end + 1 : piece.end + 2])
        return done or clock.hour >= self.lexicon.policy.bare_pair_from or clock.minute in QUARTERS

    def _begins_line(self, piece: Piece) -> bool:
        """Whether it stands at the start of a text, or of an entry."""
        return not piece.start or self.texts[piece.start - 1] in LINE_STARTS

    def _ends_order(self, piece: Piece) -> bool:
        """Whether nothing more is said of what is to be done behind it."""
        ends = self.beside.polite_ends | self.closed.further_clause | {"", ")"}
        return self.around.follower(piece) in ends - {":", "?"}

    def _is_listed(self, piece: Piece) -> bool:
        """Whether it is the hour of an entry of a list: "vet 10, dentist 3"."""
        return self._timetable.get(piece.end, piece.start) < piece.start

    @cached_property
    def _timetable(self) -> dict[int, int]:
        """Where the entries of a list begin, by where they end: the same for all of its hours."""
        return timetable_of(self.words, self.lexicon)

    def _leads_entry(self, piece: Piece, said: Said) -> bool:
        """Whether it is the hour in front of an entry of a list: "10am vet; 12 lunch"."""
        led = said.preposition is None or self.texts[piece.start] == "@"
        return led and leads_entry(self.words, piece.start, piece.end, self.lexicon)

    def _opens_line(self, piece: Piece, said: Said) -> bool:
        """Whether it stands in front of what is then, and counts nothing: "1430 tea", "@9 standup"."""
        if not self._begins_line(piece):
            return False
        first, number = self.texts[piece.start], self.texts[piece.end - 1]
        behind = piece.end + (self.around.follower(piece) in {":", "-"})
        if said.preposition is None and is_hour_of(self.words, piece.start, piece.end, self.lexicon):
            # "12 lunch", "9 market"
            return True
        sure = first == "@" or number.startswith("0")
        if not counts_nothing(self.words, behind, self.lexicon, plural=sure):
            return False
        if said.preposition == "at":
            return first == "@" and self.words[piece.start + 1].glued
        whole = piece.end - piece.start == 1 and self.measures.is_sure(piece.start)
        if said.preposition is not None or not whole or number in YEARS:
            return False
        # "1000 piece puzzle", but "1000 briefing"
        known = has_time(self.around.follower(piece), self.lexicon)
        known = known or self.around.is_part_or_meal(piece.end)
        return known or number.startswith("0") or not number.endswith("00")

    def _leads_to_distance(self, piece: Piece) -> bool:
        """Whether so long before or after something follows: "at ten two days before the fair"."""
        unit = piece.end + 1
        counted = self.measures.is_number(piece.end) and self.around.is_unit(unit)
        return counted and self.texts[unit + 1 : unit + 2] in (["before"], ["after"])
