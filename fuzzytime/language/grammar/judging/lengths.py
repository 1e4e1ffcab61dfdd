"""Whether a length of time is one where it stands, and not a difference, a share or a distance."""

from itertools import takewhile

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.meaning.expressions import Duration, Said
from fuzzytime.requirement import BOUNDS, Constraint, Unit

SHORT = frozenset({Unit.SECOND, Unit.MINUTE, Unit.HOUR})
"""Units of how long exercises, and steps, go on."""

DESCRIBED = 5
"""Words from a length to what lasts so long, at most: "a 5-minute gentle cool-down walk"."""

ELAPSED = "elapsed."
"""How the names of rules begin of lengths that have passed."""


class Lengths(Standing):
    """What stands around lengths of time, and whether it makes one doubtful."""

    def _is_beside_another(self, piece: Piece, said: Said) -> bool:
        """Whether it counts from what is not known, or is compared with that."""
        if said.constraint in BOUNDS and "last" in self.texts[piece.start : piece.end]:
            # "Don't stir it until the last minute": of what, is not said, or behind it.
            return True
        follower, behind = self.around.follower(piece), self.texts[piece.end + 1 : piece.end + 2]
        going_on = self.lexicon.lasting | self.lexicon.happening | self.lexicon.taken
        alarm = self.around.before(piece) in self.lexicon.appointing - going_on
        if said.preposition == "for" and alarm and follower in self.beside.before_or_after:
            # "Set an alarm for an hour before the party"; but "a timer", "a meeting for an hour"
            return True
        # "When five minutes have passed since the bell", "for a minute less than the packet says"
        since = piece.rule.startswith(ELAPSED) and follower in self.beside.elapsed_from
        return since or (follower in self.beside.comparing and behind == ["than"])

    def accept(self, piece: Piece, said: Said, duration: Duration) -> bool:
        """Whether a length of time is one here."""
        last = duration.until or duration
        if self._is_beside_another(piece, said):
            return False
        if said.preposition is None and self._is_of_word_before(piece, duration):
            return False
        if said.preposition != self.texts[piece.start] and self._is_amount(piece):
            return False
        if said.preposition != "for" and self._is_ahead(piece.end):
            # "Confirm it 24 hours in advance": of what, is not said.
            return False
        quarter = any(unit is Unit.QUARTER for _, unit in last.terms)
        if quarter and (said.preposition is None or self.around.follower(piece) in self.closed.of):
            # A quarter of what, is not said: hardly of a year.
            return False
        if last.bare_end and (self.measures.divided(piece) or self._is_counting(piece)):
            return False
        alone = duration.indefinite and said.preposition is None
        if alone and self._is_counted(piece.start) and not self._is_before_marker(piece.end):
            # "Raise it to 20 an hour", "at 60 kilometres an hour"
            return False
        asked = {self.around.before(piece), self.texts[piece.start]}
        short = last.ordinal_end or last.terms in (((1, Unit.MINUTE),), ((1, Unit.SECOND),))
        waits = self.around.before(piece) in self.lexicon.doing.waiting
        if short and alone and self.beside.no_length & asked and not waits:
            # "Give me a second", "just a minute"; but "wait just a minute"
            return False
        if last.ordinal_end and said.preposition is None and self._is_of_timer(piece):
            # "Set a ninety second timer"
            return True
        if last.ordinal_end or last.bare_end:
            # "An hour or two before the guests arrive", "it takes an hour and ten"
            away = duration.until is not None and self._is_before_marker(piece.end)
            away = away or self.around.before(piece) in self.lexicon.asides["taking"]
            return self.around.may_end(piece) and not (
                said.preposition is None and last.bare_end and not away
            )
        if said.constraint is Constraint.FOR and said.preposition is None:
            return self._accepts_length(piece, duration)
        return True

    def _is_before_thing(self, piece: Piece) -> bool:
        """Whether it counts a thing behind it: "put a second coat on", "give him a second helping"."""
        follower = self.around.follower(piece)
        return follower.isalpha() and follower not in self.lexicon.function_words | self.beside.polite_ends

    def _is_amount(self, piece: Piece) -> bool:
        """Whether it says how much, and not how long: "add another five minutes to it", "go back 30 s".

        "Get back an hour before they come" says when.
        """
        opened = self.around.before(piece) in self.closed.noun_openers | self.closed.indefinite_determiners
        verb = self.texts[max(0, piece.start - 1 - opened)]
        amounts = self.beside.amounts_of_time | self.beside.amount_particles
        return verb in amounts and not self._is_before_marker(piece.end)

    def _is_of_word_before(self, piece: Piece, duration: Duration) -> bool:
        """Whether the word before a length without a preposition makes it none."""
        before = self.around.before(piece)
        if duration.ordinal_end and duration.indefinite and self._is_before_thing(piece):
            return True
        if before == "half" and duration.indefinite:
            # "By half an hour" is no hour.
            return True
        if before in self.beside.not_how_long and not (before == "last" and self._is_helped(piece.start - 1)):
            # "Push the call back by thirty minutes", "through the eight minutes"
            return True
        if before == "at" and self.lexicon.appointing.isdisjoint(self.texts[: piece.start]):
            # "Give them their jab at eight weeks": how old they are; but "set the timer at ten minutes"
            return True
        # "Two number 7s"
        plural = self.texts[piece.end - 1] == "s" and self.words[piece.end - 1].glued
        return plural and before in self.lexicon.measure_nouns

    def _is_counted(self, place: int) -> bool:
        """Whether a number, or some things of a number, stand before a place."""
        if self.measures.is_number(place - 1):
            return True
        thing = self.texts[place - 1] if place else ""
        # "The call at two lasts an hour"
        others = self.lexicon.function_words | self.lexicon.asides["taking"]
        named = thing.isalpha() and thing not in others and not self.around.timely(place - 1)
        return named and self.measures.is_number(place - 2)

    def counts_each(self, piece: Piece) -> bool:
        """Whether so many of something stand before a length that they are done in: "two tablets | a day"."""
        place = piece.start - 1
        while place > 0 and not self.measures.is_number(place) and self._is_of_thing(place):
            place -= 1
        counted = place < piece.start - 1 and self.measures.is_number(place)
        costs = not self.lexicon.no_times.costing.isdisjoint(self.texts[:place])
        # "Two walks | a day", "give her two walks | a day"
        whom = self.lexicon.function_words - self.closed.object_pronouns
        done = place == 0 or (self.texts[place - 1].isalpha() and self.texts[place - 1] not in whom)
        return counted and done and not costs and self.around.may_end(piece)

    def _is_of_thing(self, place: int) -> bool:
        """Whether a word may be one of those that name what is counted: "8 | glasses of water"."""
        text = self.texts[place]
        named = text.isalpha() and text not in self.lexicon.function_words and not self.around.timely(place)
        return named or text in {"-", "of"}

    def _is_of_timer(self, piece: Piece) -> bool:
        """Whether it stands between "a" and what goes on for so long: "a thirty second timer"."""
        led = self.around.before(piece) in self.closed.indefinite_determiners
        return led and self.around.follower(piece) in self.lexicon.lasting

    def _is_helped(self, place: int) -> bool:
        """Whether a helping verb stands right before a word, which is a verb then: "should last"."""
        return place > 0 and self.texts[place - 1] in self.closed.modals_before_lengths

    def _is_counting(self, piece: Piece) -> bool:
        """Whether a number without a unit counts units behind it: "in two business days"."""
        return any(self.around.is_unit(place) for place in (piece.end, piece.end + 1))

    def _accepts_length(self, piece: Piece, duration: Duration) -> bool:
        """Whether a length of time without a preposition says how long something takes."""
        # "A ten minute walk" takes that long; but "a ten minute egg", "five minutes of fame".
        follower, before = self.around.follower(piece), self.around.before(piece)
        opens = self.begins_step(piece.start)
        if follower == "of":
            # "Do ten minutes of yoga", "then two hours of coding"; but "ten minutes of your time"
            named = self.closed.noun_openers.isdisjoint(self.texts[piece.end + 1 : piece.end + 2])
            # "Give the patient five minutes of oxygen"
            giving = self.lexicon.doing.giving
            given = not giving.isdisjoint(self.texts[max(0, piece.start - NEAR) : piece.start])
            return before in self.lexicon.doing.spending or ((opens or given) and named)
        cleaning = follower.endswith("ing")
        if before in self.lexicon.doing.spent or (cleaning and before in self.lexicon.doing.spending):
            # "Spend an hour cleaning", "take ten minutes to tidy up"
            return cleaning or self.around.may_end(piece)
        return self._goes_before(piece, duration, opens=opens) or self.around.may_end(piece)

    def _goes_before(self, piece: Piece, duration: Duration, *, opens: bool) -> bool:
        """Whether what lasts so long stands behind it: "a 20-minute easy jog", "30 seconds plank"."""
        others = self.lexicon.function_words | self.beside.no_activities
        behind = self.texts[piece.end :]
        near = [*takewhile(lambda text: text == "-" or (text.isalpha() and text not in others), behind)]
        # "Two days hiking", "20 min yoga"
        short = all(unit in SHORT for _, unit in duration.terms) or self.around.follower(piece).endswith(
            "ing"
        )
        return not self.lexicon.lasting.isdisjoint(near[:DESCRIBED]) or (
            opens and short and near[:1] not in ([], ["-"])
        )

    def _is_before_marker(self, place: int) -> bool:
        return place < len(self.words) and longest_match(self.words, place, self.lexicon.clauses) is not None

    def _is_ahead(self, place: int) -> bool:
        """Whether words say that a length of time is a distance, and not from what: "ahead", "in advance"."""
        following = self.texts[place : place + 2]
        if following == ["in", "advance"]:
            return self.texts[place + 2 : place + 3] != ["of"]
        if following[:1] in (["ahead"], ["beforehand"]):
            return following != ["ahead", "of"]
        return following == ["from", "the"] and self.texts[place + 2 : place + 3] in (["end"], ["finish"])
