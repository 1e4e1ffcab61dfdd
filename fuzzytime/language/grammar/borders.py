"""What stands right before and behind a reading and makes it no time, whatever kind of time it would be."""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.dining import Dining
from fuzzytime.language.grammar.doses import Doses
from fuzzytime.language.grammar.events import Events
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.measuring import NEAR, Measures
from fuzzytime.language.grammar.particles import Particles
from fuzzytime.language.grammar.surroundings import Surroundings
from fuzzytime.language.grammar.words import Word, joins
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import TimeWord, Wall
from fuzzytime.requirement import Constraint

LAST_DAY = ["last", "day"]
"""Words for yesterday, which may be those for the end of something."""

TENS = 10
FEAST_WORDS = 3
"""Words of a feast's name before another that may be a time, at most."""

BANK_HOLIDAY = ["bank", "holiday"]
"""Words before a weekday on a date that is not known here."""

LONGEST_WISH = 4
"""Words of a hedge such as "if at all possible"."""

EXTREMES = frozenset({"latest", "earliest"})
"""The ends of "at the latest" and "at the earliest"."""


class Borders:
    """The words around readings: marks that run on, exceptions, comparisons, nouns."""

    def __init__(self, words: Sequence[Word], lexicon: Lexicon, around: Surroundings) -> None:
        self.words = words
        self.lexicon, self.closed, self.beside = lexicon, lexicon.closed, lexicon.beside
        self.texts = around.texts
        self.around = around
        self.measures = Measures(words, lexicon)
        self.particles = Particles(lexicon, around)
        self.doses = Doses(lexicon, around)
        self.dining = Dining(lexicon, around)
        self.events = Events(words, lexicon, around, self.measures)

    def refuse(self, piece: Piece) -> bool:
        """Whether they make a reading no time."""
        compared = (
            self.around.follower(piece) == "than" and self.texts[piece.end - 1] in self.beside.comparing
        )
        # "Twenty minutes earlier than usual"
        return (
            compared
            or self.runs_on(piece)
            or self._is_excepted(piece)
            or self.particles.hold(piece)
            or self.events.named(piece)
            or self._is_object(piece)
            or self._begins_another(piece)
            or self._is_named(piece)
            or self._says_how(piece)
            or self._says_order(piece)
            or self._opens_another(piece)
            or self._is_of_feast(piece)
            or self._is_of_other_calendar(piece)
            or self._likens(piece)
            or self._is_played(piece)
            or self.around.is_title(piece)
            or self._divides(piece)
            or self._begins_other_bound(piece)
            or self._hedges_what_follows(piece)
            or self._counts_another(piece)
            or any(map(self.doses.count, range(piece.start, piece.end)))
            or self.dining.is_purpose(piece)
            or self._offers_more(piece)
        )

    def _begins_other_bound(self, piece: Piece) -> bool:
        """Whether its last words begin another bound: "around noon but not before eleven"."""
        follower = self.around.follower(piece)
        begun = self.texts[piece.end - 2 : piece.end - 1] in (["not"], ["or"], ["and"])
        if self.texts[piece.end - 1] not in {"before", "after"} or not begun or not follower[:1].isalnum():
            return False
        further = self.around.timely(piece.end) or self.measures.is_number(piece.end)
        # "In an hour and | before bed"
        further = further or self.around.is_part_or_meal(piece.end)
        return further or not (follower in self.closed.further_clause or self.around.opens(piece.start))

    def _hedges_what_follows(self, piece: Piece) -> bool:
        """Whether its last words wish for the time behind them: "after six, preferably | around seven"."""
        led = any(said.category.startswith("preposition") for said in self.around.pieces(piece.end))
        # "Tonight, ideally before it gets dark" wishes something else than a time.
        place = piece.end + led
        article = not {*self.texts[place : place + 1]}.isdisjoint(self.beside.of_lengths)
        if not (self.around.timely(place) or self.measures.is_number(place) or article):
            return False
        if self.texts[piece.end - 1] in EXTREMES and "," in self.texts[piece.end - LONGEST_WISH : piece.end]:
            # "Before they come at seven, at the latest | an hour before"
            return True
        starts = range(max(piece.start + 1, piece.end - LONGEST_WISH), piece.end)
        ending = (said for start in starts for said in self.around.pieces(start) if said.end == piece.end)
        # "Before the walk at six, at least | half an hour before"
        return any(
            said.category.startswith("hedge") and (said.value == "about" or self.texts[said.start - 1] == ",")
            for said in ending
        )

    def _counts_another(self, piece: Piece) -> bool:
        """Whether its last number counts something else: "every 3 months or | 3000 miles"."""
        offered = piece.end - piece.start > 2 and self.texts[piece.end - 2] == "or"
        return offered and self.measures.is_number(piece.end - 1) and not self.around.may_end(piece)

    def _offers_more(self, piece: Piece) -> bool:
        """Whether one of two days has a time of its own, or both are bounds: "by monday or tuesday"."""
        led = self.around.before(piece) in self.closed.prepositions_of_time | self.closed.negators
        return piece.rule == "ranges.either_day" and (led or self.around.timely(piece.end))

    def _divides(self, piece: Piece) -> bool:
        """Whether it begins or ends within a number, a bracket, or "one on one": "the twenty fourth"."""
        first, before = self.texts[piece.start], self.around.before(piece)
        before_last = self.texts[piece.end - 2] if piece.end - piece.start > 1 else ""
        if first == ">" and self.words[piece.start].glued and "<" in self.texts[: piece.start]:
            # "Buy <wine> at six"
            return True
        if before_last in self.lexicon.ordinals and self.texts[piece.end - 1] in self.closed.sides:
            # "Take the first right"
            return True
        tens = self.lexicon.numbers.get(before, 0) in range(2 * TENS, 10 * TENS, TENS)
        named = (
            self.texts[piece.end - 1] in {"eve", "close"} or self.texts[piece.end - 2 : piece.end] == LAST_DAY
        )
        owned = self.texts[piece.start : piece.end] == LAST_DAY and self.around.is_owned(piece)
        if owned or (named and self.around.follower(piece) == "of"):
            # "On the eve of departure", "by close of school", "on the last day of the lease", "my last day"
            return True
        if self.around.ends_in_order(piece):
            return True
        ordinal = tens and self.lexicon.ordinals.get(first, TENS) < TENS
        paired = self.texts[piece.end - 1] == "one" and self.texts[piece.end + 1 : piece.end + 2] == ["one"]
        return ordinal or (paired and self.around.follower(piece) in {"on", "to"})

    def _is_played(self, piece: Piece) -> bool:
        """Whether it is of the title of what is played: "play yesterday"; but "what can we play tomorrow"."""
        time = piece.value.time
        if piece.value.preposition is not None or (isinstance(time, Wall) and time.clock is not None):
            return False
        verb = piece.start - 1
        while verb > 0 and (
            self.around.timely(verb)
            or self.measures.is_number(verb)
            or self.texts[verb] in self.closed.sure_noun_openers
        ):
            verb -= 1
        return verb >= 0 and self.texts[verb] in self.lexicon.playing and self.around.opens(verb)

    def _is_of_other_calendar(self, piece: Piece) -> bool:
        """Whether it is a feast on a day that is not known here: "chinese new year"."""
        for place in range(piece.start, piece.end):
            other = place > 0 and self.texts[place - 1] in self.lexicon.other_calendars
            if other and any(one.category == "feast" for one in self.around.pieces(place)):
                return True
            if self.texts[max(0, place - 2) : place] == BANK_HOLIDAY and self.around.is_weekday(place):
                # "On bank holiday monday"
                return True
        return False

    def _is_of_feast(self, piece: Piece) -> bool:
        """Whether it begins within the name of a feast: "black friday deals"."""
        found = (
            one
            for begin in range(max(0, piece.start - FEAST_WORDS), piece.start)
            for one in self.around.pieces(begin)
        )
        return any(one.category == "feast" and one.end > piece.start for one in found)

    def _likens(self, piece: Piece) -> bool:
        """Whether its "like" is what something looks like: "what is the weather like on friday"."""
        time = piece.value.time
        return self.texts[piece.start] == "like" and isinstance(time, Wall) and time.clock is None

    def _opens_another(self, piece: Piece) -> bool:
        """Whether it begins or ends in another word: "the stand-up to nine", "after eleven, just do it"."""
        joined = piece.start > 1 and self.texts[piece.start - 1] == "-" and self.words[piece.start].glued
        if joined and piece.value.preposition is not None and self.words[piece.start - 1].glued:
            return True
        if piece.rule == "bounds.past_goal" and not self.around.may_end(piece):
            # "Past the weekend market"
            return True
        if isinstance(piece.value.time, TimeWord) and self.around.follower(piece) == "left":
            # "When you have ten minutes left"
            return True
        return self.texts[piece.end - 1] in self.beside.restricting and self.texts[piece.end - 2] == ","

    def runs_on(self, piece: Piece) -> bool:
        """Whether typed marks go on beyond it: a part of a telephone number or of a larger word."""
        if piece.end < len(self.words):
            word = self.words[piece.end]
            if word.text == "'s":
                # "A day's work"
                return True
            last = self.words[piece.end - 1]
            if word.text == "'" and word.glued and last.text.endswith("s") and self._owns(piece.end + 1):
                # "With ninety seconds' rest"
                return True
            if last.text == "'" and word.glued and word.is_letters:
                # "Bed 4's"
                return True
            if word.glued and (word.is_digits or word.is_letters) and (last.is_digits or last.is_letters):
                return True
            if joins(self.words, piece.end) and last.is_letters and not self.around.timely(piece.end + 1):
                # "Twenty-year-old", "second-hand"
                return True
            if word.text == "." and self.texts[piece.end + 1 : piece.end + 2] == ["."]:
                # "At eleven… no, at twelve"
                return False
            if word.glued and word.text in {"-", "/", ":", ".", ",", "%", "°"} and last.is_digits:
                after = self.words[piece.end + 1] if piece.end + 1 < len(self.words) else None
                return word.text in {"%", "°"} or (after is not None and after.glued)
        first = self.words[piece.start]
        if piece.start and first.glued and first.is_digits:
            # The "15 on monday" of "train 7:15 on monday"
            before = self.words[piece.start - 1]
            if before.text == ":" and before.glued and self.words[piece.start - 2].is_digits:
                return True
            return before.is_letters or before.text in {"-", "/", ".", ",", "$", "€", "£", "#"}
        return (
            bool(piece.start) and first.glued and first.is_letters and self.words[piece.start - 1].is_digits
        )

    def _owns(self, place: int) -> bool:
        """Whether what belongs to a time stands at a place: "two hours' work"; but "in two hours' time"."""
        behind = self.words[place : place + 1]
        return bool(behind) and behind[0].is_letters and not behind[0].glued and behind[0].text != "time"

    def _says_how(self, piece: Piece) -> bool:
        """Whether it begins with how somebody is: "don't be late tomorrow"."""
        first = self.texts[piece.start]
        return first in {"late", "early"} and self.around.before(piece) in self.beside.being_late

    def _says_order(self, piece: Piece) -> bool:
        """Whether it begins with where something comes among others: "feed the cat first at six"."""
        ordinal = self.texts[piece.start] in self.lexicon.ordinals and self.words[piece.start].is_letters
        wall = piece.value.time
        days = wall.days if isinstance(wall, Wall) and wall.clock is not None else None
        alone = isinstance(days, Fields) and days == Fields(day=days.day)
        return ordinal and alone and self.around.before(piece) not in self.closed.sure_noun_openers

    def _is_excepted(self, piece: Piece) -> bool:
        """Whether it is left out: "except sundays" is not understood, and must not turn into its opposite."""
        before = self.texts[max(0, piece.start - 4) : piece.start]
        if before[-1:] in (["on"], ["at"], ["in"]):
            before.pop()
        if before[-1:] == ["but"] and self._is_added(piece):
            return False
        return bool({"except", "excluding", "but"} & set(before[-1:])) or before[-2:] in (
            ["except", "for"],
            ["except", "on"],
            ["but", "not"],
        )

    def _is_added(self, piece: Piece) -> bool:
        """Whether "but" adds it: a bound ("but not before six"), or any time where no other is repeated."""
        earlier = self.texts[: piece.start - 1]
        if "not" in earlier[-NEAR:]:
            # "Not today but tomorrow"
            return True
        bound = piece.value.constraint in {Constraint.BEFORE, Constraint.AFTER, Constraint.BETWEEN}
        return bound or (earlier[-1:] == [","] and not self.beside.repeating & set(earlier))

    def _begins_another(self, piece: Piece) -> bool:
        """Whether its last word is what something is said of next: "at 8:30, lunch is at twelve"."""
        alone = piece.end - piece.start == 1 and piece.start == 0
        apart = alone or self.texts[piece.end - 2] == ","
        return (
            apart and self.around.follower(piece) in self.beside.saying and isinstance(piece.value.time, Wall)
        )

    def _is_named(self, piece: Piece) -> bool:
        """Whether its preposition names a thing: "the till"."""
        return (
            self.around.before(piece) in self.closed.sure_noun_openers
            and (self.texts[piece.start],) in self.lexicon.clauses
        )

    def _is_object(self, piece: Piece) -> bool:
        """Whether it begins with a part of the day that something is done to: "film the sunrise at six"."""
        return self.around.is_object(piece.start + (self.texts[piece.start] == "the"))
