"""Figures that look like times and are none: values, ratios, odds, sizes, decades, codes, years of things."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Range, Wall
from fuzzytime.requirement import Unit

BEFORE = 3
"""Words between a verb and the value of what it sets, at most."""

ALWAYS = ["24", "/", "7"]
"""What is always there: "call 24/7 support", where it says of what."""

OUT_OF = ["out", "of"]
"""What stands between a part and its whole."""

DECADES = frozenset(map(str, range(20, 100, 10)))
"""Numbers before a glued "s" that are years: "80s music"."""


SCORE = 3
"""Words of a score: its two numbers, and what joins them."""

METRE = 4
"""Words of a metre: "in", its two numbers and the slash."""

NOTE_VALUES = frozenset({"2", "4", "8", "16"})
"""What is counted in a metre: halves, quarters, eighths."""


class Figures(Standing):
    """What stands around figures, and whether it makes them something else than a time."""

    def hold(self, piece: Piece) -> bool:
        """Whether a reading is of such a figure."""
        return (
            self._is_value(piece)
            or self._is_odds(piece)
            or self._is_size(piece)
            or self._counts_units(piece)
            or self._is_share(piece)
            or self._is_of_decade(piece)
            or self._is_code(piece)
            or self._is_year_of_thing(piece)
            or self._is_metre(piece)
            or self._is_rate(piece)
            or self._is_extent(piece)
            or (self.texts[piece.start : piece.end] == ALWAYS and not self.around.may_end(piece))
        )

    def _is_value(self, piece: Piece) -> bool:
        """Whether something is set to it: "price it at 8.45", "upgrade from 3.11 to 3.12"."""
        said, kinds = piece.value, self.lexicon.no_times
        wall = said.time.first if isinstance(said.time, Range) else said.time
        if not isinstance(wall, Wall) or wall.clock is None or wall.clock.grain is not Unit.MINUTE:
            return False
        digits = any(self.words[place].is_digits for place in range(piece.start, piece.end))
        marked = any(":" in text or "." in text for text in self.texts[piece.start : piece.end])
        led = {"to", "from"}.isdisjoint((self.texts[piece.start], self.around.before(piece)))
        if not (digits and marked) or (wall.days is not None and led):
            return False
        if self.around.follower(piece) in kinds.scales:
            return True
        first, before = self.texts[piece.start], self.around.before(piece)
        place = piece.start - 1
        if first not in {"to", "at", "from"}:
            first, before, place = before, self.texts[place - 1] if place else "", place - 1
        verbs = {*self.texts[max(0, place - BEFORE) : place + 1]}
        if first == "from":
            return self._is_new_value(piece, place)
        if first == "to":
            return before in kinds.set_to or before in kinds.renewing or self._is_new_value(piece, place)
        held = before in kinds.set_to and not kinds.holding.isdisjoint(verbs)
        valued = any(self.texts[p] in kinds.valuing and self.around.opens(p) for p in range(place))
        return first == "at" and (held or valued)

    def _is_new_value(self, piece: Piece, place: int) -> bool:
        """Whether it is the shape of a picture, a scale or a version: "set the screen to 16:10"."""
        kinds = self.lexicon.no_times
        verbs = (p for p in range(place + 1) if self.texts[p] in kinds.versioning)
        if any(map(self.around.opens, verbs)) and self.texts[place] not in self.beside.timed_things:
            return True
        shown = "".join(text for text in self.texts[piece.start : piece.end] if not text.isalpha())
        return self.texts[place] in kinds.screens and shown in kinds.shapes

    def _is_odds(self, piece: Piece) -> bool:
        """Whether something is bet on at it: "bet at 5 to 1"; but "place the bet at ten to one".

        Or it is the score: "they beat us 3 to 1".
        """
        *_, before, verb = ("", "", *self.texts[: piece.start])
        ends = self.measures.is_number(piece.start) and self.measures.is_number(piece.end - 1)
        if (
            ends
            and piece.end - piece.start == SCORE
            and not self.lexicon.no_times.betting.isdisjoint((before, verb))
        ):
            return True
        if self.texts[piece.start] != "at" or "to" not in self.texts[piece.start + 1 : piece.end]:
            return False
        bets = (p for p in range(piece.start) if self.texts[p] in self.lexicon.no_times.betting)
        return any(map(self.around.opens, bets))

    def _is_size(self, piece: Piece) -> bool:
        """Whether it is a side of what is printed or cut: "print it at 5 by 7"."""
        joint = next((p for p in (piece.end, piece.start) if self.texts[p : p + 1] == ["by"]), 0)
        if joint < 2 or self.texts[joint - 2] != "at" or piece.end > joint + 2:
            return False
        sides = self.measures.is_number(joint - 1) and self.measures.is_number(joint + 1)
        verbs = (p for p in range(joint - 2) if self.texts[p] in self.lexicon.no_times.sizing)
        return sides and any(map(self.around.opens, verbs))

    def _counts_units(self, piece: Piece) -> bool:
        """Whether it is the first of two numbers of one measure: "at 4 and 8 inches".

        What has a measure of its own is at an hour: "5 ml at 8 and 10 ml at 4".
        """
        joint, second = piece.end, piece.end + 1
        if self.around.before(piece) in self.lexicon.no_times.measured_in:
            return False
        if not self.measures.is_number(joint - 1) or self.texts[joint : joint + 1] not in (["and"], ["or"]):
            return False
        units = self.texts[second + 1 : second + 2]
        return self.measures.is_number(second) and not self.lexicon.no_times.measured_in.isdisjoint(units)

    def _is_share(self, piece: Piece) -> bool:
        """Whether it is so many of so many: "3 out of 4", "page 2 of 4 | tomorrow"."""
        of = piece.start - (self.texts[piece.start] not in self.closed.of)
        if of > 0 and self.texts[of] in self.closed.of and self.measures.is_number(of + 1):
            return self.texts[of - 1] == "out" or self.measures.is_number(of - 1)
        numbers = map(self.measures.is_number, (piece.end - 1, piece.end + len(OUT_OF)))
        return self.texts[piece.end :][: len(OUT_OF)] == OUT_OF and all(numbers)

    def _is_of_decade(self, piece: Piece) -> bool:
        """Whether its seconds are years: "in the 70s style", "people in their 40s", "over 60s only"."""
        last = max((p for p in range(piece.start, piece.end) if self.texts[p] == "s"), default=0)
        if not isinstance(piece.value.time, Duration | Wall | Offset) or last < 2:
            return False
        number = last - 1
        glued = self.words[last].glued and self.words[number].is_digits
        before = self.texts[number - 1]
        aged = before in self.lexicon.no_times.around_ages
        alone = number == 1 and last + 1 < len(self.words)
        # "No under 18s"
        aged = aged and (alone or self.texts[number - 2] in {"no", *self.closed.noun_openers})
        owned = before in self.closed.possessives | {"the", "early", "late"} and self.texts[number] in DECADES
        return glued and (aged or owned)

    def _is_code(self, piece: Piece) -> bool:
        """Whether letters and digits in one are what opens something: "the password is may2020"."""
        if piece.value.preposition is not None or not self._is_glued(piece):
            return False
        named = piece.start - 1 - (self.around.before(piece) in self.closed.third_person_be | {":"})
        return named >= 0 and self.texts[named] in self.lexicon.no_times.codes

    def _is_glued(self, piece: Piece) -> bool:
        """Whether it is one word of letters, and digits behind them."""
        inside = self.words[piece.start : piece.end]
        behind = inside[1:]
        return inside[0].is_letters and bool(behind) and all(w.is_digits and w.glued for w in behind)

    def _is_year_of_thing(self, piece: Piece) -> bool:
        """Whether it is the year that a thing is from, or of: "films from 2003", "the class of 2005"."""
        days = piece.value.wall.days
        if not isinstance(days, Fields) or days.year is None or days != Fields(year=days.year):
            return False
        joint = piece.start - (self.texts[piece.start] not in self.beside.belonging)
        thing = self.texts[joint - 1] if joint > 0 else ""
        named = thing.isalpha() and thing not in self.lexicon.function_words
        past = days.year < self.lexicon.policy.planned_from
        return past and self.texts[joint] in self.beside.belonging and named

    def _is_metre(self, piece: Piece) -> bool:
        """Whether it is a metre: "play it in 3/4", "count it in 6/8"; a date has "on"."""
        *_, first, slash, last = ("", "", "", *self.texts[piece.start : piece.end])
        written = self.texts[piece.start] == "in" and piece.end - piece.start == METRE
        return written and first.isdecimal() and slash == "/" and last in NOTE_VALUES

    def _is_rate(self, piece: Piece) -> bool:
        """Whether a number is so many for each: "lend it at 3 per cent"; but "at 3 per our chat"."""
        *behind, _ = (*self.texts[piece.end : piece.end + 2], "")
        each = behind[:1] == ["per"] and behind[1:] != [] and behind[1] not in self.closed.noun_openers
        return each and self.measures.is_number(piece.end - 1)

    def _is_extent(self, piece: Piece) -> bool:
        """Whether it is so many metres: "a 12 m long rope"."""
        extents = self.lexicon.no_times.extents
        places = (p for p in range(piece.start, piece.end) if self.texts[p] == "m")
        return any(not extents.isdisjoint(self.texts[place + 1 : place + 2]) for place in places)
