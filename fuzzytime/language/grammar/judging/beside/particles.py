"""Words that begin a time by their looks, and belong to the verb before it: "turn it on at sunrise"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.calendar import is_weekday
from fuzzytime.language.meaning.expressions import Duration, Offset, Wall

ENDS_OF_DAYS = frozenset({"first thing", "last thing"})
"""What the first and the last of a day mean, behind which no preposition is needed."""

HOURS = 12
"""Numbers up to it may be hours."""


class Particles(Around):
    """The first words of readings, and the verbs before them."""

    def hold(self, piece: Piece) -> bool:
        """Whether its first word belongs to a verb: "turn it on at sunrise"."""
        first, *rest = self.texts[piece.start : piece.end]
        stray = first in self.beside.prefixes and not self._prefixes(piece)
        stray = stray or self._visits(piece) or self._stands_before_preposition(piece)
        if any((stray, self._stands_apart(piece), self._tells_what_is_on(piece))):
            return True
        if rest[-1:] == ["on"] and self.around.follower(piece) in self.closed.noun_openers:
            # "The notes from monday on my desk"
            return True
        if self.texts[piece.end - 1] == "ahead" and self.around.follower(piece) in self.closed.of:
            # "Ten minutes ahead of the call"
            return True
        if rest[-1:] == ["back"] and self.lexicon.rescheduling & set(self.texts[: piece.start]):
            # "Set the clocks an hour back"
            return True
        if first == "over":
            # "Turn the steaks over every two minutes"
            return rest[:1] in (["every"], ["each"], ["after"], ["at"], ["in"])
        if first in {"round", "around"} and rest[:1] != [] and self._moves_round(piece):
            return True
        if first == "in" and rest[:1] in (["each"], ["every"]) and piece.start:
            # "Weigh in every monday"
            return True
        lasts = isinstance(piece.value.time, Duration)
        day = self.around.is_day_from_now(piece.start + 1)
        # "Put a wash on this morning"
        day = day or (first == "on" and rest[0] in self.closed.distributives | {"this", "next"})
        if first in {"in", "on"} and day and not lasts:
            # "Bring the washing in tomorrow", "leave the light on tonight"; but "a call for Al on tomorrow"
            verbs = self.lexicon.particles["on"] & set(self.texts[max(0, piece.start - NEAR) : piece.start])
            return first == "in" or bool(verbs)
        if first == "in" and self.around.is_weekday(piece.start + 1):
            # "Hand them in friday"
            return True
        if first == "in" and rest[:1] == ["at"] and piece.value.wall.part is not None:
            # "Shut them in at dusk"
            return True
        if first == "in" and rest[:1] in (["around"], ["about"]) and self._comes_in(piece):
            return True
        # "Put the washing on first"
        follows = first == "on" and (bool(self.beside.taking_along & {*rest[:1]}) or rest == ["first"])
        return follows or self._counts_from_that(piece)

    def _moves_round(self, piece: Piece) -> bool:
        """Whether "round" says where: "bring the car round tomorrow"; not "call me around in an hour"."""
        first, then = self.texts[piece.start : piece.start + 2]
        moved = not self.lexicon.circling.isdisjoint(self.texts[max(0, piece.start - NEAR) : piece.start])
        if then not in self.beside.behind_round:
            return moved and self.around.is_day_from_now(piece.start + 1)
        # "Move the ward round to nine"
        return first == "round" or moved or then not in {"in", "at"}

    def _tells_what_is_on(self, piece: Piece) -> bool:
        """Whether "on" says that something is, and what is behind it when: "what's on this weekend"."""
        if self.texts[piece.start] != "on":
            return False
        *_, asked, before = ("", "", *self.texts[max(0, piece.start - 2) : piece.start])
        being = before in self.beside.being_on or (before in {"is", "'s"} and asked == "what")
        this = self.texts[piece.start + 1 : piece.end][:1] == ["this"]
        return being and (this or self.around.is_day_from_now(piece.start + 1))

    def _stands_before_preposition(self, piece: Piece) -> bool:
        """Whether "in" has the time's preposition behind it: "let nobody in during the afternoon"."""
        if self.texts[piece.start] != "in" or isinstance(piece.value.time, Duration):
            return False
        # "Let the cat in last thing"
        things = {said.category for said in self.around.pieces(piece.start + 1)}
        led = piece.start > 0 and not things.isdisjoint(ENDS_OF_DAYS)
        return led or self.texts[piece.start + 1] in self.beside.behind_particles

    def _stands_apart(self, piece: Piece) -> bool:
        """Whether a distance from something has it before it: "put the roast in | two hours before lunch"."""
        time = piece.value.time
        if piece.value.preposition == "on" and isinstance(time, Offset):
            # "Turn the telly on five minutes before that"
            return True
        verbs = self.lexicon.particles.get(self.texts[piece.start], frozenset())
        carried = not verbs.isdisjoint(self.texts[max(0, piece.start - NEAR) : piece.start])
        return isinstance(time, Offset) and time.anchor is not None and carried

    def _visits(self, piece: Piece) -> bool:
        """Whether "by" is where somebody goes: "come by around three", "drop by today"; not "come by six"."""
        if self.texts[piece.start] != "by":
            return False
        behind = piece.start + 1
        led = self.texts[behind : behind + 1] and self.texts[behind] in self.beside.behind_visiting
        day = self.around.is_day(behind) or self.around.is_day_from_now(behind)
        return self.around.before(piece) in self.beside.visiting and bool(led or day)

    def _comes_in(self, piece: Piece) -> bool:
        """Whether "in" is where one comes or is brought: "bring it in around six"; but "in about ten"."""
        time = piece.value.time
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        comes = self.around.before(piece) in self.lexicon.coming_in
        # "Put the roast in around six"
        carries = self.beside.bringing_in | self.lexicon.particles.get("in", frozenset())
        comes = comes or not carries.isdisjoint(before[:-1])
        number = isinstance(time, Duration) and time.bare_end and len(time.terms) == 1
        return isinstance(time, Wall) or (comes and number and time.terms[0][0] <= HOURS)

    def _prefixes(self, piece: Piece) -> bool:
        """Whether "post" and "pre" are prepositions: not in "post 4 letters", "a pre-dinner walk"."""
        words, behind = self.around.words, piece.start + 1
        dashed = self.texts[behind : behind + 1] == ["-"]
        apart = dashed and not all(word.glued for word in words[behind : behind + 2])
        opens = not dashed and self.around.opens(piece.start)
        # "Post tomorrow", "post at 4 pm"
        verb = opens and piece.value.wall.clock is None
        verb = verb or self.texts[behind] in self.beside.behind_round
        noun = self.around.before(piece) in self.closed.noun_openers
        # "Email the blog post today"; but "post Christmas"
        days = piece.value.wall.days
        typed = not dashed and piece.value.wall.clock is None
        noun = noun or (typed and (is_weekday(days) or self.around.is_day_from_now(behind)))
        return not (apart or verb or noun) and self.around.may_end(piece)

    def _counts_from_that(self, piece: Piece) -> bool:
        """Whether "in" belongs to the verb before a distance: "put the roast in two hours before that"."""
        if piece.value.preposition not in {"in", "not before", "no later than"}:
            return False
        if piece.value.preposition == "in" and self._is_counted(self.texts[piece.start : piece.end]):
            return True
        # "Check in 24 hours before the flight", "clock in five minutes early"
        time = piece.value.time
        distance = isinstance(time, Duration) or (isinstance(time, Offset) and time.anchor is None)
        return distance and self.around.follower(piece) in self.beside.distances

    def _is_counted(self, words: Sequence[str]) -> bool:
        """Whether its last words make a length a distance: "an hour beforehand"; not "an hour or later"."""
        if " ".join(words[-2:]) in self.beside.from_that:
            return True
        bound = words[-2] in {"or", "and"} or "not" in words
        return words[-1] in {"earlier", "later", "beforehand"} and not bound
