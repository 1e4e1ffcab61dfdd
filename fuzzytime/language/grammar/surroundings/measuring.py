"""Whether a number is an amount: "volume by 10", "bake it at 180", "cut it in two"."""

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.compared import NEAR, NEARLY, STATED, Compared
from fuzzytime.language.meaning.expressions import Range, Said, Wall
from fuzzytime.language.meaning.joined.distances import LOWER, UPPER
from fuzzytime.requirement import MOMENTS, STRETCHES, Unit

AMOUNTED = frozenset({"by", "until", "through", "from", "between"})
"""Bounds that amounts have too: "by 10", "until 10"; "before 10" and "after 10" are times."""

OF_TIME = frozenset({"by", "between"})
"""Those of amounts that are of time behind a thing that is counted."""

CLOCK_DIGITS = 4
"""Digits of a clock time without a colon, as in 1745: more than most amounts have."""

SUM_DIGITS = 3
"""Digits of what is paid, at least, that is no hour."""

LARGEST_SHARE = 8
"""The largest number that things are parted by, as a rule: "5/8 cup"."""


class Measures(Compared):
    """What is measured in a text."""

    def measured(self, piece: Piece) -> bool:
        """Whether words shortly before make a number an amount: "turn the volume up by 10"."""
        if self.says_how_much(piece):
            return True
        if piece.value.preposition in {None, *NEARLY} and self._switches(piece):
            return False
        for place in range(piece.start - 1, max(0, piece.start - NEAR) - 1, -1):
            leads = place + 1 == piece.start and self.texts[place] == "and" and not self.is_number(place - 1)
            if leads or self._is_other_order(place) or self.is_amount(place):
                # "Turn the heating down, and from ten shear the sheep"
                return False
            if place and self.is_amount(place - 1):
                return False
            if self._measures(place, piece):
                return True
        return False

    def tells_hour(self, piece: Piece) -> bool:
        """Whether its last word says that it is an hour: "measure it sixish"; but "dim it to sixish"."""
        raised = "to" in self.texts[max(0, piece.start - 1) : piece.start + 1]
        return self.texts[piece.end - 1] in self.beside.telling_hours and not raised

    def says_amount(self, piece: Piece) -> bool:
        """Whether words make a number how much: "kids under 12", "fares start at 4", "levels off at 5"."""
        said = piece.value
        if self._is_sum(piece) or self._is_open_number(piece):
            return True
        clock = said.time.clock if isinstance(said.time, Wall) else None
        if clock is None or not (said.time.bare or clock.pair) or not self.is_number(piece.end - 1):
            return False
        first = self.texts[piece.start]
        if said.preposition is None:
            return not (UPPER | LOWER).isdisjoint(said.hedges) and not self.is_number(piece.start)
        before = [text for text in self.texts[: piece.start] if text not in self.beside.still_at]
        *_, subject, verb = ("", "", *before)
        told = ("s", "ed") if first == "from" else "ed"
        owned = subject in self.closed.noun_openers
        if verb in self.beside.amounting and verb.endswith(told) and not owned:
            # "Fares from 4", "priced at 6"; but "charge the battery from 9", "collect the fees from 9"
            return True
        stands = verb in self.beside.standing and subject in self.beside.amounting
        levels = verb in self.lexicon.particles and subject in self.beside.levelling
        return (stands or levels) and first in {"at", "from", *NEARLY}

    def _is_sum(self, piece: Piece) -> bool:
        """Whether it is what is paid, or what there is room for: "owe about 1500", "it seats up to 8"."""
        kinds, said, number = self.lexicon.no_times, piece.value, self.words[piece.end - 1]
        up = "up" in self.texts[piece.start : piece.start + 2]
        *_, before, verb = ("", "", *self.texts[: piece.start])
        near = up or said.preposition in {"around", "between"} or (said.preposition is None and said.hedges)
        large = number.is_digits and len(number.text) >= SUM_DIGITS
        if not near or not self.is_number(piece.end - 1):
            return False
        if large and not kinds.costing.isdisjoint((before, verb)):
            return True
        room = verb in kinds.costing | kinds.having_room and bool(up or large)
        # "Dinner for up to 8"
        return room or (up and "for" in {self.texts[piece.start], verb})

    def _is_open_number(self, piece: Piece) -> bool:
        """Whether it is so many or more: "bring ten or more", "groups of six or less"."""
        first = piece.start + (piece.value.preposition == "of")
        more = self.texts[max(first, piece.end - 2) : piece.end]
        return " ".join(more) in self.beside.or_more and all(map(self.is_number, range(first, piece.end - 2)))

    def _switches(self, piece: Piece) -> bool:
        """Whether something is turned on or off, which is no amount: "turn off the lights around six"."""
        before = self.texts[max(0, piece.start - NEAR) : piece.start]
        verbs = (
            self.lexicon.particles.get(word, frozenset()) for word in before if word in self.beside.switched
        )
        return any(not found.isdisjoint(before) for found in verbs)

    def is_level(self, piece: Piece) -> bool:
        """Whether something is kept or left at a number: "keep the fridge at four", "stay at 18 until six".

        Who keeps an appointment at four does so then, and so who leaves the house at six.
        """
        at = piece.start
        while at and self.is_number(at):
            at -= 1
        place = at + 1
        while self.is_number(place):
            place += 1
        hour = not self.beside.of_clocks.isdisjoint(self.texts[place : place + 1])
        if self.texts[at] != "at" or place == at + 1 or hour or self.texts[place : place + 1] == ["."]:
            return False
        so = self.texts[at - 1] in self.closed.stative_verbs or "'" in self.texts[at - 1]
        if at > 1 and so and self.says_how_much(piece):
            # "Once the room is at ten", "once the oven's at 220"
            return True
        before = self.texts[max(0, at - NEAR) : at]
        verb = next((p for p in reversed(range(len(before))) if before[p] in self._keeping), None)
        if verb is None:
            return False
        thing = before[verb + 1 :]
        inside = self.closed.prepositions_of_time | self.lexicon.particles.keys() | self.closed.additions
        timed = self.lexicon.events | self.lexicon.happening | self.lexicon.taken | self.lexicon.results
        # "Hold the door for me at nine", "get hold of Bob at six"
        timed |= self.closed.object_pronouns - self.closed.it_or_them
        if not inside.isdisjoint(thing) or not timed.isdisjoint(thing[-1:]) or thing[:1] == ["of"]:
            return False
        # "Leave the fridge at four", "put the price at 11"
        levelled = (self.beside.with_levels | self.lexicon.amount_nouns).intersection(thing[-1:])
        return before[verb] in self.beside.kept_at or bool(levelled)

    def counts_hundreds(self, piece: Piece) -> bool:
        """Whether hundreds in it are how much there is: "when it's two hundred and five | inside"."""
        hundreds = [p for p in range(piece.start, piece.end) if self.texts[p] in self.lexicon.magnitudes]
        if not hundreds or "hours" in self.texts[piece.start : piece.end]:
            # "When it's fourteen hundred hours"
            return False
        behind = self.texts[piece.end : piece.end + 1]
        cut = hundreds[-1] == piece.end - 1 and behind == ["and"] and self.is_number(piece.end + 1)
        stated = self.lexicon.clauses.get((self.texts[piece.start],)) in STATED
        return stated or cut

    @property
    def _keeping(self) -> frozenset[str]:
        return self.beside.kept_at | self.beside.left_at

    def _is_other_order(self, place: int) -> bool:
        """Whether what stands before a word begins another order: "dim it and lock the door by 10"."""
        text, behind = self.texts[place], self.texts[place + 1 : place + 3]
        joined = (
            text == "and"
            and behind[-1] in self.closed.behind_verbs
            and behind[0] not in self.closed.behind_verbs
        )
        return joined or text in {".", ";", "!", "?", "then"}

    def _measures(self, place: int, piece: Piece) -> bool:
        """Whether a word makes a number behind it an amount: that depends on how it is bound."""
        text, said, lexicon = self.texts[place], piece.value, self.lexicon
        if text in lexicon.amount_nouns and self._is_read(place):
            # "Take her temperature at two"
            return False
        if place and self.texts[place - 1] in lexicon.levels and place + 1 == piece.start:
            # "On low heat at six": how high it is was said.
            return False
        if _is_near_hour(said):
            # "Bake the bread around six"; but "pick about five", "dim it to about six"
            amount = place + 1 == piece.start or self.texts[piece.start - 1] in self.closed.to
            return (amount and text in lexicon.measure_verbs) or self._has_amount(place)
        if not (_is_bound_to_hour(said) or self.is_fraction(piece)):
            return text in lexicon.measure_verbs | lexicon.measure_nouns | lexicon.amount_nouns
        if said.preposition not in AMOUNTED:
            return False
        counts, rates, apart = text in lexicon.counting, text in lexicon.rating, place + 1 < piece.start
        if apart and ((counts and said.preposition in OF_TIME) or (rates and said.preposition == "by")):
            # "Choose one by five", "count the till between nine and ten"
            return False
        if self._has_amount(place) or counts or rates:
            return True
        if self.texts[piece.start] not in {"by", "from", "up"}:
            return False
        following = self.texts[place + 1 : piece.start + 1]
        if not self.beside.stating.isdisjoint(following[:1]) or (
            place and self.texts[place - 1] in self.closed.noun_openers
        ):
            # "My shift is from 7 to 3": a thing, and no verb.
            return False
        named = self.closed.noun_openers.intersection(self.texts[max(0, place - 2) : place])
        if text in lexicon.frames and place + 1 == piece.start and named:
            # "The late shift from 2 to 10"
            return False
        return any(verb == text and set(rest) <= set(following) for verb, *rest in lexicon.changing)

    def is_fraction(self, piece: Piece) -> bool:
        """Whether it is by a part of a whole: "raise the seat by 3/4"."""
        *_, bound, first, slash, last = ("", "", "", *self.texts[piece.start : piece.end])
        typed = slash == "/" and first.isdecimal() and last.isdecimal()
        return bound == "by" and typed and int(first) < int(last) <= LARGEST_SHARE

    def _has_amount(self, place: int) -> bool:
        """Whether a word is what has an amount, and no verb: "turn the heat up", but "heat the soup"."""
        following = {*self.texts[place + 1 : place + 2]}
        verb = following & (self.closed.noun_openers | self.closed.object_pronouns)
        return self.texts[place] in self.lexicon.amount_nouns and not verb

    def _is_read(self, place: int) -> bool:
        """Whether something is found out of what has an amount: "check the speed at six"."""
        before = self.texts[max(0, place - NEAR) : place]
        stops = [p for p, text in enumerate(before) if text in self.beside.stops]
        said = self.texts[place + 1 : place + 2]
        if not self.closed.stative_verbs.isdisjoint(said):
            # "Check the price is at 10": how much it is.
            return False
        return not self.lexicon.reading.isdisjoint(before[max(stops, default=-1) + 1 :])

    def is_amount(self, place: int) -> bool:
        """Whether a number here is what is measured, so that the next is none: "heat it to 200 by 6".

        It may be of several words: "set it to seventy two by six".
        """
        begin = place
        while self.is_number(begin - 1):
            begin -= 1
        beside = (*self.texts[max(0, begin - 1) : begin], *self.texts[place + 1 : place + 2])
        amount = any(text in {"to", "at"} or text in self.lexicon.measure_nouns for text in beside)
        return amount and self.is_number(place)

    def is_rate(self, piece: Piece) -> bool:
        """Whether a repetition says how much in how long: "to 20 an hour", "at five km per hour"."""
        first = piece.start
        named = self.texts[first - 2 : first - 1] if first > 1 else []
        called = {text.removesuffix(end) for text in named for end in ("", "s")}
        again = self.texts[piece.start] in self.beside.first_of_repetitions
        if self.is_number(piece.start - 1) and not again and not (self.lexicon.measure_nouns & called):
            # "Within two working days"; but "pick from bin 4 daily", "take 2 every four hours"
            return True
        return self.texts[piece.start] == "per" and self.is_number(piece.start - 2)

    def is_sure(self, place: int) -> bool:
        """Whether four digits are a clock time: "0815"."""
        return self.words[place].is_digits and len(self.texts[place]) == CLOCK_DIGITS

    def is_called(self, place: int) -> bool:
        """Whether a number is the name of a thing that has no article: "at platform 9", "season 2"."""
        led = {*self.texts[max(0, place - 2) : place - 1]}
        named = place > 0 and self.texts[place - 1] in self.lexicon.called_by_number
        return named and self.is_number(place) and led.isdisjoint(self.closed.noun_openers)

    def divided(self, piece: Piece) -> bool:
        """Whether a number says into how many parts: "cut it in two"."""
        return bool(self.lexicon.dividing & set(self.texts[max(0, piece.start - NEAR) : piece.start]))

    def named(self, piece: Piece) -> bool:
        """Whether what has an amount stands right before: "the thermostat at 20", "seat 12A"."""
        # "Floor 5" is a place, "the floor just after 5" is swept, and so is "the floor fiveish".
        bare = piece.value.preposition is None and self.is_number(piece.start) and not piece.value.hedges
        # "Flight 6:40 am on friday" leaves then.
        bare = bare and self.lexicon.beside.of_hours.isdisjoint(self.texts[piece.start : piece.end])
        nouns = self.lexicon.called_by_number if bare else self.lexicon.amount_nouns
        if bare and ":" in self.texts[piece.start : piece.end]:
            # "Concrete truck 8:30", "first race 9:45": few things have a number of two parts.
            nouns = self.lexicon.amount_nouns | self.lexicon.no_times.numbered_in_two
        # "Turn it down a degree at ten": how much is said. "The temperature sixish": when.
        told = self.texts[max(0, piece.start - 2) : piece.start - 1] in (["a"], ["one"])
        told = not bare and (told or self.tells_hour(piece))
        place = piece.start - 1
        place -= place > 0 and not bare and self.texts[place] in self.closed.stative_verbs
        return place >= 0 and self.texts[place] in nouns and not told


def _is_near_hour(said: Said) -> bool:
    """Whether it is near a number that can be an hour: "around ten"."""
    clock = said.wall.clock
    near = said.constraint in MOMENTS and (
        said.preposition in NEARLY or (said.preposition is None and bool(said.hedges))
    )
    return near and clock is not None and clock.grain is Unit.HOUR


def _is_bound_to_hour(said: Said) -> bool:
    """Whether it is a bound at a number that can be an hour: "by 6", but not the "until 180" of an oven."""
    ends = (said.time.first, said.time.last) if isinstance(said.time, Range) else (said.time,)
    clocks = [end.clock for end in ends if isinstance(end, Wall) and end.clock is not None]
    hours = bool(clocks) and all(clock.grain is Unit.HOUR for clock in clocks)
    return hours and said.constraint in STRETCHES
