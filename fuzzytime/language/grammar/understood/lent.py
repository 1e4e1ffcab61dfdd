"""Numbers that lack their unit: "stirring every 10", "simmer for ten"; and what is for so many people."""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.expressions import Duration, Range, Repeat, Said, Time, TimeWord, wall_of
from fuzzytime.language.meaning.joined.distances import HALFWAY
from fuzzytime.language.meaning.times_of_day import DAY_HOURS
from fuzzytime.requirement import Constraint, Unit

FEWEST_MINUTES = 10
"""So many minutes at least something is in an oven; fewer are people."""

DEGREES_DIGITS = 3
"""Digits of a temperature, and of no hour."""


def lacks_unit(said: Said) -> bool:
    """Whether it is a share, or a number without a unit, of what was said to last."""
    time = said.time
    if isinstance(time, TimeWord):
        return time.word == HALFWAY
    length = time.every if isinstance(time, Repeat) else time
    after = said.constraint is Constraint.AFTER or isinstance(time, Repeat)
    if said.constraint is Constraint.FOR and isinstance(time, Duration) and time.terms:
        # "For 40"; but "for another five".
        after = time.terms[0][0] > DAY_HOURS
    bare = isinstance(length, Duration) and length.bare_end and len(length.terms) == 1
    return after and bare and isinstance(length, Duration) and length.until is None


def counts_one(said: Said) -> bool | None:
    """Whether it is one of nothing that is said, as in "in around one"; None where it is no bare number."""
    time = said.time
    bare = isinstance(time, Duration) and time.bare_end and len(time.terms) == 1
    return time.terms[0][0] == 1 if bare and isinstance(time, Duration) else None


def lasts_minutes(before: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether what stands right before "for" and a number goes on for minutes: "grill", "warm up"."""
    verb, *particle = before[-2:] or [""]
    # "Flip it and leave it for ten"
    left = verb == "leave" and not lexicon.closed.it_or_them.isdisjoint(particle)
    if left or _is_let_rest(before, lexicon):
        return True
    settles = verb in lexicon.doing.settling and not lexicon.particles.keys().isdisjoint(particle)
    return settles or (bool(lexicon.timing_alone.intersection(before[-1:])) and not _is_dish(before, lexicon))


def _is_dish(before: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether a verb ends what another makes: "make french toast for two", but "chop it, then stir fry"."""
    order = before[max((p + 1 for p, text in enumerate(before) if text in lexicon.beside.stops), default=0) :]
    described = order[-2:-1] and order[-2] not in lexicon.function_words
    return bool(described) and order[0] in lexicon.orders and lexicon.letting.isdisjoint(order[:-2])


def is_left_for(texts: Sequence[str], first: int, end: int, lexicon: Lexicon) -> bool:
    """Whether a number alone, from ``first`` to ``end``, is how many minutes it is left: "let it rest five".

    What comes next ends the order, or says what comes behind it.
    """
    behind = texts[end] if end < len(texts) else ""
    return _is_let_rest(texts[:first], lexicon) and behind in (
        {"", "before"} | lexicon.beside.behind_minutes | lexicon.closed.adverbs_of_repetition
    )


def _is_let_rest(before: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether something is let do what takes some minutes: "let it cool", "leave them to stand"."""
    rests = not lexicon.doing.resting.isdisjoint(before[-1:])
    # "Keep the rest for four"
    rests = rests and lexicon.closed.noun_openers.isdisjoint(before[-2:-1])
    return rests and not lexicon.letting.isdisjoint(before[:-1])


def is_heated(before: Sequence[str], time: Time | Duration | Repeat) -> bool:
    """Whether so many minutes are said behind a temperature: "bake it at 180 for ten"; but not "for four"."""
    at, degrees = before[-2:] if len(before) > 1 else ("", "")
    clock = wall_of(time).clock
    number = time.terms[0][0] if isinstance(time, Duration) and time.terms else clock.hour if clock else 0
    return at == "at" and degrees.isdecimal() and len(degrees) == DEGREES_DIGITS and number >= FEWEST_MINUTES


class Lent(Around):
    """What stands around numbers without a unit, and whether it tells their unit."""

    def accept(self, piece: Piece, said: Said) -> bool:
        """Whether a number takes the unit said before: "turning it after 30", "stirring every 10"."""
        if isinstance(said.time, TimeWord) and self.texts[piece.end - 1] == "through":
            # "Roast the chicken for an hour", and in the next line "turn it halfway through"
            return self.around.follower(piece) in {"", ".", ",", ";", "!", "and"} or piece.start == 0
        lent = any(self.around.is_unit(place) for place in range(piece.start))
        if said.preposition is None and isinstance(said.time, Duration):
            return is_left_for(self.texts, piece.start, piece.end, self.lexicon)
        if said.constraint is Constraint.FOR and isinstance(said.time, Duration):
            return self.times(piece) or (lent and self.around.may_end(piece))
        if not lent or not self.around.may_end(piece):
            return False
        if isinstance(said.time, TimeWord):
            return self.around.follower(piece) in {"", ".", ",", ";", "!", "and"}
        return True

    def times(self, piece: Piece) -> bool:
        """Whether what is done is measured in minutes: "simmer for ten", "steep the tea for four"."""
        # "Keep the rest for four" is for people.
        verbs = [
            place
            for place in range(piece.start)
            if self.texts[place] in self.lexicon.timing
            and (place == 0 or self.texts[place - 1] not in self.closed.noun_openers)
        ]
        whole = not verbs or not self.beside.stops & set(self.texts[verbs[-1] : piece.start])
        before = self.texts[: piece.start]
        told = lasts_minutes(before, self.lexicon) or is_heated(before, piece.value.time)
        told = told or (bool(verbs) and whole)
        return told and self.around.follower(piece) in ({""} | self.beside.behind_minutes)

    def seats(self, piece: Piece, time: Time | Duration | Repeat) -> bool:
        """Whether it is for how many: "a table for four on friday", "for two until six"."""
        if isinstance(time, Repeat):
            time = next(iter(time.walls), time)
        first = time.first if isinstance(time, Range) else time
        clock = wall_of(first).clock
        hour = clock is not None and clock.half is None and clock.grain is Unit.HOUR
        worded = not self.beside.of_clocks & set(self.texts[piece.start : piece.end])
        begin = piece.start + (self.texts[piece.start] == "for")
        laid = self.texts[max(0, begin - 4) : begin - 2] == ["on", "the"]
        number = self.texts[begin]
        counted = (number.isdigit() or number in self.lexicon.numbers) and not laid and not piece.value.hedges
        counted = counted and worded
        seated = self.texts[max(0, begin - 2) : begin] == ["table", "for"]
        if self.texts[begin - 1 : begin] == ["for"] and self.texts[piece.end : piece.end + 1] in (
            ["at"],
            ["from"],
        ):
            # So many people have the room "for six from 2:30 on"
            hour_behind = self.texts[piece.end + 1 : piece.end + 2]
            seated = seated or any(one[:1].isdigit() or one in self.lexicon.numbers for one in hour_behind)
        return hour and counted and seated
