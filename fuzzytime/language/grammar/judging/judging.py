"""Whether what stands around a reading makes it doubtful: numbers that count, words with another meaning."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.beside.new_times import tells_new_time
from fuzzytime.language.grammar.judging.borders import Borders
from fuzzytime.language.grammar.judging.further import Further
from fuzzytime.language.grammar.judging.lengths import Lengths
from fuzzytime.language.grammar.judging.look_alikes.things_of_times import counts_from_thing
from fuzzytime.language.grammar.judging.ranges import Ranges
from fuzzytime.language.grammar.judging.repeats import Repeats
from fuzzytime.language.grammar.judging.walls.bare_hours import QUARTERS
from fuzzytime.language.grammar.judging.walls.dated_entries import HALF, HEADS_ALONE, ends_entry, heads_list
from fuzzytime.language.grammar.judging.walls.walls import Walls
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.grammar.surroundings.surroundings import Around, Surroundings
from fuzzytime.language.grammar.understood.due import is_due
from fuzzytime.language.grammar.understood.lent import Lent, is_left_for, lacks_unit
from fuzzytime.language.meaning.expressions import (
    Coming,
    Duration,
    HourMark,
    Offset,
    Range,
    Repeat,
    Said,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.joined.distances import INTO, LAST
from fuzzytime.language.meaning.times_of_day import Clock

OF_HOURS = frozenset(
    {"at", "by", "before", "after", "until", "around", "from", "not before", "no later than"}
)
"""Prepositions of minutes past an hour that is not said: "at half past"."""

STOPS = frozenset({"", ".", "!", ";"})
LINES = STOPS | {"\n", "-", "*"}
"""What stands before the first word of a sentence or an entry."""

ENDING = {"then": STOPS, "in between": STOPS | {",", "and"}}
"""Time words that end what is said, and what may stand behind: but "put it in between the pages"."""

ENTRY = 3
"""Words of ", school gym", behind which "after" ends an entry of a list."""

LONGEST_CASE = 3
"""Words of "unless it rains", behind which no order may stand."""

ANOTHER = "elliptic.another_alone"
"""The rule of a number that goes on with a length: "then another ten"."""


class Judge(Around):
    """What stands around a reading, and whether it makes it doubtful."""

    def __init__(self, around: Surroundings) -> None:
        super().__init__(around)
        self.borders, self.walls, self.lent = Borders(self.around), Walls(self.around), Lent(self.around)
        self.ranges, self.lengths = Ranges(self.around), Lengths(self.around)
        self.repeats, self.further = Repeats(self.around), Further(self.around)

    def accepts(self, piece: Piece) -> bool:
        """Whether a reading is a time here."""
        said: Said = piece.value
        if self.borders.refuse(piece) or self.measures.is_level(piece) or self.measures.says_amount(piece):
            return False
        time = said.time
        if piece.rule in {ANOTHER, *HEADS_ALONE}:
            return self._goes_on(piece)
        if counts_from_thing(piece, self.around) or self.ranges.heads_meal(piece, time):
            return False
        if self._is_whole(piece):
            order = self.walls.may_be_order(piece, said)
            return not lacks_unit(said) and not order and self._accepts_alone(said)
        if lacks_unit(said):
            return self.lent.accept(piece, said)
        number = isinstance(time, Wall) and (time.bare or _is_pair(time.clock))
        number = number or (isinstance(time, Repeat) and self.repeats.is_number_for(piece))
        if (
            number
            and said.preposition is None
            and is_left_for(self.texts, piece.start, piece.end, self.lexicon)
        ):
            return True
        counts = said.preposition == "for" and number and not self._tells_time(piece)
        if counts or self.lent.seats(piece, time):
            # "Cook for eight", "sell it for 5.50"
            return False
        share = isinstance(time, Duration) and time.bare_end and self._is_share(piece)
        if said.preposition == "in" and share:
            return False
        if said.preposition == "for" and self._is_distance(piece) and not self._appoints(piece):
            # "Write for two hours before noon" says how long, and a bound.
            return False
        if isinstance(time, Duration):
            return self.lengths.accept(piece, said, time)
        if isinstance(time, Wall):
            return self.walls.accept(piece, said, time)
        return self._accepts_other(piece, said)

    def _goes_on(self, piece: Piece) -> bool:
        """Whether it goes on with a length, or heads a list: "for 20 minutes, then another ten", "AM: …"."""
        if piece.rule in HEADS_ALONE:
            ends = piece.rule == HALF and ends_entry(self.words, piece.start, piece.end, self.lexicon)
            return ends or heads_list(self.words, piece.start, piece.end)
        lent = any(self.around.is_unit(place) for place in range(piece.start))
        # "Fry it for ten minutes, …, cook another five"
        goes_on = self.lexicon.doing.resting | self.lexicon.timing
        step = self.around.before(piece) in self.beside.before_another | goes_on
        return lent and step and self.around.follower(piece) in self.beside.behind_another | {""}

    def _tells_time(self, piece: Piece) -> bool:
        """Whether "for" and a number are a time: "rotate for two seconds and wait for one"."""
        lent = any(self.around.is_unit(place) for place in range(piece.start))
        appointed = self._appoints(piece) and not self._is_behind_hour(piece)
        clock, costing = piece.value.wall.clock, self.lexicon.no_times.costing
        # "Order a cab for 7.15"; but "get apples for 2.50", "sell it for 5.30"
        quarter = clock is not None and _is_pair(clock) and clock.minute in QUARTERS
        told = lent or appointed or (quarter and costing.isdisjoint(self.texts))
        return told or self.lent.times(piece) or is_due(self.texts, piece.start, self.lexicon)

    def _accepts_other(self, piece: Piece, said: Said) -> bool:
        if said.preposition == INTO:
            # "Set the timer at 20 minutes", "at 8 and 20 minutes later"
            set_to = self.around.before(piece) in self.lexicon.appointing
            return not set_to and self.around.follower(piece) in ({""} | self.beside.behind_gone_on)
        time = said.time
        between = self.around.before(piece) in {"between", "from"}
        if isinstance(time, TimeWord) and (between or self._is_more(piece)):
            # "Between now and the concert"
            return False
        ends = ENDING.get(" ".join(self.texts[piece.start : piece.end]))
        if isinstance(time, TimeWord) and ends is not None:
            # "Call me then"; "then call me" is a step behind another. But "with a minute's rest in between"
            gap = "," in ends and not self.lexicon.spacing["beside"].isdisjoint(self.texts[: piece.start])
            ended = self.around.follower(piece) in ends or self._is_qualified(piece)
            return piece.start > 0 and not gap and ended
        if isinstance(time, Offset) and self.texts[piece.end - 1] == "in":
            # "Ten minutes in, add the garlic", "hand them out ten minutes in and collect them"
            return self.around.follower(piece) in {"", ",", ".", "and"}
        if self.texts[piece.end - 1] in self.beside.before_or_after and isinstance(time, (Offset, TimeWord)):
            return self._ends_order(piece, time)
        if isinstance(time, Range):
            return self.ranges.accept(piece, said, time)
        if isinstance(time, HourMark) and said.preposition == "by":
            # "Pay him by the half hour"
            return self.lexicon.no_times.costing.isdisjoint(self.texts[: piece.start])
        if isinstance(time, HourMark) and time.open:
            return self._is_of_unsaid_hour(piece, said)
        if self._is_past(piece, said):
            return False
        if isinstance(time, Repeat) and (self.ranges.are_amounts(piece) or not self.repeats.accept(piece)):
            return False
        if isinstance(time, (Repeat, TimeWord)):
            return said.preposition is not None or not self.around.describes(piece)
        return True

    def _ends_order(self, piece: Piece, time: Offset | TimeWord) -> bool:
        """Whether "after" ends what is said: "call me ten minutes after"; but "after lunch call me"."""
        looks = self.around.before(piece) in self.beside.looking_after and isinstance(time, TimeWord)
        # "Put the pie in ten minutes before", "bring it in after"; but "the night before"
        behind_particle = self.around.before(piece) in self.lexicon.particles
        apart = behind_particle or not self.around.timely(piece.start - 1)
        # "Mow the front before and the back after"; but "before and after lunch"
        behind = self.texts[piece.end : piece.end + 2]
        joined = behind[:1] == ["and"] and behind != ["and", "after"]
        # "…, muck out straight after, and let them out"
        joined = joined or (behind[:1] == [","] and behind[1:] in (["and"], ["then"], ["but"]))
        # "Work 9-5, gym after, dinner at 8"
        joined = joined or (
            behind[:1] == [","] and "," in self.texts[max(0, piece.start - ENTRY) : piece.start]
        )
        follower, before = self.around.follower(piece), self.around.before(piece)
        if isinstance(time, Offset) and follower in {":", ","} and before in LINES:
            # As in "two days before: make the sauce", "ten minutes after, turn it".
            return True
        # "A week before, a day before and an hour before the exam"
        joined = joined or (follower in self.closed.additions and self._is_distance_at(piece.end + 1))
        ends = joined or follower in STOPS
        return piece.start > 0 and not looks and apart and ends

    def _is_distance_at(self, start: int) -> bool:
        """Whether so long before or after something is said at a place."""
        sides = (p for p, text in enumerate(self.texts) if text in self.beside.before_or_after)
        side = next((place for place in sides if place > start), None)
        return side is not None and side <= start + ENTRY and self.around.is_unit(side - 1)

    def _is_of_unsaid_hour(self, piece: Piece, said: Said) -> bool:
        """Whether minutes of whichever hour are a time: not "walk at ten to the gate"."""
        follower = self.around.follower(piece)
        # "Take the cake out ten past"
        ends = follower in {""} | self.beside.polite_ends and self.around.before(piece).isalpha()
        sure = said.preposition in OF_HOURS or bool(said.hedges) or ends
        counts = follower in self.closed.noun_openers or self.measures.is_number(piece.end)
        return sure and not counts and self.around.may_end(piece)

    def _is_qualified(self, piece: Piece) -> bool:
        """Whether no order is behind "then", but another time, or a case: "then or later", "if it's dry"."""
        closed, before, behind = self.around.closed, self.around.before(piece), self.texts[piece.end :]
        if not before[:1].isalnum() or before in closed.additions:
            return False
        stop = next((place for place, text in enumerate(behind) if text in STOPS), len(behind))
        case = longest_match(self.words, piece.end, self.lexicon.clauses) if behind else None
        short = case is not None and self.lexicon.clauses[case] == "if" and stop <= LONGEST_CASE
        return short or not closed.alternatives.isdisjoint(behind[:1])

    def _is_more(self, piece: Piece) -> bool:
        """Whether a time word is part of more: of a clause, or of which time, or way, is meant."""
        to = self.texts[piece.end - 1] in self.beside.straight_to
        if to and self.around.follower(piece) in self.beside.whereabouts | self.beside.away_from:
            # "Bake it directly from the fridge"
            return True
        within = self._begins_clause(piece) or self._is_now_and_again(piece) or self._says_which(piece)
        return within or tells_new_time(piece, self.around)

    def _says_which(self, piece: Piece) -> bool:
        """Whether words behind say which time is meant, or each of what: "at the same time as the rice"."""
        said, follower = " ".join(self.texts[piece.start : piece.end]), self.around.follower(piece)
        if said in self.beside.turns:
            # "Check her pulse each time"; but "each time you turn her", "five minutes each time"
            behind = piece.start == 0 or self.around.timely(piece.start - 1)
            return behind or follower not in {"", ".", "!", ";", ","}
        same = any(said.endswith(words) for words in self.beside.same_time)
        return same and follower in self.beside.behind_same_time

    def _is_past(self, piece: Piece, said: Said) -> bool:
        """Whether it is the time just gone: "what was said in the last hour"; not "in the last hour of X"."""
        if said.preposition == LAST:
            return (
                said.lasting is None and piece.start > 0 and self.around.follower(piece) not in self.closed.of
            )
        return isinstance(said.time, Coming) and said.time.direction < 0

    def _is_now_and_again(self, piece: Piece) -> bool:
        """Whether "now and again" is two times: "now and again in six hours"."""
        behind = self.texts[piece.end + 1 : piece.end + 2]
        counted = self.measures.is_number(piece.end + 1) or behind in (["a"], ["an"], ["half"], ["about"])
        again = self.texts[piece.end - 1] == "again" and self.around.follower(piece) in {"in", "at", "after"}
        return again and counted

    def _begins_clause(self, piece: Piece) -> bool:
        """Whether it begins a clause: "now that it is hot", "whenever it rains"; not "do it whenever"."""
        marker = longest_match(self.words, piece.start, self.lexicon.clauses)
        if marker is None or len(marker) < piece.end - piece.start:
            return False
        if " ".join(marker) in self.beside.at_any_time:
            # "Any time the phone rings"; but "any time call mum"
            return self.around.follower(piece) in self.closed.condition_openers
        return len(marker) > piece.end - piece.start or self.around.follower(piece)[:1].isalnum()

    def _is_distance(self, piece: Piece) -> bool:
        """Whether it is so long before or after another time."""
        time = piece.value.time
        if isinstance(time, Wall) and time.clock is not None and time.clock.shift:
            return not self.beside.before_or_after.isdisjoint(self.texts[piece.start : piece.end])
        return isinstance(time, Offset) and time.anchor is not None

    def _appoints(self, piece: Piece) -> bool:
        """Whether words before make "for" say when: "an alarm for two hours before noon"."""
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        return bool(self.lexicon.appointing & set(before))

    def _is_behind_hour(self, piece: Piece) -> bool:
        """Whether a time of day stands right before it: "book a table at eight for two"."""
        *_, bound, hour = ("", "", *self.texts[: piece.start])
        told = bound == "at" and self.measures.is_number(piece.start - 1)
        return told or hour in self.beside.of_hours

    def _is_share(self, piece: Piece) -> bool:
        """Whether it is of how many: "one in five"; but "move to station 4 in five"."""
        named = self.texts[max(0, piece.start - 2) : piece.start - 1]
        numbered = not (self.lexicon.machines | self.lexicon.measure_nouns).isdisjoint(named)
        return self.measures.is_number(piece.start - 1) and not numbered

    def _is_whole(self, piece: Piece) -> bool:
        """Whether it is all that is said."""
        outside = [*self.texts[: piece.start], *self.texts[piece.end :]]
        return all(text in self.beside.polite_ends for text in outside)

    def _accepts_alone(self, said: Said) -> bool:
        time = said.time
        if isinstance(time, Wall) and time.clock is not None and time.clock.pair and said.preposition is None:
            if time.clock.shift:
                # "Twenty to four"
                return True
            return time.clock.hour >= self.lexicon.policy.bare_pair_from or time.clock.minute in {15, 30, 45}
        return True


def _is_pair(clock: Clock | None) -> bool:
    """Whether two numbers are an hour and its minutes, so that they may be none: not "ten to nine"."""
    return clock is not None and clock.pair and not clock.shift
