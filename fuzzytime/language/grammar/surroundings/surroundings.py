"""What stands before and behind a stretch of words, and whether that makes it a part of a noun."""

from functools import cached_property

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.behind_times import BehindTimes
from fuzzytime.language.grammar.surroundings.measuring import Measures
from fuzzytime.language.meaning.calendar import Weekend, is_weekday
from fuzzytime.language.meaning.days.relations import Deictic
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.feasts import Feast, Season

THING = "thing"
"""The last word of a time that may be any thing: "first thing"."""


class Surroundings(BehindTimes):
    """The words of a text, and what stands around a piece of it."""

    @cached_property
    def measures(self) -> Measures:
        """What is measured in the text."""
        return Measures(self.words, self.lexicon)

    def plays(self, place: int) -> bool:
        """Whether a verb at a place has a title behind it, as "play", or "listen to" with both its words."""
        if self.texts[place] in self.closed.to and place:
            return self.texts[place - 1] in self.lexicon.no_times.listening and self.opens(place - 1)
        return self.texts[place] in self.lexicon.playing and self.opens(place)

    def describes(self, piece: Piece) -> bool:
        """Whether it stands between an article and a noun: "the 3 pm meeting"."""
        before = self.texts[piece.start - 1] if piece.start else ""
        if before in self.lexicon.ordinals and piece.start > 1:
            # "The second friday meeting"
            before = self.texts[piece.start - 2]
        if self.texts[piece.start] == "a" and self.is_weekday(piece.start + 1):
            # "A monday", as in "a monday morning mug"
            before = self.texts[piece.start]
        if before not in self.closed.before_numbers | self.closed.possessives:
            return False
        if before == "her" and self._is_behind_person(piece):
            return False
        # "A monday morning call": times behind it describe the same noun.
        last = piece._replace(
            end=next(p for p in range(piece.end, len(self.texts) + 1) if not self.timely(p))
        )
        return not self.may_end(last)

    def belongs(self, place: int) -> bool:
        """Whether a time at a place is that of a thing: "the report of | last week"."""
        if place < 2 or self.texts[place - 1] not in self.beside.belonging:
            return False
        thing = self.texts[place - 2]
        return thing.isalpha() and thing not in self.lexicon.function_words and not self.timely(place - 2)

    def is_object(self, place: int) -> bool:
        """Whether a part of the day is what something is done to: "film the sunrise"."""
        before = self.texts[place - 2] if place > 1 and self.texts[place - 1] in self.closed.the else ""
        acted = before[:1].isalpha() and before not in self.lexicon.function_words | self.beside.spending
        # "Pack the bags the evening before the trip"
        led = self.texts[place + 1 : place + 2] in (["before"], ["after"])
        return acted and not led and not self.timely(place - 2) and self.is_part(place)

    def ends_name(self, place: int) -> bool:
        """Whether a word ends what something is called: "movie night", "good morning"; not "cat morning"."""
        if not place or self.texts[place] not in self.beside.ending_names:
            return False
        before = self.texts[place - 1]
        somebody = before in self.lexicon.persons or before in self.lexicon.animals
        known = before in self.lexicon.function_words or (somebody and not looks_plural(before))
        timed = before in self.lexicon.numbers or self.timely(place - 1)
        return before.isalpha() and not known and not timed and not self.words[place - 1].capital

    def has_title(self, place: int) -> bool:
        """Whether the title of a person stands before a word: "Mrs. Noon"."""
        if not self.words[place].capital:
            return False
        before = [text for text in self.texts[:place] if text != "."][-1:]
        return not self.beside.titles_of_persons.isdisjoint(before)

    def is_somebody(self, place: int) -> bool:
        """Whether a part of the day, or a month, has the capital of a name: "call Dawn", "hug April"."""
        before = self.texts[place - 1] if place else ""
        begun = place == 1 and before.isalpha() and before not in self.lexicon.function_words
        # "Call Ann At Noon" is written in capitals.
        small = any(word.is_letters and not word.capital for word in self.words[1:])
        named = any(piece.category in {"part", "month"} for piece in self.pieces(place))
        named = named and self.texts[place] not in self.beside.ending_names
        # "Tell Summer by noon"
        known = before in self.lexicon.addressing and self.texts[place] in self.lexicon.no_times.given_names
        named = named or known
        return begun and self.words[place].capital and named and (small or len(self.words) == place + 1)

    def is_spent(self, piece: Piece) -> bool:
        """Whether it is what somebody does something in: "spend the evening sorting photos"."""
        return self.before(piece) in self.beside.spending and self.follower(piece).endswith("ing")

    def names_person(self, place: int) -> bool:
        """Whether a month at a place is a name: right behind a verb of calling, or "aunt", and no date.

        "Call april on friday"; but "call april 5", "remind me march 2nd".
        """
        before = self.texts[place - 1] if place else ""
        given = self.texts[place] in self.lexicon.no_times.given_names
        if given and before and any(piece.category == "hedge" for piece in self.pieces(place)):
            # "Wake max before noon"; but "cook it max ten minutes"
            return not self._is_counted(place + 1)
        if (
            before in self.closed.joints_of_things
            and place > 1
            and any(p.category == "month" for p in self.pieces(place))
        ):
            return self.names_person(place - 2)
        pronoun = before in self.closed.object_pronouns or before in self.closed.persons_addressed
        relative = before in self.lexicon.persons and not pronoun
        if not relative and before not in self.lexicon.addressing:
            return False
        behind = self.words[place + 1 : place + 2]
        dated = bool(behind) and (
            behind[0].is_digits or behind[0].text in self.lexicon.ordinals.keys() | {"the", "of", "'", "-"}
        )
        dated = dated or (bool(behind) and behind[0].text in self.lexicon.numbers)
        # "Meet dawn at noon"
        given = given and self.is_part(place)
        return not dated and (given or any(one.category == "month" for one in self.pieces(place)))

    def _is_counted(self, place: int) -> bool:
        """Whether an amount begins at a place, or nothing does."""
        behind = self.words[place : place + 1]
        known = self.lexicon.numbers.keys() | self.closed.articles | self.beside.parts_of_hours
        return not behind or behind[0].is_digits or behind[0].text in known

    def names_place(self, piece: Piece) -> bool:
        """Whether a name goes on behind it: "to Thursday Island"."""
        behind = self.words[piece.end : piece.end + 1]
        return bool(behind) and behind[0].capital and self.words[piece.end - 1].capital

    def is_title(self, piece: Piece) -> bool:
        """Whether it is of what is written as a title: "The Day After Tomorrow", "Friday Night Lights"."""
        first = next((p for p in range(piece.start, piece.end) if self.words[p].capital), piece.end)
        end = first
        while first and self.words[first - 1].capital:
            first -= 1
        while end < len(self.words) and self.words[end].capital:
            end += 1
        if end < piece.end or self.opens(first) or (first > piece.start and self.texts[first - 1] == "-"):
            # From when to when: "8:30 a.m.-Noon Workshops"
            return False
        led = first < piece.start and self.texts[first] in self.closed.articles
        # "A Tequila Sunrise"; but "on a Tuesday Morning"
        *_, before = ("", *self.texts[:first])
        led = led or (first < piece.start and before in self.closed.articles and not self.timely(first))
        parts = [place for place in range(first, end) if self.is_part(place)]
        return led or (bool(parts) and not self.timely(end - 1))

    def ends_in_order(self, piece: Piece) -> bool:
        """Whether its last word says what comes first, and no day: "call me today, first the office"."""
        last = piece.end - 1
        if self.texts[last] in self.closed.conjuncts and last > piece.start and self.is_weekday(last - 1):
            # "Call Bob on friday next call Tim"
            return not self.may_end(piece)
        ordinal = self.texts[last] in self.lexicon.ordinals
        apart = last > piece.start + 1 and self.texts[last - 1] == ","
        return ordinal and apart and not any(p.category == "month" for p in self.pieces(last - 2))

    def is_owned(self, piece: Piece) -> bool:
        """Whether whose it is stands before it: "my three o'clock", "tomorrow's ten o'clock"."""
        before = self.before(piece)
        return before in self.closed.possessives or before.endswith("'s")

    def _is_behind_person(self, piece: Piece) -> bool:
        """Whether "her" is who, and not whose: "remind her tomorrow", "ring her between nine and ten"."""
        bound = self.texts[piece.start] in self.beside.binding_ranges
        return bound or ({*self.texts[: piece.start - 1][-1:]} <= self.lexicon.addressing and piece.start > 1)

    def is_of_several(self, place: int) -> bool:
        """Whether a part of the day there is named by whose it is: "parents' evening"."""
        *_, owners, mark = ("", "", *self.texts[:place])
        return mark == "'" and owners.endswith("s") and self.is_part(place)

    def cites(self, place: int) -> bool:
        """Whether two numbers with a colon are of a text, or a ratio: "John 3:16"; but "call John 3:16"."""
        before = self.texts[max(0, place - 3) : place]
        if before[-1:] == ["of"]:
            before.pop()
        return (
            before[-1:] != []
            and before[-1] in self.lexicon.citing
            and not self.lexicon.addressing & {*before}
        )

    def names(self, piece: Piece, wall: Wall) -> bool:
        """Whether it belongs to the noun behind it: "the Sunday suit", "Christmas tree", "midnight blue"."""
        if wall.part is not None or self.may_end(piece) or self.is_spent(piece):
            return False
        if wall.clock is not None:
            worded = all(word.is_letters for word in self.words[piece.start : piece.end])
            return wall.days is None and wall.clock.full_day and worded
        days = wall.days.of if isinstance(wall.days, Deictic) else wall.days
        owned = self.texts[piece.start] in self.closed.noun_openers
        if owned and isinstance(days, Weekend):
            # "The weekend market"
            return True
        return isinstance(days, (Feast, Season)) or (
            owned and is_weekday(days) and not isinstance(wall.days, Deictic)
        )


class Around:
    """A text as those see it who decide about a piece by what stands around it."""

    def __init__(self, around: Surroundings) -> None:
        self.around, self.words, self.texts = around, around.words, around.texts
        self.lexicon, self.closed, self.beside = around.lexicon, around.closed, around.beside
        self.measures = around.measures
