"""What looks like a time and is none: streets, the sun, ages, metres, arithmetic, persons, idioms."""

from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.look_alikes.figures import Figures
from fuzzytime.language.grammar.judging.look_alikes.proper_names import (
    has_surname,
    is_called_like_day,
    is_event_of_weekday,
    is_numbered_name,
    is_typed_name,
    is_whom,
)
from fuzzytime.language.grammar.judging.look_alikes.spoken_of import is_spoken_of
from fuzzytime.language.grammar.judging.look_alikes.things_of_times import ENDS, is_of_street
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.meaning.expressions import Duration, Repeat, Wall, wall_of
from fuzzytime.requirement import Unit

FAR = 6
"""Words between a verb and how far something goes, at most, with those of its number."""


class NoTime(Standing):
    """What stands around readings that only look like a time."""

    @cached_property
    def figures(self) -> Figures:
        """What stands around figures."""
        return Figures(self.around)

    def hold(self, piece: Piece) -> bool:
        """Whether a reading is none."""
        return (
            self._is_of_idiom(piece)
            or self._is_of_sky(piece)
            or is_of_street(piece, self.around)
            or is_typed_name(piece, self.around)
            or is_numbered_name(piece, self.around)
            or is_spoken_of(piece, self.around)
            or has_surname(piece, self.around)
            or is_called_like_day(piece, self.around)
            or is_event_of_weekday(piece, self.around)
            or self._is_somebody(piece)
            or self._is_bought(piece)
            or self._is_told_of(piece)
            or self._is_in_sunshine(piece)
            or self._is_age(piece)
            or self.figures.hold(piece)
            or self._is_far(piece)
            or self._is_reckoned(piece)
            or self._is_of_period(piece)
            or self._is_adjective(piece)
            or self.around.names_person(piece.start)
            or self._is_person(piece)
            or self._is_of_played(piece)
            or self._ends_in_article(piece)
        )

    def _is_of_sky(self, piece: Piece) -> bool:
        """Whether its last word is what the sky does something with: "after night falls"."""
        behind = " ".join(self.texts[piece.end - 1 : piece.end + 2])
        falls = self.around.follower(piece).isalpha()
        return falls and any(behind.startswith(form) for forms in self.lexicon.sky.values() for form in forms)

    def _is_of_idiom(self, piece: Piece) -> bool:
        """Whether it is in an idiom: "up to date", "call it a day"."""
        return not self.around.known_names.isdisjoint(range(piece.start, piece.end))

    def _is_somebody(self, piece: Piece) -> bool:
        """Whether it begins with who is given something, or spoken to: "give it to April on monday"."""
        led = any(is_whom(place, self.around) for place in {piece.start, max(0, piece.start - 1)})
        return led and not self.given.puts_off(piece)

    def _is_told_of(self, piece: Piece) -> bool:
        """Whether it is a feast that something is of: "a copy of Twelfth Night"."""
        joint = piece.start - (self.texts[piece.start] not in self.closed.of)
        if joint < 1 or self.texts[joint] not in self.closed.of or joint + 1 >= len(self.texts):
            return False
        feast = any(one.category == "feast" for one in self.around.pieces(joint + 1))
        thing = self.texts[joint - 1]
        named = thing.isalpha() and thing not in self.lexicon.function_words | self.lexicon.ordinals.keys()
        return feast and named and not self.around.timely(joint - 1)

    def _is_bought(self, piece: Piece) -> bool:
        """Whether what is bought is for so long: "buy a weekly ticket"."""
        before = self.around.before(piece) in self.lexicon.ordering
        article = self.texts[piece.start] in self.closed.articles
        again = isinstance(piece.value.time, Repeat)
        return before and article and again and not self.around.may_end(piece)

    def _is_in_sunshine(self, piece: Piece) -> bool:
        """Whether the sun in it shines: "in the sun at noon", "dry it in the morning sun"."""
        return any(map(self._shines, range(max(1, piece.start), min(piece.end + 1, len(self.texts)))))

    def _shines(self, place: int) -> bool:
        """Whether a weekday's short form has an article, and so is a thing; but "meet on the sat"."""
        if not (self.is_ambiguous(place) and self.around.is_weekday(place)) or self.measures.is_number(
            place + 1
        ):
            # "In the evening sat 10 oct"
            return False
        led = place - 1
        if led and self.around.is_part(led):
            # "The afternoon sun"
            led -= 1
            return self.texts[led] in self.closed.noun_openers
        *_, before = ("", *self.texts[:led])
        return self.texts[led] in self.closed.the and before != "on"

    def _is_age(self, piece: Piece) -> bool:
        """Whether it begins with how old somebody is then: "she turns nine on friday"."""
        wall, verb = piece.value.time, piece.start - 1
        clock = wall.clock if isinstance(wall, Wall) and piece.value.preposition is None else None
        if clock is None or clock.grain is not Unit.HOUR or verb < 1:
            return False
        told = not self.beside.of_clocks.isdisjoint(self.texts[piece.start : piece.end])
        if told or not self.measures.is_number(piece.start):
            return False
        somebody = self.texts[verb - 1] in self.closed.third_person_singular | self.lexicon.persons
        known = self.texts[verb - 1] not in {"it", *self.closed.object_pronouns}
        aged = self.texts[verb] in self.lexicon.no_times.aging
        return aged or (somebody and known and self.texts[verb] in self.closed.third_person_be)

    def _is_far(self, piece: Piece) -> bool:
        """Whether it is so many metres: "swim 50m", "4m of cable", "cut it to 1.5 m"; but "boil for 5 m"."""
        time = piece.value.time
        if not isinstance(time, Duration) or piece.value.preposition is not None:
            return False
        if self.texts[piece.end - 1] != "m" or time.unit is not Unit.MINUTE or len(time.terms) > 1:
            return False
        if self.around.follower(piece) in self.closed.of:
            return True
        for place in range(piece.start - 1, max(-1, piece.start - 1 - FAR), -1):
            if self.texts[place] in self.closed.joints_of_orders:
                # "Lower the heat and simmer 5 m"
                return False
            if self.texts[place] in self.lexicon.no_times.far:
                return True
        return False

    def _is_reckoned(self, piece: Piece) -> bool:
        """Whether numbers are reckoned with: "subtract 3 from 10", "round 4.45 to 4.5", "add up to 6"."""
        kinds, first = self.lexicon.no_times, piece.start
        rounded = self.texts[first] in kinds.reckoning and self.around.follower(piece) in self.closed.to
        if not (rounded or piece.value.preposition in {"by", "from", "to", "until"}):
            return False
        inside = {"up", "down", "off"} | (
            self.closed.it_or_them if self.texts[first] in self.closed.to else frozenset()
        )
        while first and self.texts[first] not in kinds.reckoning:
            first -= 1
            between = self.measures.is_number(first) or self.texts[first] in inside | kinds.reckoning | {"."}
            if not between:
                return False
        return self.texts[first] in kinds.reckoning and self.around.opens(first)

    def _is_of_period(self, piece: Piece) -> bool:
        """Whether it is the period that something is of: "the rent for may", "the third quarter numbers"."""
        wall = piece.value.wall
        days = None if wall.is_timed else wall.days
        if days is None or days.grain in {Unit.DAY, Unit.WEEK}:
            return False
        if piece.value.preposition == "of" and days.grain is Unit.YEAR:
            # "The class of 2020"; but "the summer of 2031"
            thing = piece.start - 1
            return thing >= 0 and self.texts[thing].isalpha() and not self.around.timely(thing)
        if piece.value.preposition == "for":
            return self.around.before(piece) in self.lexicon.no_times.for_periods
        article = self.texts[piece.start] in self.closed.noun_openers and piece.start > 0
        return article and piece.value.preposition is None and not self.around.may_end(piece)

    def _is_adjective(self, piece: Piece) -> bool:
        """Whether its last word says what a thing is like: "every minute detail", "sun cream"."""
        follower, last = self.around.follower(piece), self.texts[piece.end - 1]
        if isinstance(piece.value.time, Repeat):
            return last == "minute" and follower in self.lexicon.no_times.tiny
        return self.is_ambiguous(piece.end - 1) and follower in self.lexicon.no_times.adjectives

    def _is_person(self, piece: Piece) -> bool:
        """Whether what is short for an edge is a person without capitals: "feed the boy"; but "by BOY"."""
        last = self.words[piece.end - 1]
        short = self.lexicon.means(last.text, "ending") and not last.capital
        return short and last.text in self.lexicon.persons

    def _is_of_played(self, piece: Piece) -> bool:
        """Whether it is in the name of what is played: "play three o'clock blues", "watch 28 days later"."""
        verb, time, follower = piece.start - 1, piece.value.time, self.around.follower(piece)
        if self.texts[piece.end - 1] == "later" and follower in {""} | ENDS:
            begin = piece.end - 3
            days = begin > 0 and self.words[begin].is_digits and self.around.is_unit(begin + 1)
            return days and self.texts[begin - 1] in self.lexicon.playing and self.around.opens(begin - 1)
        if verb < 0 or self.texts[verb] not in self.lexicon.playing or not self.around.opens(verb):
            return False
        clocked = wall_of(time).clock is not None and piece.value.preposition is None
        return clocked and follower.isalpha() and not self.around.may_end(piece)

    def _ends_in_article(self, piece: Piece) -> bool:
        """Whether its last letter is an article, and no half of the day: "5 a | day"."""
        last = piece.end - 1
        if self.texts[last] != "a" or self.words[last].glued:
            return False
        joined = self.texts[last - 1] == "in" and self.around.follower(piece).isalpha()
        return joined or self.around.is_unit(piece.end)
