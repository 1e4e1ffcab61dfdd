"""What follows a time, and whether that leaves its last word a time: "at six love", but "at six robots"."""

from fuzzytime.english import is_participle, looks_plural, singular
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.surroundings.looked_up import LookedUp
from fuzzytime.language.grammar.timetables import counts_nothing
from fuzzytime.language.meaning.expressions import Said


class BehindTimes(LookedUp):
    """The words of a text, and what stands behind a time among them."""

    def may_end(self, piece: Piece) -> bool:
        """Whether what follows does not make its last word count or describe something."""
        follower = self.follower(piece)
        if follower in {"first", "last"} and self.texts[piece.end + 1 :][:1] in ([], ["."], [","], ["!"]):
            # "Feed the cat in the morning first"
            return True
        if not follower or not follower[0].isalnum():
            return follower not in {"%", "°", "€", "$"}
        if self.words[piece.end].is_address:
            # "Call mum at six", and where the call is.
            return True
        known = follower in self.lexicon.function_words or self.timely(piece.end)
        known = known or self._is_taken_back(piece.end) or follower in self.beside.saying_more
        known = known or self._is_polite_end(piece.end) or follower in self.closed.negators_as_typed
        # "Charge it overnight need it at seven"
        further = {*self.texts[piece.end + 1 : piece.end + 2]} & self.closed.it_or_them
        known = known or (bool(further) and follower in self.lexicon.doing.needing)
        known = known or self._says_how(piece.end) or self._says_how_long(piece)
        return known or self._is_in_front(piece) or self._is_before_order(piece)

    def _says_how(self, place: int) -> bool:
        """Whether a word says how it is done, and of no thing: "at six quietly", "at six asking for it".

        But "at six friendly shops", "at six meeting points".
        """
        text, happens = self.texts[place], self.lexicon.happening | self.lexicon.taken | self.lexicon.events
        # "After the morning meeting and before lunch"
        acts = is_participle(text) and text not in happens
        how = acts or any(map(text.endswith, self.closed.endings_of_manner))
        behind = self.texts[place + 1] if place + 1 < len(self.texts) else ""
        apart = not behind[:1].isalnum() and not acts
        return how and (apart or behind in self.lexicon.function_words)

    def _says_how_long(self, piece: Piece) -> bool:
        """Whether words say how long that takes: "the call at two lasts an hour", "… at two might take"."""
        asides, text = self.lexicon.asides, self.follower(piece)
        lasting = text in asides["taking"] or singular(text) in self.lexicon.doing.running
        takes = text in asides["helping"] or (lasting and looks_plural(text))
        # "The last one only | takes a minute"
        return takes and self.texts[piece.start] in self.closed.prepositions_of_points

    def _is_polite_end(self, place: int) -> bool:
        """Whether only courtesies and whom one calls stand behind: "at six don't forget", "at six alexa"."""
        forms = self.lexicon.courtesies | self.lexicon.called_behind
        while place < len(self.words):
            form = longest_match(self.words, place, forms)
            if form is None:
                break
            place += len(form)
        return self.texts[place : place + 1] in ([], ["."], [","], ["!"], ["?"], ["and"], ["then"], ["but"])

    def _is_taken_back(self, place: int) -> bool:
        """Whether words at a place take back the time before them for another: "at 5 sorry I meant 6"."""
        behind = place
        while behind < len(self.words):
            form = longest_match(self.words, behind, self.lexicon.corrections)
            if form is None:
                break
            behind += len(form)
        if not place < behind < len(self.words):
            return False
        number = self.words[behind].is_digits or self.texts[behind] in self.lexicon.numbers
        return number or self.timely(behind)

    def _is_before_order(self, piece: Piece) -> bool:
        """Whether one thing to be done follows behind several: "feed the baby at six bath her after"."""
        last, follower = self.texts[piece.end - 1], self.follower(piece)
        several = last in self.lexicon.numbers and last not in self.closed.singular_determiners
        several = several or self.words[piece.end - 1].is_digits
        # "At ten past do the veg"
        several = several or (last == "past" and self.texts[piece.start] == "at")
        # "It needs forty minutes take it out"
        lasts = self.is_unit(piece.end - 1)
        # "On the fourteenth at seven put it in"
        led = not (self.closed.prepositions_of_points | self.closed.prepositions_of_length).isdisjoint(
            (self.texts[piece.start], self.texts[piece.end - 2])
        )
        one = not self.are_several(follower)
        behind = "".join(self.texts[piece.end + 1 : piece.end + 2])
        opened = behind in self.closed.behind_verbs | self.closed.object_pronouns
        opened = opened or (several and led and self._is_done_with(piece.end))
        return (lasts or (several and led)) and follower.isalpha() and one and opened

    def are_several(self, text: str) -> bool:
        """Whether a word is of more than one thing: "eggs", "people"."""
        return looks_plural(text) or text in self.beside.plurals

    def _is_done_with(self, place: int) -> bool:
        """Whether a word and what is behind it are an order: "text ann", "order pizza", "lock up"."""
        verb, thing = self.texts[place], "".join(self.texts[place + 1 : place + 2])
        if not thing.isalpha() or thing in self.lexicon.function_words:
            # "If they're not here by ten start without them"
            doing = self.lexicon.doing
            ordered = self.lexicon.orders | self.lexicon.intransitive | doing.leaving | doing.beginning
            return verb in ordered and counts_nothing(self.words, place, self.lexicon)
        somebody = thing in self.lexicon.people
        return not looks_plural(thing) and (somebody or verb in self.lexicon.orders)

    def _is_in_front(self, piece: Piece) -> bool:
        """Whether what is to be done follows: "by six finish the slides", not "after two beers"."""
        behind = self.texts[piece.end + 1] if piece.end + 1 < len(self.texts) else ""
        follower = self.follower(piece)
        if self.are_several(follower) or not self.opens(piece.start):
            return False
        # "On the 12th meet Ann", where a number alone may count: "at 5 text messages"
        dated = self.words[piece.end - 1].glued and self.words[piece.end - 2].is_digits
        named = dated and behind[:1].isalpha() and behind not in self.lexicon.function_words
        # "After lunch call Bob"
        person = behind in self.lexicon.persons or (bool(behind) and self.words[piece.end + 1].capital)
        called = follower in self.lexicon.addressing and (person or named)
        if called or behind in self.closed.behind_verbs or self._is_done_to(piece.end):
            return True
        # "At six pizza with Ana", "at ten log in": what more than one counts is a plural.
        alone = not behind[:1].isdigit() and counts_nothing(self.words, piece.end, self.lexicon)
        # "At six robot 2 weld the frame", "at one lunch"
        alone = alone or (behind.isdigit() and follower in self.lexicon.called_by_number)
        happens = follower in self.lexicon.happening | self.lexicon.taken
        if happens and self.texts[piece.start : piece.end] == ["at", "one"]:
            return True
        return alone and self._ends_in_number(piece)

    def _ends_in_number(self, piece: Piece) -> bool:
        """Whether it ends in a number of more than one: "by six", "at six or so"."""
        # "At five or | six football"
        alone = piece.end - piece.start == 1 and not self._follows_time(piece.start)
        if alone or self.texts[piece.end - 1] in self.closed.singular_determiners:
            return False
        hedged = isinstance(piece.value, Said) and bool(piece.value.hedges)
        if hedged and piece.value.preposition is None and self.is_number(piece.end - 1):
            # "Only 5 left"
            return False
        # A hedge behind the number ends it.
        ends = range(piece.start if hedged else piece.end - 1, piece.end)
        # "On friday the thirteenth add a film night"
        dated = self.texts[piece.end - 2] in self.closed.the and self.is_weekday(piece.end - 3)
        return dated or any(map(self.is_number, ends))

    def _is_done_to(self, place: int) -> bool:
        """Whether a word is what is done to so many, or to somebody: "in july buy 3 eggs", "watch Dune"."""
        done = self.lexicon.orders | self.lexicon.doing.errands | self.lexicon.doing.putting
        behind = self.words[place + 1 : place + 2]
        if self.texts[place] not in done or self.words[place].capital or not behind:
            return False
        # "On the 12th make sure the gate is shut"
        sure = behind[0].text in self.lexicon.doing.sure
        return behind[0].capital or sure or self.is_number(place + 1)

    def opens(self, place: int) -> bool:
        """Whether nothing but who is called, or asked, stands before a place: "hey olly", "could you"."""
        *_, first, before = (".", ".", *self.texts[:place])
        asked = before == "you" and first in self.closed.requesting_modals
        starts = asked or before in self.beside.sentence_starts or before in self.lexicon.addresses
        return starts or self._follows_time(place)

    def _follows_time(self, place: int) -> bool:
        """Whether only another time, and a joint, stands before a place: "at six or | at eight call dad"."""
        before = self.texts[: max(place - 1, 0)]
        joined = bool(before) and self.texts[place - 1] in self.closed.coordinators_of_days
        return joined and all(
            text.isdigit() or text in self.lexicon.numbers or text in self.closed.prepositions_of_points
            for text in before
        )
