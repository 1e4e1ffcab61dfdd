"""Events that a time names: "before the 3 pm call", "after the night shift"; that is no bound at three."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.expressions import Offset, Range, Said, Wall

BESIDE = 2
"""Words from an article to what is behind its noun: "a spa morning"."""

GIVEN = (["for"], ["to"], ["at"])
"""What stands between a part of the day and the time that it gets."""


class Events(Around):
    """The events of a text that have a time in their name."""

    def named(self, piece: Piece) -> bool:
        """Whether a noun behind it is what is meant: "before the 3 pm call", "after my 9 am class"."""
        said: Said = piece.value
        ordinal = (
            self.texts[piece.end - 2 : piece.end - 1] == ["the"]
            and self.texts[piece.end - 1] in self.lexicon.ordinals
        )
        if ordinal and piece.end < len(self.texts) and not self.around.may_end(piece):
            # "After the first one is done", "a day before the second coat"
            return True
        counted = isinstance(said.time, Offset)
        if counted and self.around.follower(piece) in self.beside.of_hours:
            # "Two hours before the 6 am flight"
            return True
        place = said.time.anchor if isinstance(said.time, Offset) else said.time
        if isinstance(place, Wall) and place.part is not None and place.part.place:
            follower, before = self.around.follower(piece), "before" in self.texts[piece.start : piece.end]
            *_, led, the, _ = ("", "", "", *self.texts[: piece.start])
            evening = the == "the" and led != "in" and self.around.is_part(piece.start - 1)
            if before and (evening or follower in self.closed.present_be):
                # "The night before school", "before school is over"
                return True
            if isinstance(said.time, Offset) and not self.around.may_end(piece):
                # "Ten minutes before school gates open"; but "… before school starts"
                return follower not in self.lexicon.doing.timed
        if self._is_in_name(piece) or self._ends_name(piece) or self._is_given_time(piece):
            return True
        wall = said.time.anchor if isinstance(said.time, Offset) else said.time
        if not isinstance(wall, Wall) or wall.clock is None or self.around.may_end(piece):
            return False
        marked = self._is_marked(piece)
        owning = (
            place
            for place in range(piece.start + 1, piece.end - 1)
            if self.texts[place] in self.closed.noun_openers
        )
        return (counted or marked) and any(self.measures.is_number(place + 1) for place in owning)

    def _is_marked(self, piece: Piece) -> bool:
        """Whether it begins like a clause: "after", "before", "during"."""
        return longest_match(self.words, piece.start, self.lexicon.clauses) is not None

    def _ends_name(self, piece: Piece) -> bool:
        """Whether it begins with the last word of what happens: "date night on friday", "good night at 8"."""
        first = piece.start
        if not self.around.ends_name(first):
            return False
        again = not self.beside.repeating.isdisjoint(self.texts[first + 1 : first + 2])
        if not again and not isinstance(piece.value.time, (Wall, Range)):
            return False
        # "Wash up evening at six"
        acted = self.lexicon.alone | self.lexicon.intransitive | self.lexicon.addressing
        led = self.texts[max(0, first - BESIDE) : first - 1]
        # "Parents evening tues 23 june"
        bound = self.around.follower(piece) in self.closed.prepositions_of_points | {"on"}
        bound = bound or self.around.is_day(piece.end)
        named = piece.end - first > 1 or bound or not self.closed.noun_openers.isdisjoint(led)
        return named and self.around.before(piece) not in acted

    def _is_given_time(self, piece: Piece) -> bool:
        """Whether it begins with a part of the day that gets a time: "set bedtime for eight"."""
        if self.texts[piece.start + 1 : piece.start + 2] not in GIVEN:
            return False
        before = self.around.before(piece)
        given = before in self.lexicon.moving or before in self.lexicon.appointing
        # "Meeting noon to 2pm" is until then.
        parts = (one.value for one in self.around.pieces(piece.start) if one.category == "part")
        return given and any(not part.is_point for part in parts)

    def _is_in_name(self, piece: Piece) -> bool:
        """Whether its part of the day is in the name of what happens then: "after the night shift, sleep"."""
        wall, follower = piece.value.wall, self.around.follower(piece)
        part = wall.part is not None and wall.clock is None
        led = self.texts[piece.end - 2 : piece.end - 1]
        if not part or led == [] or led[0] not in self.closed.noun_openers or not self._is_marked(piece):
            return False
        if (
            follower
            in self.lexicon.happening | self.lexicon.taken | self.lexicon.frames | self.lexicon.lasting
        ):
            return True
        # "After the evening meal, wash up"; but "before the evening cook, clean and rest"
        alone = self.texts[piece.end + 1 : piece.end + 2] == [","] and follower.isalpha()
        orders = self.lexicon.alone | self.lexicon.chores | self.lexicon.function_words
        return alone and follower not in orders
