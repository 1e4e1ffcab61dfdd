"""Whether what stands around a reading makes it doubtful: numbers that count, words with another meaning."""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Cell, Piece
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.measuring import NEAR, Measures
from fuzzytime.language.grammar.surroundings import OWNING, POSSESSIVES, Surroundings
from fuzzytime.language.grammar.words import Word, joins
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Range, Repeat, Said, TimeWord, Wall
from fuzzytime.requirement import Constraint, Unit

POLITE = frozenset({"please", "thanks", ".", "!", "?", ",", ";", ":"})
BINDING = frozenset(
    {"at", "by", "until", "till", "before", "after", "from", "around", "about", "since", "for", "between"}
)
"""First words behind which two numbers may be the ends of a time: "between 5 and 6"."""

ASKED = frozenset({"me", "us", "just"})
"""Words before "a second" that make it no length of time."""

UNBINDING = frozenset({None, "to", "at", "for", "of", "on", "in", "from", "starting"})
"""Prepositions behind which a meal is a thing, or a place: "sugar in tea", "home from work"."""


NAMING = frozenset({"on", "to", "for", "of"})
"""Prepositions behind which an article and a time begin a noun: "the slides for the 3 pm meeting"."""

COMPARING = frozenset({"less", "more", "longer", "shorter", "earlier", "later"})
"""Words behind which "than" makes a length of time a difference."""

SPENDING = frozenset({"do", "have", "get", "take", "spend", "practise", "practice", "enjoy", "try"})
"""Verbs that a length of time is the object of: "do ten minutes of yoga"."""

REPEATING = frozenset({"every", "each", "all", "any", "daily", "weekly", "always"})
"""Words behind which "but" takes out: "every day but sunday"."""

CLOCK_DIGITS = 4
"""Digits of a clock time without a colon, as in 1745: more than most amounts have."""


class Judge:
    """What stands around a reading, and whether it makes it doubtful."""

    def __init__(self, words: Sequence[Word], lexicon: Lexicon) -> None:
        self.words = words
        self.lexicon = lexicon
        self.texts = [word.text for word in words]
        self.measures = Measures(words, lexicon)
        self.around = Surroundings(words, lexicon)

    def accepts(self, piece: Piece) -> bool:
        """Whether a reading is a time here."""
        said: Said = piece.value
        if self._runs_on(piece) or self._is_excepted(piece) or self._holds_particle(piece):
            return False
        if self._names_event(piece):
            return False
        if self.around.follower(piece) == "than" and self.texts[piece.end - 1] in COMPARING:
            # "Twenty minutes earlier than usual"
            return False
        time = said.time
        if self._is_whole(piece):
            return self._accepts_alone(said)
        if said.preposition == "for" and self._is_distance(piece) and not self._appoints(piece):
            # "Write for two hours before noon" says how long, and a bound.
            return False
        if isinstance(time, Duration):
            return self._accepts_duration(piece, said, time)
        if isinstance(time, Wall):
            return self._accepts_wall(piece, said, time)
        if isinstance(time, TimeWord) and self._begins_clause(piece):
            return False
        if isinstance(time, Range):
            return self._accepts_range(piece, said, time)
        if isinstance(time, Repeat) and self.around.before(piece) in {"most", "some", "many", "few"}:
            # "Most evenings": which, is not said.
            return False
        if isinstance(time, (Repeat, TimeWord)):
            return said.preposition is not None or not self.around.describes(piece)
        return True

    def _names_event(self, piece: Piece) -> bool:
        """Whether a noun behind it is what is meant: "before the 3 pm call", "after my 9 am class"."""
        said: Said = piece.value
        ordinal = self.texts[piece.end - 2 : piece.end - 1] == ["the"] and self._is_ordinal(piece.end - 1)
        if ordinal and piece.end < len(self.texts) and not self.around.may_end(piece):
            # "After the first one is done", "a day before the second coat"
            return True
        counted = isinstance(said.time, Offset)
        wall = said.time.anchor if isinstance(said.time, Offset) else said.time
        if not isinstance(wall, Wall) or wall.clock is None or self.around.may_end(piece):
            return False
        marked = longest_match(self.words, piece.start, self.lexicon.clauses) is not None
        owning = (place for place in range(piece.start + 1, piece.end - 1) if self.texts[place] in OWNING)
        return (counted or marked) and any(self.measures.is_number(place + 1) for place in owning)

    def _is_ordinal(self, place: int) -> bool:
        return self.texts[place] in self.lexicon.ordinals

    def _holds_particle(self, piece: Piece) -> bool:
        """Whether its first word belongs to a verb: "turn it on at sunrise"."""
        first, *rest = self.texts[piece.start : piece.end]
        if first == "over":
            # "Turn the steaks over every two minutes"
            return rest[:1] in (["every"], ["each"])
        return first == "on" and rest[:1] in (["at"], ["in"], ["during"])

    def _is_excepted(self, piece: Piece) -> bool:
        """Whether it is left out: "except sundays" is not understood, and must not turn into its opposite."""
        before = self.texts[max(0, piece.start - 3) : piece.start]
        if before[-1:] == ["but"] and self._is_added(piece):
            return False
        return bool({"except", "excluding", "but"} & set(before[-1:])) or before[-2:] in (
            ["except", "for"],
            ["except", "on"],
            ["but", "not"],
        )

    def _begins_clause(self, piece: Piece) -> bool:
        """Whether it begins a clause: "now that it is hot", "whenever it rains"; not "do it whenever"."""
        marker = longest_match(self.words, piece.start, self.lexicon.clauses)
        if marker is None or len(marker) < piece.end - piece.start:
            return False
        return len(marker) > piece.end - piece.start or self.around.follower(piece)[:1].isalnum()

    def _is_added(self, piece: Piece) -> bool:
        """Whether "but" adds it: a bound ("but not before six"), or any time where no other is repeated."""
        earlier = self.texts[: piece.start - 1]
        if "not" in earlier[-NEAR:]:
            # "Not today but tomorrow"
            return True
        bound = piece.value.constraint in {Constraint.BEFORE, Constraint.AFTER, Constraint.BETWEEN}
        return bound or (earlier[-1:] == [","] and not REPEATING & set(earlier))

    def continued(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the number behind a clock time and "and" or "or": "at seven and nine"."""
        time = piece.value.time
        place = piece.end + 1
        if not isinstance(time, Wall) or time.clock is None or place >= len(self.words):
            return []
        joint = self.texts[piece.end]
        if joint not in {"and", "or", ","} or any(one.start == place for one in chosen):
            return []
        numbers = [p for p in cells[place].get("said", {}).values() if isinstance(p.value.time, Wall)]
        found = [p for p in numbers if p.value.time.bare and self.around.may_end(p) and not self._runs_on(p)][
            :1
        ]
        if joint == "," and found and self.around.follower(found[0]) not in {",", "and", "or"}:
            return []
        return found + [more for one in found for more in self.continued(one, cells, chosen)]

    def _runs_on(self, piece: Piece) -> bool:
        """Whether typed marks go on beyond it: a part of a telephone number or of a larger word."""
        if piece.end < len(self.words):
            word = self.words[piece.end]
            if word.text == "'s":
                # "A day's work"
                return True
            last = self.words[piece.end - 1]
            if word.glued and (word.is_digits or word.is_letters) and (last.is_digits or last.is_letters):
                return True
            if joins(self.words, piece.end) and last.is_letters and not self.around.timely(piece.end + 1):
                # "Twenty-year-old", "second-hand"
                return True
            if word.glued and word.text in {"-", "/", ":", ".", ",", "%", "°"} and last.is_digits:
                after = self.words[piece.end + 1] if piece.end + 1 < len(self.words) else None
                return word.text in {"%", "°"} or (after is not None and after.glued)
        first = self.words[piece.start]
        if piece.start and first.glued and first.is_digits:
            before = self.words[piece.start - 1]
            return before.is_letters or before.text in {"-", "/", ".", ",", "$", "€", "£", "#"}
        return (
            bool(piece.start) and first.glued and first.is_letters and self.words[piece.start - 1].is_digits
        )

    def _is_distance(self, piece: Piece) -> bool:
        """Whether it is so long before or after another time."""
        time = piece.value.time
        if isinstance(time, Wall) and time.clock is not None and time.clock.shift:
            return bool({"before", "after"} & set(self.texts[piece.start : piece.end]))
        return isinstance(time, Offset) and time.anchor is not None

    def _appoints(self, piece: Piece) -> bool:
        """Whether words before make "for" say when: "an alarm for two hours before noon"."""
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        return bool(self.lexicon.appointing & set(before))

    def _is_whole(self, piece: Piece) -> bool:
        """Whether it is all that is said."""
        outside = [*self.texts[: piece.start], *self.texts[piece.end :]]
        return all(text in POLITE for text in outside)

    def _accepts_alone(self, said: Said) -> bool:
        time = said.time
        if isinstance(time, Wall) and time.clock is not None and time.clock.pair and said.preposition is None:
            if time.clock.shift:
                # "Twenty to four"
                return True
            return time.clock.hour >= self.lexicon.policy.bare_pair_from or time.clock.minute in {15, 30, 45}
        return True

    def _binds(self, piece: Piece) -> bool:
        return bool(BINDING & set(self.texts[piece.start : piece.start + 2]))

    def _accepts_duration(self, piece: Piece, said: Said, duration: Duration) -> bool:
        last = duration.until or duration
        if self.around.follower(piece) in COMPARING and self.texts[piece.end + 1 : piece.end + 2] == ["than"]:
            # "For a minute less than the packet says"
            return False
        if said.preposition is None and self.around.before(piece) == "by":
            # "Push the call back by thirty minutes"
            return False
        if said.preposition is None and any(unit is Unit.QUARTER for _, unit in last.terms):
            # A quarter of what, is not said: hardly of a year.
            return False
        if last.bare_end and self.measures.divided(piece):
            return False
        alone = duration.indefinite and said.preposition is None
        asked = {self.around.before(piece), self.texts[piece.start]}
        if last.ordinal_end and alone and ASKED & asked:
            # "Give me a second"
            return False
        if last.ordinal_end or last.bare_end:
            return self.around.may_end(piece) and not (said.preposition is None and last.bare_end)
        if said.constraint is Constraint.FOR and said.preposition is None:
            # "A ten minute walk" takes that long; but "a ten minute egg", "five minutes of fame".
            follower = self.around.follower(piece)
            if follower == "of":
                # "Do ten minutes of yoga"
                return self.around.before(piece) in SPENDING
            return follower in self.lexicon.lasting or self.around.may_end(piece)
        return True

    def _accepts_range(self, piece: Piece, said: Said, time: Range) -> bool:
        if self.texts[piece.start] in OWNING and not self.around.may_end(piece):
            # "The Monday to Friday timetable"
            return False
        if self.around.before(piece) in POSSESSIVES:
            # "Move my three o'clock to five"
            return False
        ends = [end for end in (time.first, time.last) if isinstance(end, Wall)]
        if ends and all(end.bare or end.weak for end in ends):
            between = said.preposition == "between" and self._binds(piece)
            return between and not self.measures.measured(piece) and self.around.may_end(piece)
        return True

    def _accepts_wall(self, piece: Piece, said: Said, wall: Wall) -> bool:
        if self._is_part_of_noun(piece, said, wall):
            return False
        if wall.bare:
            return self._accepts_number(piece, said, wall)
        if self.around.is_unit(piece.end) and isinstance(wall.days, Fields) and not wall.days.weekly:
            # "The 18th century table"
            return False
        if said.preposition == "of" and self._is_ordinal(piece.end - 1):
            # "Within a minute of the first"
            return False
        if (
            wall.clock is not None
            and wall.days is None
            and said.preposition is None
            and self.measures.named(piece)
        ):
            # "Seat 12A"
            return False
        if wall.clock is not None and wall.clock.pair and wall.days is None and wall.part is None:
            return self.around.may_end(piece) and said.preposition is not None
        if wall.part is not None and wall.part.place and self.texts[piece.end - 2] in OWNING:
            # "Before bed", but "before the bed is made"
            return False
        if wall.weak:
            unbinding = UNBINDING if wall.part is not None else {None, "to", "at"}
            # "Ask about lunch": what a meal is asked about.
            bound = said.preposition not in unbinding or bool(set(said.hedges) - {"about"})
            return bound and self.around.may_end(piece)
        if (
            wall.days is None
            and wall.clock is None
            and said.preposition is None
            and not self.around.may_end(piece)
        ):
            return False
        weekly = isinstance(wall.days, Fields) and wall.days.weekly
        if weekly and self.texts[piece.end - 2 : piece.end - 1] == ["the"] and self._is_ambiguous(piece):
            # "Before the sun goes down"
            return False
        # "The sun", "in the sun": a weekday never stands with "in".
        words = [text for text in self.texts[piece.start : piece.end] if text not in {"the", "in"}]
        return not (
            len(words) == 1 and words[0] in self.lexicon.ambiguous and said.preposition in {None, "in"}
        )

    def _is_part_of_noun(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether it only names something, or belongs to what does."""
        before = self.around.before(piece)
        if said.preposition is None and (self.around.describes(piece) or self.around.names(piece, wall)):
            return True
        if said.preposition is None and wall.clock is not None and before in POSSESSIVES:
            # "Cancel my three o'clock"
            return True
        followed = self.around.follower(piece) in {"before", "after"}
        if wall.part is not None and followed and "the" in {self.texts[piece.start], before}:
            # "The evening before the trip": which evening, is not said.
            return True
        if "to" in {said.preposition, before} and self.around.names_place(piece):
            return True
        # "Turn on the ten o'clock news", "the slides for the Monday meeting"
        owned = bool(OWNING & set(self.texts[piece.start + 1 : piece.end][:1]))
        inside = said.preposition == "in" and isinstance(wall.days, Fields) and wall.days.weekly
        if (said.preposition in NAMING or inside) and owned and not self.around.may_end(piece):
            return True
        # "My day planner"
        return (
            said.preposition is None
            and self.texts[piece.start] in POSSESSIVES
            and not self.around.may_end(piece)
        )

    def _is_ambiguous(self, piece: Piece) -> bool:
        return self.texts[piece.end - 1] in self.lexicon.ambiguous

    def _accepts_number(self, piece: Piece, said: Said, wall: Wall) -> bool:
        """Whether a number alone is a clock time: "at six", not the "at 180" of an oven."""
        if not self.around.may_end(piece) or self.around.is_unit(piece.end):
            return False
        before = piece.start - 1
        counted = self.measures.is_number(before)
        if piece.start > 1 and joins(self.words, before):
            # "A two-by-four"
            return False
        if said.preposition == "by" and counted and not self.measures.is_amount(before):
            # "Two by four"
            return False
        if said.preposition == "through" and counted:
            # "Pages 3 through 7"
            return False
        digits = self.words[piece.end - 1].is_digits and len(self.texts[piece.end - 1]) == CLOCK_DIGITS
        hour = digits or (wall.clock is not None and wall.clock.grain is Unit.HOUR)
        sure = said.preposition == "at" and hour and not self.measures.named(piece)
        if not sure and self.measures.measured(piece):
            return False
        if said.preposition in {None, "to", "in", "on", "of", "during", "sometime"}:
            return said.preposition is None and bool(said.hedges)
        return True
