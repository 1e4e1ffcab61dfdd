"""Whether a stretch from one time to another is one where it stands: not "the Monday to Friday timetable"."""

from collections.abc import Sequence

from fuzzytime.english import looks_plural, singular
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Range, Repeat, Said, Time, Wall, wall_of

EARLY = 3600
"""Seconds before the hour of a meal within which it may begin: a stretch until it is longer."""

TIMES = frozenset({"x", "×"})
"""What stands between how many there are and what they are: "2 x aspirin"."""

ONE = frozenset({"1", "one"})

HOURS_OF_DAY = frozenset({"ranges.hours_of_day", "ranges.hours_of_date"})
"""The rules of two numbers behind a day: "on friday 9-5"."""


class Ranges(Standing):
    """What stands around stretches from one time to another, and whether it makes one doubtful."""

    def accept(self, piece: Piece, said: Said, time: Range) -> bool:
        """Whether a stretch of time is one here."""
        if self.given.is_put_off(piece):
            # As in "Reschedule the 3 pm to 4:30".
            return False
        if self.around.before(piece) in self.closed.distributives:
            # "Check the oven every | 10 till 5"
            return False
        led = self.texts[piece.start] in self.closed.noun_openers or piece.rule in HOURS_OF_DAY
        if led and not self.around.may_end(piece):
            # "The Monday to Friday timetable", "order for friday 2-3 pizzas"
            return False
        if self.around.describes(piece):
            # "Watch the ten to midnight film"
            return False
        joint = self.texts[piece.start + 1]
        placed = self.texts[piece.start - 2] in self.lexicon.places or joint in self.beside.binding_ranges
        if self.measures.is_called(piece.start) and placed:
            # "Wait at platform 9 until 9", "charge robot 1 until 11"
            return False
        if self.texts[piece.start] == "one" and self.around.before(piece).isalpha():
            # "Reserve the blue one until friday"
            return False
        if self._is_meal_until(piece, time) or self._is_before_length(piece, time):
            return False
        if isinstance(time.first, Offset) or isinstance(time.last, Offset):
            # "At most half an hour after 1730"
            return self.around.may_end(piece)
        ends = [end for end in (time.first, time.last) if isinstance(end, Wall)]
        if self._are_levels(piece, ends):
            return False
        number = wall_of(time.first).bare and wall_of(time.last).clock is None
        if number and self.texts[piece.start] not in self.beside.binding_ranges:
            # "Keep it above 15 until the end of april"
            return False
        if ends and all(end.bare or end.weak for end in ends):
            return self._accepts_doubtful(piece, said, ends)
        return True

    def _accepts_doubtful(self, piece: Piece, said: Said, ends: Sequence[Wall]) -> bool:
        """Whether two numbers, days of a month, months or meals are from when to when something is."""
        # "Book a room from the 10th to the 12th", "let the flat from may to august"
        dated = all(isinstance(end.days, Fields) for end in ends)
        bound = said.denied or self._binds(piece) or (dated and self._has_dash(piece))
        # "Book a room from lunch to dinner"
        sure = not any(end.bare for end in ends) or not self.measures.measured(piece)
        # "@12 - 1 Ann": so are hours of a list marked.
        sure = self.texts[piece.start] == "@" or (sure and self.around.may_end(piece))
        return said.preposition == "between" and bound and sure

    def are_amounts(self, piece: Piece) -> bool:
        """Whether two numbers before a repetition are none of its hours: "take 1 to 2 every day".

        Nor are those of what has a level ("the heating 17 to 20 on weekdays"), as those of homework are.
        """
        before, doing = self.around.before(piece), self.lexicon.doing
        done = (self.lexicon.orders | doing.errands | doing.putting) - self.lexicon.lasting
        levels = self.beside.with_levels | self.lexicon.amount_nouns | self.lexicon.called_by_number
        numbers = self.measures.is_number(piece.start) and self.measures.is_number(piece.start + 2)
        joined = numbers and self.texts[piece.start + 1] in self.closed.range_joints
        return joined and (before in done | levels or self.measures.measured(piece))

    def _has_dash(self, piece: Piece) -> bool:
        """Whether a dash joins days of a month, or months: "3rd-5th", "june-august"; not "rows 3rd-5th"."""
        named = {self.around.before(piece), singular(self.around.before(piece))}
        return "-" in self.texts[piece.start : piece.end] and named.isdisjoint(self.lexicon.called_by_number)

    def _is_before_length(self, piece: Piece, time: Range) -> bool:
        """Whether its last number counts a unit, or things, behind a dash: "lunch 12:15 - 20 mins"."""
        dash = self.texts[piece.end - 2] == "-" and self.measures.is_number(piece.end - 1)
        # "8am - 2 x aspirin"
        counts = self.around.is_unit(piece.end) or self.around.follower(piece) in TIMES
        return dash and not wall_of(time.first).bare and counts

    def _is_meal_until(self, piece: Piece, time: Range) -> bool:
        """Whether a meal is served until then: "serve lunch until three", not "tomorrow lunch to two"."""
        first, before = time.first, self.around.before(piece)
        meal = isinstance(first, Wall) and first.clock is None and first.part is not None and first.part.meal
        led = before.isalpha() and not self.around.timely(piece.start - 1)
        return meal and led and self.around.is_part_or_meal(piece.start)

    def _are_levels(self, piece: Piece, ends: Sequence[Wall]) -> bool:
        """Whether the hour stands behind two numbers: "turn the heating from 17 to 20 at half past four"."""
        numbers = len(ends) > 1 and all(end.bare for end in ends) and self.texts[piece.start] == "from"
        hour = self.measures.is_number(piece.end + 1) or self.around.timely(piece.end + 1)
        hour = hour or bool({*self.texts[piece.end + 1 : piece.end + 2]} & self.beside.parts_of_hours)
        return numbers and self.around.follower(piece) == "at" and hour

    def heads_meal(self, piece: Piece, time: Time | Duration | Repeat) -> bool:
        """Whether a dash stands in front, between a clock time and the meal then: "12:00 - lunch".

        So do two hours from when to when, which are no date: "@12-1 lunch". A number in words behind an
        hour as typed counts what is then, "7:30 pm - one can of food", as does a number of things.
        """
        if not isinstance(time, Range):
            dated = isinstance(time, Wall) and time.days is not None and time.part is not None
            return dated and self.texts[piece.start] == "@" and "-" in self.texts[piece.start : piece.end]
        # The last of two: "8:00 -- Breakfast"
        dash = next((p for p in range(piece.end - 1, piece.start, -1) if self.texts[p] == "-"), None)
        first, last = time.first, time.last
        if dash is None or self.words[dash + 1].glued:
            return False
        if not isinstance(first, Wall) or not isinstance(last, Wall) or first.clock is None:
            return False
        counted = last.bare and not first.bare and piece.end == dash + 2
        if counted and self._counts_things(piece):
            return True
        if counted or not self.around.opens(piece.start):
            typed = any(word.is_digits for word in self.words[piece.start : dash])
            spelled = self.words[piece.end - 1].is_letters and self.around.follower(piece) != ""
            return counted and typed and spelled and self.around.opens(piece.start)
        meal = last.part if last.clock is None else None
        # "10am - lunch" is until then.
        return (
            meal is not None
            and meal.meal
            and any(seconds > meal.start - EARLY for seconds in first.clock.candidates())
        )

    def _counts_things(self, piece: Piece) -> bool:
        """Whether the last number counts what is taken then: "8am - 2 tablets"; but "9am - 2 meetings"."""
        number, thing, lexicon = self.texts[piece.end - 1], self.around.follower(piece), self.lexicon
        several = looks_plural(thing) if number not in ONE else thing not in lexicon.chores | lexicon.lasting
        known = lexicon.happening | lexicon.taken | lexicon.function_words | lexicon.orders
        return several and thing.isalpha() and known.isdisjoint({thing, singular(thing)})

    def _binds(self, piece: Piece) -> bool:
        """Whether its first words make two numbers its ends."""
        # "No earlier than eight and no later than nine"
        first = self.texts[piece.start : piece.start + 3]
        sometime = piece.value.preposition == "between" and "between" in first
        # "Any time after lunch but before four"
        led = first if first[1:2] == ["time"] else first[:2]
        return bool(self.beside.binding_ranges & set(led)) or "than" in first or sometime
