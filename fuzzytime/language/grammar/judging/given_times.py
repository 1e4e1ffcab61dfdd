"""Times of what has one: it is caught then, or gets another: "catch the 7:42", "move my 3 o'clock to 5"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Wall

IN_TIME = frozenset({"in time to", "good time to"})
"""What stands before the verb of something that one is to be in time for."""


class GivenTimes(Around):
    """What stands around a time that something has, or is given."""

    def is_put_off(self, piece: Piece) -> bool:
        """Whether it is what has a time, and is given another: "move the 3 pm to five"."""
        owner = piece.start if self.texts[piece.start] in self.closed.noun_openers else piece.start - 1
        owning = owner > 0 and (self.texts[owner] in self.closed.noun_openers or self.around.is_owned(piece))
        return owning and self.texts[owner - 1] in self.lexicon.rescheduling

    def is_caught(self, piece: Piece) -> bool:
        """Whether it is what is caught, called by its time: "catch the 7:42", "take the 9:15 to York".

        So it is where somebody is met off it: "meet gran off the 3.20 bus". "Leave in time to catch the 7:42"
        is before that.
        """
        owner = piece.start - 1
        if " ".join(self.texts[max(0, owner - 4) : max(0, owner - 1)]) in IN_TIME:
            return False
        behind = self.around.follower(piece)
        ends = not behind[:1].isalnum() or behind in self.beside.bound_for | self.lexicon.travelling
        led = self.texts[owner - 1] if owner > 0 else ""
        met = led in self.beside.getting_off and not self.lexicon.doing.meeting.isdisjoint(self.texts[:owner])
        return (led in self.lexicon.catching or met) and (ends or self.around.timely(piece.end))

    def puts_off(self, piece: Piece) -> bool:
        """Whether it is the new time of what has one: "move my 3 o'clock to 5", "change the alarm to 7"."""
        place = piece.start - 1
        if place >= 0 and (self.texts[place],) in self.lexicon.conversation["rescheduled"]:
            # "The meeting has been moved to six"
            return True
        while place > 0 and self.texts[place] in self.beside.put_off:
            place -= 1
        begin = place
        while begin > 0 and (
            self.around.words[begin].is_digits
            or self.texts[begin] in self.beside.of_clocks | self.lexicon.numbers.keys()
        ):
            begin -= 1
        clock = begin < place and self.texts[begin] in self.closed.noun_openers
        named = (
            clock
            or self._moves_event(place)
            or self.texts[place] in self.lexicon.events
            or self.around.is_part(place)
        )
        return named and bool(self.lexicon.rescheduling & set(self.texts[max(0, begin - NEAR) : begin + 1]))

    def _moves_event(self, place: int) -> bool:
        """Whether "it" at a place is what happens and gets a time: "lunch is at one, move | it to two"."""
        verb = self.texts[place - 1] if place else ""
        moved = verb in self.lexicon.moving and self.texts[place] in self.closed.singular_anaphors
        events = self.lexicon.events | self.lexicon.happening | self.lexicon.taken
        return moved and not events.isdisjoint(self.texts[: place - 1])

    def gets_month(self, piece: Piece, wall: Wall) -> bool:
        """Whether it is the month in which something will be instead: "postpone the trip to august"."""
        month = isinstance(wall.days, Fields) and wall.days.month is not None and wall.days.day is None
        alone = wall.clock is None and wall.part is None
        return month and alone and self.reschedules(self.texts[max(0, piece.start - NEAR) : piece.start])

    def changes_length(self, piece: Piece) -> bool:
        """Whether what goes on for so long gets another length: "change the timer from 10 to 15 minutes"."""
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        return before[-1:] != [] and before[-1] in self.lexicon.lasting and self.reschedules(before)

    def reschedules(self, texts: Sequence[str]) -> bool:
        """Whether one of some words gives something another time."""
        return any(not self.lexicon.rescheduling.isdisjoint(_as_order(text)) for text in texts)


def _as_order(text: str) -> tuple[str, ...]:
    """Give a word, and the verb that it may be of: "the exam moves to may", "has been moved to may"."""
    return text, *(text.removesuffix(ending) for ending in ("s", "d", "ed"))
