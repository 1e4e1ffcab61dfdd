"""A text as those see it who decide whether something is a time where it stands."""

from functools import cached_property
from itertools import takewhile

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.given_times import GivenTimes
from fuzzytime.language.grammar.judging.run_on_hours import RunOnHours
from fuzzytime.language.grammar.surroundings.compared import NEAR
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.meaning.times_of_day import DAY_HOURS


class Standing(Around):
    """Words, what measures stand among them, and what stands around any of them."""

    @cached_property
    def given(self) -> GivenTimes:
        """What is given, or put off, to a time."""
        return GivenTimes(self.around)

    @cached_property
    def run_on(self) -> RunOnHours:
        """The hours that are typed as one number."""
        return RunOnHours(self.around)

    def is_ambiguous(self, place: int) -> bool:
        """Whether the word at a place is an English word with another meaning, too: "may", "sun"."""
        return self.texts[place] in self.lexicon.ambiguous

    def begins_step(self, place: int) -> bool:
        """Whether what is done begins at a place: an entry, or what stands behind its hour, or "then"."""
        before = self.texts[place - 1] if place else ""
        joined = before in self.closed.joints_of_orders and not self.measures.is_number(place - 2)
        return joined or not before[:1].isalnum() or before in self.beside.of_hours

    def is_open(self, place: int) -> bool:
        """Whether something goes on for hours before a place: "open | ten to six", "my shift is | …"."""
        last = self.texts[place - 1] if place else ""
        if last in self.beside.equating:
            return not self.lexicon.frames.isdisjoint(self.texts[max(0, place - NEAR) : place])
        return last in self.beside.open_for_hours

    def is_seen_to(self, piece: Piece) -> bool:
        """Whether two hours with a dash stand behind one known thing, which has none: "man the desk 9-1".

        "Fill boxes 2-4" counts them, "the heating 18-20" has them for a level; so has what is booked.
        """
        first, dash, last = (self.words[place] for place in range(piece.start, piece.start + 3))
        typed = dash.text == "-" and dash.glued and last.glued and piece.end == piece.start + 3
        hours = [int(word.text) for word in (first, last) if word.is_digits]
        if not typed or len(hours) < 2 or max(hours) > DAY_HOURS or hours[0] == hours[1]:
            return False
        if not self.lexicon.appointing.isdisjoint(self.texts[: piece.start]):
            return False
        *before, thing = ("", "", *self.texts[: piece.start])[-3:]
        openers = self.closed.noun_openers - self.closed.indefinite_determiners
        levels = self.beside.with_levels | self.lexicon.amount_nouns
        return not (openers.isdisjoint(before) or looks_plural(thing) or thing in levels) and thing.isalpha()

    def is_called(self, place: int) -> bool:
        """Whether somebody is called right before a place: "call ann | five thirty"; not "call room 1430"."""
        verb = place - 2
        calling = self.lexicon.addressing - self.lexicon.doing.learning
        if verb < 0 or self.texts[verb] not in calling or not self.texts[place - 1].isalpha():
            return False
        nouns = self.lexicon.called_by_number | self.lexicon.function_words
        noun = self.texts[place - 1]
        named = {noun, noun.removesuffix("s")}.isdisjoint(nouns) and not self.measures.is_number(place - 1)
        return named and not self.around.timely(place - 1)

    def reminds(self, piece: Piece) -> bool:
        """Whether it stands between whom one reminds, and of what: "remind me | 1730 | to call mum"."""
        reminding = self.lexicon.doing.recalling & {*self.texts[max(0, piece.start - 2) : piece.start - 1]}
        return (
            bool(reminding)
            and self.around.follower(piece) in self.closed.to
            and not self.measures.is_number(piece.end + 1)
        )

    def is_met(self, place: int) -> bool:
        """Whether somebody is met, or something happens, right before a place: "pick up the kids | 3"."""
        marks = {",", ".", ";"} | self.closed.further_clause
        # A mark may part them: "dentist - 7.30"
        place -= place > 0 and self.texts[place - 1] in {"-", ":", "("}
        said = [*takewhile(lambda text: text not in marks, reversed(self.texts[:place]))]
        noun, before = (said[0], set(said[1:])) if said else ("", set[str]())
        unmet = self.lexicon.called_by_number | self.lexicon.addressing | self.lexicon.orders
        unmet |= self.lexicon.playing
        if not noun or noun in unmet or any(text.isdecimal() for text in said):
            # "Vet 10 dentist 3"
            return False
        if self.is_called(place) or noun in self.lexicon.happening | self.lexicon.taken:
            return True
        # "Pay Bob 10"
        person = noun in self.lexicon.persons - self.lexicon.workers
        person = person or (bool(before) and self.words[place - 1].capital)
        met = before & (self.lexicon.doing.meeting | self.lexicon.addressing | {"with"})
        return person and bool(met or (not before and not looks_plural(noun)))
