"""Whether a reading is cut out of a larger word, number or stretch: "twenty-year-old", "650-555-0100"."""

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.words import is_minute, joins
from fuzzytime.language.meaning.expressions import Duration, TimeWord, Wall
from fuzzytime.language.meaning.times_of_day import Half

LAST_DAY = ["last", "day"]
"""Words for yesterday, which may be those for the end of something."""

BEFORE_LAST = ["before", "last"]
"""The end of a period that was, or the beginning of what comes."""

OF_CLOCKS = frozenset({"at", "@"})
"""What stands before a clock time on a day."""

THESE = frozenset({"this", "that"})
"""Words that may say which of a thing is meant."""


TIMES = "times"
"""What a number of turns counts."""

TENS = 10
LONG_DIGITS = 3
"""Digits of the parts of a telephone number, at least."""


class Cuts(Standing):
    """The marks and words that go on beyond readings."""

    def make(self, piece: Piece) -> bool:
        """Whether a reading is only a part of what is said."""
        within = self._begins_clause(piece) or self._is_now_and_again(piece) or self._is_in_name(piece)
        within = within or self._counts_hourly(piece) or self._ends_in_next_time(piece)
        return within or self.runs_on(piece) or self._divides(piece) or self._opens_another(piece)

    def _ends_in_next_time(self, piece: Piece) -> bool:
        """Whether a comma parts it from the next time, or its day: "at 2, friday | at 3"."""
        wall, texts = piece.value.time, self.texts[piece.start : piece.end]
        if not isinstance(wall, Wall) or wall.clock is None or "," not in texts:
            return False
        if wall.part is not None and wall.part.half is not Half.NIGHT and texts[-2] == "at":
            # "Call mum at ten, | at sunset", "hens out at ten, | in at sunset"
            return self.around.is_part_or_meal(piece.end - 1)
        if wall.part is not None and texts[-2] == ",":
            # "Evening drops at seven, | night drops at eleven"
            follower = self.around.follower(piece)
            return follower.isalpha() and follower not in self.lexicon.function_words
        if wall.days is None:
            return False
        number = piece.end + (self.around.follower(piece) in OF_CLOCKS)
        told = not self.beside.of_hours.isdisjoint(self.texts[number + 1 : number + 2])
        told = told or number > piece.end or self.texts[number + 1 : number + 2] == [":"]
        behind = piece.end - texts[::-1].index(",")
        dated = any(map(self.around.is_day, range(behind, piece.end)))
        return told and dated and self.measures.is_number(number)

    def runs_on(self, piece: Piece) -> bool:
        """Whether typed marks go on beyond it: a part of a telephone number or of a larger word."""
        if piece.end < len(self.words):
            first, word = self.words[piece.start], self.words[piece.end]
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
            if word.glued and word.text == "/" and last.is_letters and len(last.text) == 1:
                # "1145 P/U Grace"
                return True
            if joins(self.words, piece.end) and last.is_letters and not self.around.timely(piece.end + 1):
                # "Twenty-year-old", "second-hand"; but "7:00 am-let the dog out"
                return not (first.is_digits and not piece.start and last.text in self.beside.of_hours)
            if word.glued and word.text in {"-", "/", ":", ".", ",", "%", "°"} and last.is_digits:
                after = self.words[piece.end + 1] if piece.end + 1 < len(self.words) else None
                # "(Call mum at 9.)": what closes behind a full stop is no part of a number.
                runs = after is not None and after.glued and (after.text[0].isalnum() or after.text == "-")
                # "Dentist 9.30,gym 11", and "7:30-feed the dogs" in front of a line
                leads = word.text == "-" and not piece.start and ":" in self.texts[: piece.end]
                apart = word.text == "," or leads
                runs = runs and not (apart and after is not None and after.is_letters)
                if word.text in {"%", "°"} or runs:
                    return True
        return self._runs_before(piece)

    def _runs_before(self, piece: Piece) -> bool:
        """Whether typed marks, or letters, go on in front of it."""
        first = self.words[piece.start]
        if piece.start and first.glued and first.is_digits:
            # The "15 on monday" of "train 7:15 on monday"
            if is_minute(self.words, piece.start):
                return True
            before = self.words[piece.start - 1]
            if before.text == "/" and self.texts[piece.start - 2] in self.lexicon.beside.of_hours:
                # "Feed the cat 7am/7pm"
                return False
            decade = before.text == "'" and self.texts[piece.end - 1] == "s"
            return decade or before.is_letters or before.text in {"-", "/", ".", ",", "$", "€", "£", "#"}
        return (
            bool(piece.start) and first.glued and first.is_letters and self.words[piece.start - 1].is_digits
        )

    def _owns(self, place: int) -> bool:
        """Whether what belongs to a time stands at a place: "two hours' work"; but "in two hours' time"."""
        behind = self.words[place : place + 1]
        return bool(behind) and behind[0].is_letters and not behind[0].glued and behind[0].text != "time"

    def _divides(self, piece: Piece) -> bool:
        """Whether it begins or ends within a number, a bracket, or "one on one": "the twenty fourth"."""
        first, before = self.texts[piece.start], self.around.before(piece)
        if first == ">" and self.words[piece.start].glued and "<" in self.texts[: piece.start]:
            # "Buy <wine> at six"
            return True
        if piece.start and all(self._is_long(place) for place in (piece.start - 1, piece.start)):
            # "Call 0800 555 1234 this afternoon"
            return True
        if first == "one" and before.isalpha() and self.measures.is_number(piece.start + 1):
            # "And another one two hours later"; but "in one two hours"
            return True
        tens = self.lexicon.numbers.get(before, 0) in range(2 * TENS, 10 * TENS, TENS)
        named = (
            self.texts[piece.end - 1] in {"eve", "close"} or self.texts[piece.end - 2 : piece.end] == LAST_DAY
        )
        owned = self.texts[piece.start : piece.end] == LAST_DAY and self.around.is_owned(piece)
        if owned or (named and self.around.follower(piece) in self.closed.of):
            # "On the eve of departure", "by close of school", "on the last day of the lease", "my last day"
            return True
        if self.around.ends_in_order(piece) or self._ends_before_last(piece):
            return True
        one = self.lexicon.ordinals.get(first, self.lexicon.numbers.get(first, TENS))
        # "On the twenty | fourth", "set it to sixty | eight until nine"
        within = tens and one < TENS
        paired = self.texts[piece.end - 1] == "one" and self.texts[piece.end + 1 : piece.end + 2] == ["one"]
        return within or (paired and self.around.follower(piece) in {"on", "to"})

    def _ends_before_last(self, piece: Piece) -> bool:
        """Whether a count is so long before the last of something: "1 week before last | frost"."""
        before, follower = self.around.before(piece), self.around.follower(piece)
        counted = self.measures.is_number(piece.start) or self.measures.is_number(piece.start - 1)
        counted = counted or before in self.closed.indefinite_determiners
        ends = counted and self.texts[piece.end - 2 : piece.end] == BEFORE_LAST
        return ends and follower.isalpha() and follower not in self.lexicon.function_words

    def _is_long(self, place: int) -> bool:
        """Whether a number has as many digits as the parts of telephone numbers."""
        return self.words[place].is_digits and len(self.texts[place]) >= LONG_DIGITS

    def _opens_another(self, piece: Piece) -> bool:
        """Whether it begins or ends in another word: "the stand-up to nine", "after eleven, just do it"."""
        joined = piece.start > 1 and self.texts[piece.start - 1] == "-" and self.words[piece.start].glued
        if joined and piece.value.preposition is not None and self.words[piece.start - 1].glued:
            return True
        if piece.rule == "bounds.past_goal" and not self.around.may_end(piece):
            # "Past the weekend market"
            return True
        last, follower = self.words[piece.end - 1], self.around.follower(piece)
        if last.text in self.around.closed.articles and not last.glued and piece.end - piece.start > 1:
            # "Charge 5 a head"; but "at 5 a tomorrow"
            other = follower in self.lexicon.function_words or self.around.timely(piece.end)
            return follower.isalpha() and not other
        if follower == TIMES and self.measures.is_number(piece.end - 1) and piece.end - piece.start > 1:
            # "Every monday, 3 times"
            return True
        if isinstance(piece.value.time, TimeWord) and follower == "left":
            # "When you have ten minutes left"
            return True
        return self.texts[piece.end - 1] in self.beside.restricting and self.texts[piece.end - 2] == ","

    def _begins_clause(self, piece: Piece) -> bool:
        """Whether its last words are those of a clause: "put it on | the second you hear the bell"."""
        marker = tuple(self.texts[piece.end - 2 : piece.end])
        closed = self.around.closed
        told = self.around.follower(piece) in closed.first_and_second_person | closed.third_person
        return told and marker[:1] == ("the",) and marker in self.lexicon.clauses

    def _is_in_name(self, piece: Piece) -> bool:
        """Whether it ends, or begins, in what a thing is called: "the 10 second | clip", "ward | round 8"."""
        follower = self.around.follower(piece)
        named = follower.isalpha() and follower not in self.lexicon.function_words
        last = piece.end + 1 == len(self.texts) and piece.start > 0
        if last and named and isinstance(piece.value.time, TimeWord) and self.texts[piece.end - 1] in THESE:
            # "Stop it after this | song"
            return True
        if follower == "thing" and self.texts[piece.end - 1] == "first":
            # "On the 20th first | thing"
            return True
        time = piece.value.time
        several = isinstance(time, Duration) and time.terms[0][0] > 1 and self.around.is_unit(piece.end - 1)
        # "60 sec squats" is how long one does them.
        several = several and (piece.value.preposition is not None or not self.begins_step(piece.start))
        if several and named and looks_plural(follower) and not looks_plural(self.texts[piece.end - 1]):
            # "Study in 25 minute | blocks"; but "in an hour guests arrive"
            return not self.around.timely(piece.end) and follower not in self.lexicon.orders
        counted = self.texts[piece.end - 1] == "second" and self.words[piece.end - 2].is_digits
        if self.texts[piece.start] == "round" and self.around.before(piece) in self.lexicon.no_times.rounds:
            return True
        return counted and named and not self.around.timely(piece.end)

    def _counts_hourly(self, piece: Piece) -> bool:
        """Whether a number is how many there are each hour: "do four | hourly checks", "take 2 | hourly"."""
        apart = self.texts[piece.end - 1] == "hourly" and piece.end - piece.start == 2
        follower = self.around.follower(piece)
        named = follower.isalpha() and follower not in self.lexicon.function_words
        number = apart and self.texts[piece.start] not in self.closed.articles
        return number and (named or self.around.before(piece) in self.lexicon.dosing)

    def _is_now_and_again(self, piece: Piece) -> bool:
        """Whether it is now, and then once more: "water it now and then | again at dusk"."""
        often = isinstance(piece.value.time, TimeWord) and piece.end - piece.start == 3
        return often and self.texts[piece.start] == "now" and self.around.follower(piece) == "again"
