"""What stands right before and behind a reading and makes it no time, whatever kind of time it would be."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.beside.cuts import Cuts
from fuzzytime.language.grammar.judging.beside.dining import Dining
from fuzzytime.language.grammar.judging.beside.doses import Doses
from fuzzytime.language.grammar.judging.beside.events import Events
from fuzzytime.language.grammar.judging.beside.particles import Particles
from fuzzytime.language.grammar.judging.beside.titles import Titles
from fuzzytime.language.grammar.judging.given_times import GivenTimes
from fuzzytime.language.grammar.judging.look_alikes.things_of_times import is_from_the_past
from fuzzytime.language.grammar.judging.no_times import NoTime
from fuzzytime.language.grammar.surroundings.compared import SIGNS
from fuzzytime.language.grammar.surroundings.surroundings import Around, Surroundings
from fuzzytime.language.grammar.understood.due import tells_when_due
from fuzzytime.language.grammar.understood.lent import counts_one
from fuzzytime.language.meaning.expressions import Wall

LONGEST_WISH = 4
"""Words of a hedge such as "if at all possible"."""

BINDING = frozenset({"preposition_at", "preposition_before", "preposition_after", "hedge"})
"""Categories of words that bind a time behind them, and are other words before anything else."""

OFFERED_DAYS = frozenset({"offered_days.either_day", "offered_days.another_day"})
"""The rules of days side by side, of which each will do."""

CHANGED_LENGTH = "ranges.changed_length"
"""The rule of what gets another length: "from ten to fifteen minutes"."""
CONDITION = "if_it_is."
"""How names of the rules begin of conditions that the calendar decides."""

OUT_BY_DAY = ["outside", "during"]
"""Where something is, and when: "put it outside during the day"; but "outside daylight hours"."""

COMING = "coming"
"""What says which of several days is meant, and what somebody is doing then."""


class Borders(Around):
    """The words around readings: marks that run on, exceptions, comparisons, nouns."""

    def __init__(self, around: Surroundings) -> None:
        super().__init__(around)
        self.titles, self.no_times, self.cuts = Titles(around), NoTime(around), Cuts(around)
        self.particles, self.doses, self.dining = Particles(around), Doses(around), Dining(around)
        self.given, self.events = GivenTimes(around), Events(around)

    def refuse(self, piece: Piece) -> bool:
        """Whether they make a reading no time."""
        compared = (
            self.around.follower(piece) == "than" and self.texts[piece.end - 1] in self.beside.comparing
        )
        # "Twenty minutes earlier than usual", "3 > 2"
        return (
            compared
            or (self.texts[piece.end - 1] == "about" and self.around.follower(piece)[:1].isalnum())
            or (self.texts[piece.start] in SIGNS and self.measures.is_number(piece.start - 1))
            or self._is_state(piece)
            or self.texts[piece.start : piece.start + 2] == OUT_BY_DAY
            or self.particles.hold(piece)
            or self.events.named(piece)
            or self._is_object(piece)
            or self._begins_another(piece)
            or self._is_named(piece)
            or self._says_how(piece)
            or self._numbers_things(piece)
            or self._likens(piece)
            or self.titles.hold(piece)
            or self.no_times.hold(piece)
            or self.cuts.make(piece)
            or self._begins_other_bound(piece)
            or self._hedges_what_follows(piece)
            or self._counts_another(piece)
            or any(map(self.doses.count, range(piece.start, piece.end)))
            or self.doses.cap(piece)
            or self.dining.is_purpose(piece)
            or self.dining.is_covered(piece)
            or self.dining.is_subject(piece)
            or self._offers_more(piece)
            or self._begins_order(piece)
            or (piece.rule == CHANGED_LENGTH and not self.given.changes_length(piece))
            or is_from_the_past(piece, self.around)
            or self._is_asked(piece)
            or tells_when_due(piece, self.texts, self.lexicon)
            or self._counts_nothing(piece)
            or self._is_day_of(piece)
            or self._is_way(piece)
            or self.measures.counts_hundreds(piece)
        )

    def _is_state(self, piece: Piece) -> bool:
        """Whether its first word is what something is then, or does: "lamp on 6 am", "Bo's coming friday"."""
        wall, first = piece.value.wall, piece.start
        before = self.around.before(piece)
        if self.texts[first] == COMING and (
            before in self.closed.present_be or before.endswith(("'s", "’s"))
        ):
            return piece.end - first > 1
        if self.texts[first] != "on" or first == 0 or piece.end - first == 1:
            return False
        clock = wall.clock is not None and wall.days is None and wall.part is None
        return clock and self.words[first + 1].is_digits and self.words[first - 1].is_letters

    def _is_day_of(self, piece: Piece) -> bool:
        """Whether what is behind "on the day" says of which: "on the day of the party"."""
        behind = self.around.follower(piece)
        ends = (
            not behind.isalpha() or behind in self.closed.further_clause | self.closed.prepositions_of_points
        )
        return self.texts[piece.end - 3 : piece.end] == ["on", "the", "day"] and not ends

    def _counts_nothing(self, piece: Piece) -> bool:
        """Whether nothing says of what a number behind "in" is: "in around one", "order the shoes in 7"."""
        first = piece.start if self.texts[piece.start] == "in" else piece.start - 1
        if first < 0 or self.texts[first] != "in":
            return False
        said, one = piece.value, counts_one(piece.value)
        if first == piece.start:
            return one is not None and (one or self.around.before(piece) in self.beside.sized)
        clock = said.time.clock if isinstance(said.time, Wall) and said.time.bare else None
        # "Come in around one"
        near = bool(said.hedges) or said.preposition == "around"
        other = self.closed.first_person_objects | self.lexicon.particles.keys()
        particle = self.texts[first - 1] not in other and self.particles.hold(piece._replace(start=first))
        return clock is not None and clock.hour == 1 and near and not particle

    def _is_way(self, piece: Piece) -> bool:
        """Whether it begins with a way that somebody goes: "on the way after lunch"."""
        return (
            self.texts[piece.start] in self.beside.ways
            and self.around.before(piece) in self.beside.before_ways
        )

    def _begins_order(self, piece: Piece) -> bool:
        """Whether its last word is an order behind a day: "tomorrow close the blinds"."""
        if piece.end - piece.start == 1 or self.texts[piece.end - 1] not in self.lexicon.undoing:
            return False
        return self.around.follower(piece) in self.closed.noun_openers | self.closed.object_pronouns

    def _is_asked(self, piece: Piece) -> bool:
        """Whether it is what somebody finds out, or goes on: "check if it's friday", "and she's home"."""
        if not piece.rule.startswith(CONDITION):
            return False
        led = piece.start - (self.texts[piece.start - 1 : piece.start] == ["only"])
        doing = self.lexicon.doing
        asked = self.around.before(piece) in doing.learning or self.texts[max(0, led - 2) : led - 1] == [
            "ask"
        ]
        opens = {*self.texts[piece.end + 1 : piece.end + 2]} & self.closed.condition_openers
        return asked or (self.around.follower(piece) == "and" and bool(opens) and piece.start > 0)

    def _begins_other_bound(self, piece: Piece) -> bool:
        """Whether its last words begin another bound: "around noon but not before eleven"."""
        follower = self.around.follower(piece)
        begun = self.texts[piece.end - 2 : piece.end - 1] in (["not"], ["or"], ["and"])
        counted = self.texts[piece.end - 1] in self.beside.before_or_after
        if not counted or not begun or not follower[:1].isalnum():
            return False
        further = self.around.timely(piece.end) or self.measures.is_number(piece.end)
        # "In an hour and | before bed"
        further = further or self.around.is_part_or_meal(piece.end)
        return further or not (follower in self.closed.further_clause or self.around.opens(piece.start))

    def _hedges_what_follows(self, piece: Piece) -> bool:
        """Whether its last words wish for the time behind them: "after six, preferably | around seven"."""
        if self.texts[piece.end - 1] in self.beside.hedging_verbs and self.around.follower(piece).isalpha():
            # "At six, say hello"
            return True
        led = any(said.category.startswith("preposition") for said in self.around.pieces(piece.end))
        # "Tonight, ideally before it gets dark" wishes something else than a time.
        place = piece.end + led
        article = not {*self.texts[place : place + 1]}.isdisjoint(self.beside.of_lengths)
        if not (self.around.timely(place) or self.measures.is_number(place) or article):
            return False
        starts = range(max(piece.start + 1, piece.end - LONGEST_WISH), piece.end)
        ending = (said for start in starts for said in self.around.pieces(start) if said.end == piece.end)
        # "Cook lunch roughly | an hour from now", "before the walk at six, at least | half an hour before"
        return any(
            said.category == "hedge"
            or (said.category.startswith("hedge") and self.texts[said.start - 1] == ",")
            for said in ending
        )

    def _counts_another(self, piece: Piece) -> bool:
        """Whether its last number counts something else: "every 3 months or | 3000 miles"."""
        offered = piece.end - piece.start > 2 and self.texts[piece.end - 2] == "or"
        return offered and self.measures.is_number(piece.end - 1) and not self.around.may_end(piece)

    def _offers_more(self, piece: Piece) -> bool:
        """Whether one of some days has a time of its own, or all are bounds: "by monday or tuesday"."""
        led = self.around.before(piece) in self.closed.prepositions_of_time | self.closed.negators
        # "On friday or saturday to the fair", "on friday or saturday about the report"
        place = piece.end + any(p.category in BINDING for p in self.around.pieces(piece.end))
        timed = self.around.timely(place) or self.measures.is_number(place)
        # "On monday or tuesday or friday"
        more = self.texts[piece.end : piece.end + 1] == ["or"] and self.around.timely(piece.end + 1)
        return piece.rule in OFFERED_DAYS and (led or timed or more)

    def _likens(self, piece: Piece) -> bool:
        """Whether its "like" is what something looks like, or a verb: "a song I like at noon"."""
        time = piece.value.time
        liked = self.around.before(piece) in self.closed.personal_pronouns
        return self.texts[piece.start] == "like" and isinstance(time, Wall) and (liked or time.clock is None)

    def _says_how(self, piece: Piece) -> bool:
        """Whether it begins with how somebody is: "don't be late tomorrow"."""
        first = self.texts[piece.start]
        return first in self.beside.how_late and self.around.before(piece) in self.beside.being_late

    def _numbers_things(self, piece: Piece) -> bool:
        """Whether it begins with the numbers of several things: "read chapters 5 to 7 tonight"."""
        place = piece.start
        counts = self._joins_numbers(place) or self.measures.is_number(place)
        if not counts or self.measures.tells_hour(piece):
            # "Empty the bins sixish"
            return False
        if self.texts[place + 1 : place + 2] == [":"]:
            # As in "gates 9:15".
            return False
        while place and (self._joins_numbers(place - 1) or self.measures.is_number(place - 1)):
            place -= 1
        named = self.texts[place - 1] if place else ""
        singular = named.removesuffix("s")
        return named != singular and singular in self.lexicon.measure_nouns

    def _joins_numbers(self, place: int) -> bool:
        """Whether a joint stands between two numbers: "5 to 7"."""
        numbers = self.measures.is_number(place - 1) and self.measures.is_number(place + 1)
        return numbers and self.texts[place] in self.closed.range_joints_or_and

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
        """Whether it begins with a part of the day that something is done to: "film the sunrise at six".

        What is done to something "the evening of the 6th" is done then.
        """
        wall = piece.value.wall
        dated = wall.days is not None and wall.part is not None
        if (
            dated
            and piece.start > 1
            and self.texts[piece.start] in self.closed.the
            and self.texts[piece.start + 2 : piece.start + 3] == ["of"]
        ):
            return False
        return self.around.is_object(piece.start + (self.texts[piece.start] in self.closed.the))
