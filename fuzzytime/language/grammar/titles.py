"""Whether a reading is of a name: what is played or watched, a feast, one on a day that is not known."""

from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.standing import Standing
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import TimeWord, Wall

FEAST_WORDS = 3
"""Words of a feast's name before another that may be a time, at most."""

BANK_HOLIDAY = ["bank", "holiday"]
"""Words before a weekday on a date that is not known here."""


class Titles(Standing):
    """The names around readings, and whether they hold one."""

    def hold(self, piece: Piece) -> bool:
        """Whether a reading is of a name."""
        return (
            self._is_played(piece)
            or self._is_of_its_year(piece)
            or self._is_of_feast(piece)
            or self._is_of_other_calendar(piece)
            or self.around.is_title(piece)
        )

    def _is_played(self, piece: Piece) -> bool:
        """Whether it is of the title of what is played: "play yesterday"; but "what can we play tomorrow"."""
        if not self._plays:
            return False
        time = piece.value.time
        numbered = any(map(self.measures.is_number, range(piece.start, piece.end)))
        clocked = isinstance(time, Wall) and time.clock is not None and (numbered or time.days is not None)
        if piece.value.preposition not in {None, "of"} or clocked or isinstance(time, TimeWord):
            return False
        verb = piece.start - 1
        # "Play blue monday by new order"
        named = self.around.follower(piece) == "by" and not self.around.timely(piece.end + 1)
        named = named and not self.around.is_day_from_now(piece.start)
        while verb > 0 and (named or self._is_titular(verb)) and self.texts[verb] not in self.lexicon.playing:
            verb -= 1
        return verb >= 0 and self.texts[verb] in self.lexicon.playing and self.around.opens(verb)

    @cached_property
    def _plays(self) -> bool:
        """Whether anything is played in the text."""
        return not self.lexicon.playing.isdisjoint(self.texts)

    def _is_of_its_year(self, piece: Piece) -> bool:
        """Whether it is the year that what is played is from: "play a song from 1975"."""
        if not self._plays:
            return False
        days = piece.value.time.days if isinstance(piece.value.time, Wall) else None
        year = isinstance(days, Fields) and days == Fields(year=days.year) and piece.value.preposition != "in"
        played = (place for place in range(piece.start) if self.texts[place] in self.lexicon.playing)
        return year and any(map(self.around.opens, played))

    def _is_titular(self, place: int) -> bool:
        """Whether a word may stand before a time in what is called after it: "last christmas"."""
        deictic = any(one.category == "deictic" for one in self.around.pieces(place))
        timely = self.around.timely(place) or self.measures.is_number(place)
        return timely or deictic or self.texts[place] in self.closed.sure_noun_openers

    def _is_of_other_calendar(self, piece: Piece) -> bool:
        """Whether it is a feast on a day that is not known here: "chinese new year"."""
        for place in range(piece.start, piece.end):
            if self._is_known_feast(place):
                continue
            other = place > 0 and self.texts[place - 1] in self.lexicon.other_calendars
            if other and any(one.category == "feast" for one in self.around.pieces(place)):
                return True
            calendar, named = ("", "", *self.texts[:place])[-2:]
            named_there = calendar in self.lexicon.other_calendars and named in self.beside.holy
            if named_there and self.around.is_weekday(place):
                # "Orthodox great friday"
                return True
            if self.texts[max(0, place - 2) : place] == BANK_HOLIDAY and self.around.is_weekday(place):
                # "On bank holiday monday"
                return True
        return False

    def _is_known_feast(self, place: int) -> bool:
        """Whether it is a later word of a feast's name, whose calendar is known: "orthodox easter"."""
        begins = range(max(0, place - FEAST_WORDS), place)
        found = (one for begin in begins for one in self.around.pieces(begin))
        return any(one.category == "feast" and one.end > place for one in found)

    def _is_of_feast(self, piece: Piece) -> bool:
        """Whether it begins within the name of a feast: "black friday deals"."""
        found = (
            one
            for begin in range(max(0, piece.start - FEAST_WORDS), piece.start)
            for one in self.around.pieces(begin)
        )
        # "Clean monday" may be an order.
        sure = (one for one in found if one.category == "feast" and not one.value.doubtful)
        return any(one.end > piece.start for one in sure)
