"""Whether a wall-clock expression is a time where it stands, and not a number or a part of a noun."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.judging.walls.bare_hours import BareHours
from fuzzytime.language.grammar.judging.walls.dated_entries import (
    HEADS,
    LINE_STARTS,
    is_activity_in_part,
    is_of_timed_activity,
)
from fuzzytime.language.grammar.judging.walls.naming import Counts, Naming
from fuzzytime.language.grammar.judging.walls.weak_walls import WeakWalls
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.grammar.surroundings.surroundings import THING, Surroundings
from fuzzytime.language.grammar.timetables import has_time
from fuzzytime.language.meaning.calendar import Cycle, Fields, is_weekday
from fuzzytime.language.meaning.days.relations import Deictic, Which
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.language.meaning.feasts import OfYear, Season
from fuzzytime.requirement import Unit

PRESENT = tuple(Deictic(Which.THIS, Cycle(unit)) for unit in (Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR))
"""Periods that "the week" and "the year" are, behind a preposition."""

APART = frozenset({"-", "–", "—", ",", "("})
"""What may stand between what a title names and its day."""

BOUND = 2
"""Words of a preposition and the one that it binds: "to christmas"."""


class Walls(Standing):
    """What stands around days and clock times, and whether it makes one doubtful."""

    def __init__(self, around: Surroundings) -> None:
        super().__init__(around)
        self.hours, self.weak = BareHours(around), WeakWalls(around)
        self.counts, self.naming = Counts(around), Naming(around)

    def accept(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether a day, a part of the day or a clock time is one here."""
        if self.counts.hold(piece, wall) or self._is_unbound(piece, said, wall):
            return False
        if wall.clock is not None and (self._is_degrees(piece) or self._is_mixed(piece)):
            return False
        if self._is_of_event(piece, wall) or self._is_thing(piece, wall):
            return False
        if self.naming.hold(piece, said, wall) or self._is_one(piece, wall):
            return False
        if wall.bare or self._goes_to_number(piece, wall):
            return self._accepts_number(piece, said, wall)
        if self._begins_other(piece, said, wall):
            return False
        if wall.clock is not None and wall.clock.pair and wall.days is None and wall.part is None:
            return self.hours.accept_pair(piece, said)
        if self._names_noun(piece, said):
            return False
        if wall.weak:
            return self.weak.accept(piece, said, wall)
        parted = wall.days is None and wall.clock is None and not self._ends_in_thing(piece)
        if parted and self._is_of_noun(piece, said) and not self._is_entry(piece, said):
            return False
        weekly = is_weekday(wall.days)
        led = self.texts[piece.end - 2 : piece.end - 1] == ["the"]
        # "The sun", "in the sun": a weekday never stands with "in".
        words = [text for text in self.texts[piece.start : piece.end] if text not in {"the", "a", "in"}]
        if self._doubtful_feast(piece, said, wall) is not None:
            ends = self.around.may_end(piece) and self.around.follower(piece) not in self.closed.of
            return said.preposition not in {None, "to"} and ends
        alone = len(words) == 1 and words[0] in self.lexicon.ambiguous and said.preposition in {None, "in"}
        # "Check the baby in the night"
        alone = alone and (wall.part is None or not led)
        entered = self._is_listed(piece) or self._heads_entry(piece) or self._ends_entry(piece)
        return not alone or (weekly and entered)

    def _accepts_number(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether a number is an hour: "at six", "push lunch to one tomorrow"."""
        if wall.bare:
            return self.hours.accept_number(piece, said, wall)
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        moved = self.given.reschedules(before) and not self.measures.measured(piece)
        return said.preposition == "to" and (moved or self.hours.accept_number(piece, said, wall))

    def _goes_to_number(self, piece: Piece, wall: Wall) -> bool:
        """Whether "to" is before a number alone, and a day behind it: "set the heating to 20 tomorrow"."""
        hour = wall.clock is not None and wall.clock.grain is Unit.HOUR and wall.clock.half is None
        place = piece.start + (self.texts[piece.start] in self.closed.to)
        behind = self.texts[place + 1 : place + 2]
        alone = self.measures.is_number(place) and self.beside.of_clocks.isdisjoint(behind)
        return hour and not wall.bare and alone and self.texts[place - 1 : place] == ["to"]

    def _is_one(self, piece: Piece, wall: Wall) -> bool:
        """Whether it begins with one of some things, and a day: "order a new one | fri"."""
        if not piece.start or wall.days is None or wall.clock is None or self.texts[piece.start] != "one":
            return False
        hour = (
            self.measures.is_number(piece.start + 1) or self.texts[piece.start + 1] in self.beside.of_clocks
        )
        return self.around.before(piece).isalpha() and not hour

    def _leads_event(self, piece: Piece) -> bool:
        """Whether what happens stands behind it, and no meal: "wed dentist 2:30"."""
        meal = self.around.is_part_or_meal(piece.end)
        return not meal and has_time(self.around.follower(piece), self.lexicon)

    def _heads_entry(self, piece: Piece) -> bool:
        """Whether a short name of a day begins an entry: "sat: market", "wed dentist"."""
        if piece.start and self.texts[piece.start - 1] not in {",", *LINE_STARTS}:
            return False
        behind = self.around.follower(piece)
        if behind in HEADS or self._leads_event(piece):
            return True
        begun = (p + 1 for p, text in enumerate(self.texts[:-1]) if text in {",", *LINE_STARTS})
        others = [p for p in (0, *begun) if p != piece.start]
        return behind.isalpha() and any(self.around.is_weekday(p) for p in others)

    def _ends_entry(self, piece: Piece) -> bool:
        """Whether a short name of a day ends an order, or a title: "call mum sat", not "where dad sat"."""
        before, place = self.around.before(piece), piece.start
        if before in APART and place > 1:
            # As in "jumble sale - Sat", or with the day between brackets.
            before = self.texts[place - 2]
        ends = self.around.follower(piece) in self.beside.polite_ends | {"", ")"}
        named = before.isalpha() and before not in self.lexicon.function_words | self.lexicon.addressing
        clause = self.closed.relatives | self.closed.free_relatives | self.closed.personal_pronouns
        told = any(text in clause or (text,) in self.lexicon.clauses for text in self.texts[:place])
        if told or not (ends and named and self.is_ambiguous(place)):
            return False
        thing = self.texts[place] in self.beside.things_in_days and not self.words[place].capital
        return not thing or self.is_called(place)

    def _doubtful_feast(self, piece: Piece, said: Said, wall: Wall) -> Piece | None:
        """Give what it begins with, a feast or not: "he lent it", "call Ramadan"; None with its year."""
        if isinstance(wall.days, OfYear):
            return None
        # A preposition, and hedges, may stand before its name: "around the lantern festival".
        before = {"the", *" ".join((said.preposition or "", *said.hedges)).split()}
        places = range(piece.start, piece.end)
        first = next((place for place in places if self.texts[place] not in before), piece.end)
        feasts = (one for one in self.around.pieces(first) if one.category == "feast")
        return next((one for one in feasts if one.value.doubtful), None)

    def may_be_order(self, piece: Piece, said: Said) -> bool:
        """Whether it may say what is to be done on a weekday: "clean monday"."""
        feast = self._doubtful_feast(piece, said, said.time) if isinstance(said.time, Wall) else None
        return feast is not None and said.preposition is None and self.around.is_weekday(feast.end - 1)

    def _begins_other(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether its last word belongs to a noun, or its first is a thing that has a number."""
        if said.preposition == "on" and self.texts[piece.start + 1] in self.beside.through_the_night:
            # "Leave it on | overnight"
            return True
        number = said.preposition is None and bool(said.hedges) and self.measures.is_number(piece.start)
        if number and wall.days is None and not self.around.may_end(piece):
            # "Bring six or so boxes"
            return True
        if wall.zone is not None and self.is_ambiguous(piece.end - 1) and not self.around.may_end(piece):
            # "At six central station"
            return True
        if self.around.is_unit(piece.end) and isinstance(wall.days, Fields) and not wall.days.weekly:
            # "The 18th century table"
            return True
        counts = wall.clock is not None and self.measures.is_number(piece.end - 1)
        named = "".join(self.texts[piece.end + 1 : piece.end + 2])
        typed = self.texts[piece.end - 2] in {":", "."}
        ordinal = typed and self.texts[piece.end : piece.end + 1] == ["second"] and named.isalpha()
        # As in "7:30 day trip".
        trip = self.texts[piece.end - 2] == ":" and self.around.is_unit_of_days(piece.end)
        other = ordinal or trip or self.measures.is_number(piece.end + 1)
        if self.around.is_unit(piece.end) and not other and (counts or wall.days in PRESENT):
            # "On the quarter hour", "tonight, | 20 min"; but "at 3:30 Year 9 assembly", "8:10 second half"
            return True
        counted = self.counts.is_ordinal(piece.end - 1) or isinstance(wall.days, Season)
        if said.preposition == "of" and counted:
            # "Within a minute of the first", "within an hour of the fall"
            return True
        first = piece.start + (self.texts[piece.start] in self.closed.to)
        led = first > 0 and self.texts[first - 1] in self.closed.to
        share = self.measures.is_fraction(piece) and self.measures.measured(piece)
        if share or (led and self._is_ratio(first) and not self.given.puts_off(piece)):
            # "Raise the seat by 3/4", "fill the tub to 3/4 at eight"
            return True
        whole = wall.clock is not None and not wall.clock.shift
        if whole and said.preposition is None and self.measures.named(piece):
            # "Seat 12A"; but "at the gate five past nine"
            return True
        # "Before bed", but "before the bed is made"
        place = wall.part is not None and wall.part.place
        return place and self.texts[piece.end - 2] in self.closed.noun_openers

    def _is_degrees(self, piece: Piece) -> bool:
        """Whether its number is a temperature: "overnight at 4 degrees"."""
        return self.words[piece.end - 1].is_digits and self.around.follower(piece) in self.beside.degrees

    def _is_mixed(self, piece: Piece) -> bool:
        """Whether its two numbers are how something is mixed: "dilute it 1:10"."""
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        colon = ":" in self.texts[piece.start : piece.end] and self.words[piece.start].is_digits
        return colon and not self.beside.mixing.isdisjoint(before)

    def _is_ratio(self, place: int) -> bool:
        """Whether two numbers at a place may be a part of a whole: "3/4"."""
        marks = [text for text in self.texts[place + 1 : place + 4 : 2] if text == "/"]
        return self.words[place].is_digits and self.texts[place + 1 : place + 2] == marks == ["/"]

    def _is_of_noun(self, piece: Piece, said: Said) -> bool:
        """Whether a part of the day describes the noun behind it."""
        if is_of_timed_activity(piece, self.around):
            return True
        if self.around.may_end(piece) or self.around.is_spent(piece):
            return False
        if said.preposition in {None, "to", "of"}:
            # "Switch to night mode"
            return True
        if said.preposition == "for" and self.texts[piece.start] == "for" and piece.end - piece.start == 2:
            # "Sign up for evening classes"
            return True
        # "The kettle for the night staff"
        owned = self.texts[piece.end - 2] in self.closed.noun_openers and piece.end - piece.start > 1
        return owned and piece.start > 0 and self.around.before(piece) not in self.beside.sentence_starts

    def _is_entry(self, piece: Piece, said: Said) -> bool:
        """Whether a part of the day and what is done in it are all that is said: "evening walk"."""
        return said.preposition is None and is_activity_in_part(piece, self.around)

    def _names_noun(self, piece: Piece, said: Said) -> bool:
        """Whether it describes a noun behind one word: "to sunday school", "put on night light"."""
        place, named = piece.end - BOUND, self.around.follower(piece)
        bound = self.texts[place] if piece.start in {place, place + 1} and place > 0 else None
        if bound not in self.lexicon.no_times.before_places or self.around.may_end(piece):
            return False
        if bound in {"at", "by"}:
            # "By night bus", "at night market"; but "call mum at noon, dad at one"
            held = self.lexicon.frames | self.lexicon.travelling | self.lexicon.happening
            part = said.wall.part
            return named in held and part is not None and not part.is_point and said.preposition == bound
        if not self._leads_noun(piece) and not (bound == "to" and has_time(named, self.lexicon)):
            return False
        if bound == "on":
            # "Gym on friday evening" is then.
            switched = self.around.before(piece) in self.lexicon.particles["on"]
            return switched or self.around.is_part(piece.end - 1)
        return not self.given.reschedules(self.texts[max(0, piece.start - NEAR) : piece.start])

    def _leads_noun(self, piece: Piece) -> bool:
        """Whether a word behind it is no order and nothing that happens, and only a time goes on behind."""
        named, behind = self.around.follower(piece), self.texts[piece.end + 1 : piece.end + 2]
        doing = self.lexicon.doing
        ordered = named in self.lexicon.orders | self.lexicon.addressing | doing.errands | doing.putting
        if not named.isalpha() or ordered or has_time(named, self.lexicon) or self.around.may_end(piece):
            return False
        joined = behind == [] or not behind[0].isalpha() or behind[0] in self.lexicon.function_words
        return joined or self.around.timely(piece.end + 1)

    def _is_of_event(self, piece: Piece, wall: Wall) -> bool:
        """Whether it is of a day that an event says: "the morning of the party"."""
        part = wall.part is not None and wall.days is None and wall.clock is None
        return (
            part
            and self.texts[piece.end - 2] in self.closed.the
            and self.around.follower(piece) in self.closed.of
        )

    def _is_listed(self, piece: Piece) -> bool:
        """Whether another day of the week stands beside it: "on mon, wed and fri"."""
        before, behind = piece.start - 1, piece.end
        while before > 0 and self.texts[before] in self.closed.coordinators_of_days:
            before -= 1
        while behind < len(self.texts) and self.texts[behind] in self.closed.coordinators_of_days:
            behind += 1
        return any(place >= 0 and self.around.is_weekday(place) for place in (before, behind))

    def _is_unbound(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether it names a period that no preposition makes a time: "check the year on the coin"."""
        return (
            said.preposition is None and wall.days in PRESENT and self.texts[piece.start] in self.closed.the
        )

    def _is_thing(self, piece: Piece, wall: Wall) -> bool:
        """Whether it is served, described, wished: "with tea", "the first thing you see", "good morning"."""
        if self._ends_in_thing(piece):
            follower = self.around.follower(piece)
            ends = follower in {""} | self.beside.behind_things
            # "First thing water the plants"
            bare = "the" not in self.texts[piece.end - 3 : piece.end]
            if bare and follower == "to" and self.around.before(piece) in self.closed.object_pronouns:
                # "Remind me first thing to water the plants"
                return False
            led = self.around.opens(piece.start) and follower.isalpha()
            led = led and follower not in self.lexicon.function_words
            # "Phone Ann first thing about the bins", "bake it first thing so it's fresh"
            more = follower in self.closed.prepositions_behind_times | self.closed.joints_of_consequence
            return not ends and not (bare and (led or more))
        served = self.is_ambiguous(piece.end - 1) or not self.around.may_end(piece)
        greeting = self.around.before(piece) in self.beside.greeting and (
            wall.clock is None or wall.days is not None
        )
        return greeting or (self.texts[piece.start] == "with" and served)

    def _ends_in_thing(self, piece: Piece) -> bool:
        """Whether its last word may be any thing: "first thing"."""
        return self.texts[piece.end - 1] == THING
