"""Whether a reading is of a name: what is played or watched, a feast, one on a day that is not known."""

from collections.abc import Sequence
from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import TimeWord

BANK_HOLIDAY = ["bank", "holiday"]
"""Words before a weekday on a date that is not known here."""

BINDING = frozenset({"preposition_at", "preposition_before", "preposition_after"})
"""Categories of words that bind a time behind them."""

CAPITAL_ANYWAY = ("weekday", "weekdays", "month", "feast")
"""Categories of words that have a capital in any sentence."""


LEAST_TITLE = 2
"""Words of a title that capitals tell, at least."""


def written_out(words: Sequence[Word], lexicon: Lexicon) -> frozenset[int]:
    """Give the places of a title that has capitals where a time has none: "watch Before Sunrise tonight".

    Who writes all words with capitals writes times so, too ("Watch The News At Ten").
    """
    found: set[int] = set()
    small = any(word.is_letters and not word.capital for word in words)
    for place, word in enumerate(words):
        if small and _takes_title(words, place, lexicon) and (not place or not word.capital):
            end = place + 1
            while end < len(words) and _goes_on(words, end, lexicon):
                end += 1
            if end - place > LEAST_TITLE and _tells(words[place + 1 : end], lexicon):
                found |= {*range(place + 1, end)}
    return frozenset(found)


def _takes_title(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a title may stand behind a word: "watch", "read", and the "of" of "a copy of"."""
    kinds, before = lexicon.no_times, words[place - 1].text if place else ""
    # "The film Before Sunrise"
    work = words[place].text in kinds.works and before in lexicon.closed.sure_noun_openers
    return (
        work
        or (words[place].text in lexicon.closed.of and before in kinds.copies)
        or words[place].text in lexicon.playing | lexicon.no_times.titled
    )


def _goes_on(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a word may be one of a title: joints have no capital there: "Born on the Fourth of July"."""
    behind = place
    while behind < len(words) and words[behind].text in lexicon.closed.inside_titles:
        behind += 1
    bound = words[place].text not in lexicon.closed.of and lexicon.means(words[place].text, *BINDING)
    if bound and behind < len(words) and lexicon.means(words[behind].text, *CAPITAL_ANYWAY):
        # "Read The Hobbit on Friday", "watch The Crown at Christmas"
        return False
    return behind < len(words) and (words[behind].capital or (behind == place and words[place].is_digits))


def _tells(title: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a word has a capital that has none in a sentence: "Before"; or a unit behind a number."""
    if title[0].text in lexicon.no_times.beginning_titles or _ends_in_time(title, lexicon):
        return True
    said = any(
        word.capital
        and (
            word.text in lexicon.function_words
            or (word.text,) in lexicon.clauses
            or any(one.category in BINDING for one in lexicon.entries.get(word.text, ()))
        )
        for word in title
    )
    first, second = title[:LEAST_TITLE]
    # "Read 28 Days", "read Eight Months on Ghazzah Street"
    counted = (first.is_digits and len(title) == LEAST_TITLE) or (
        first.capital and first.text in lexicon.numbers
    )
    return said or (counted and second.capital and lexicon.means(second.text, "unit"))


def _ends_in_time(title: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a time that has no capital in a sentence has one, and a small joint: "Murder at Midnight"."""
    *_, joint, last = title
    joined = not joint.capital and joint.text in lexicon.closed.inside_titles
    return title[0].capital and joined and last.capital and lexicon.means(last.text, "part", "day")


class Titles(Standing):
    """The names around readings, and whether they hold one."""

    def hold(self, piece: Piece) -> bool:
        """Whether a reading is of a name."""
        return (
            self._is_played(piece)
            or not self._written_out.isdisjoint(range(piece.start, piece.end))
            or self._is_of_feast(piece)
            or self._is_of_other_calendar(piece)
            or self.around.is_title(piece)
            or self.around.has_title(piece.start)
            or (self._may_be_called(piece.start) and self.around.is_somebody(piece.start))
        )

    def _may_be_called(self, place: int) -> bool:
        """Whether persons may be called by a word: a part of the day, or a name that is a time, too."""
        given = self.texts[place] in self.lexicon.no_times.given_names
        return self.around.is_part(place) or (given and not self.around.is_day(place))

    def _is_played(self, piece: Piece) -> bool:
        """Whether it is of the title of what is played: "play yesterday"; but "what can we play tomorrow"."""
        if not self._plays:
            return False
        wall = piece.value.wall
        numbered = any(map(self.measures.is_number, range(piece.start, piece.end)))
        clocked = wall.clock is not None and (numbered or wall.days is not None)
        verb = piece.start - 1
        # "Play 3 AM by Matchbox Twenty"
        by_whom = self.around.follower(piece) == "by" and any(
            word.capital for word in self.words[piece.end + 1 : piece.end + 2]
        )
        credited = by_whom and verb >= 0 and self.around.plays(verb)
        other = piece.value.preposition not in {None, "of"} or isinstance(piece.value.time, TimeWord)
        if other or (clocked and not credited) or self._is_to_come(piece):
            return False
        if self.texts[piece.start] == "this" and self.texts[verb] not in self.lexicon.playing:
            # "Watch the sunset this evening"
            return False
        # "Play blue monday by new order"
        named = self.around.follower(piece) == "by" and not self.around.timely(piece.end + 1)
        named = named and not self.around.is_day_from_now(piece.start)
        while verb > 0 and (named or self._is_titular(verb)) and not self.around.plays(verb):
            verb -= 1
        return verb >= 0 and self.around.plays(verb)

    def _is_to_come(self, piece: Piece) -> bool:
        """Whether a day to come ends what is said: "watch tomorrow"; but "play yesterday"."""
        coming = not any(
            one.category == "day" and one.value.days < 0 for one in self.around.pieces(piece.start)
        )
        small = not any(word.capital for word in self.words[piece.start : piece.end])
        ends = self.around.follower(piece) in self.beside.polite_ends | {""}
        return coming and small and ends and self.around.is_day_from_now(piece.start)

    @cached_property
    def _written_out(self) -> frozenset[int]:
        """The places of words of a title with capitals."""
        return written_out(self.words, self.lexicon) if self._may_have_title else frozenset()

    @cached_property
    def _plays(self) -> bool:
        """Whether anything is played in the text."""
        return not (self.lexicon.playing | self.lexicon.no_times.listening).isdisjoint(self.texts)

    @cached_property
    def _may_have_title(self) -> bool:
        """Whether a word stands in the text behind which a title may."""
        kinds = self.lexicon.no_times
        return self._plays or not (kinds.titled | kinds.copies | kinds.works).isdisjoint(self.texts)

    def _is_titular(self, place: int) -> bool:
        """Whether a word may stand before a time in what is called after it: "last christmas"."""
        deictic = any(one.category == "deictic" for one in self.around.pieces(place))
        timely = self.around.timely(place) or self.measures.is_number(place)
        return timely or deictic or self.texts[place] in self.closed.sure_noun_openers

    def _is_of_other_calendar(self, piece: Piece) -> bool:
        """Whether it is a feast on a day that is not known here: "chinese new year"."""
        return not self._of_other_calendars.isdisjoint(range(piece.start, piece.end))

    @cached_property
    def _of_other_calendars(self) -> frozenset[int]:
        """The places of days that are not known here."""
        return frozenset(place for place in range(1, len(self.texts)) if self._is_unknown_day(place))

    def _is_unknown_day(self, place: int) -> bool:
        """Whether a day stands at a place that an unknown calendar has: "parsi new year"."""
        calendar, named = ("", *self.texts[:place])[-2:]
        if [calendar, named] == BANK_HOLIDAY:
            # "On bank holiday monday"
            return self.around.is_weekday(place)
        others = self.lexicon.other_calendars
        if named in others:
            feast = any(one.start == place for one in self._feasts)
        else:
            # "Orthodox great friday"
            feast = calendar in others and named in self.beside.holy and self.around.is_weekday(place)
        # A later word of a feast's name, whose calendar is known: "orthodox easter"
        return feast and not any(one.start < place < one.end for one in self._feasts)

    @cached_property
    def _feasts(self) -> tuple[Piece, ...]:
        """All feasts that are named."""
        found = (one for place in range(len(self.texts)) for one in self.around.pieces(place))
        return tuple(one for one in found if one.category == "feast")

    def _is_of_feast(self, piece: Piece) -> bool:
        """Whether it begins within what is surely the name of a feast: "black friday deals"."""
        sure = (one for one in self._feasts if not one.value.doubtful)
        return any(one.start < piece.start < one.end for one in sure)
