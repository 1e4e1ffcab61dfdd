"""Several clock times in a row, as on one day: "for six six fifteen and six thirty", "at 8, 12 and 4"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.surroundings.surroundings import Around
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.times_of_day import Clock

HOURS = 12
FEWEST_MINUTES = 10
MINUTES = 60
LEAST = 2
"""Clock times behind the first of such a list, at least."""

JOINTS = frozenset({"and", "or"})

Stretch = tuple[int, int]
"""Places of words, from the first to behind the last."""


class RunOnHours(Around):
    """Lists of clock times within half a day, each behind the one before it, with "and" before the last."""

    def behind(self, clock: Clock | None, place: int) -> list[Stretch]:
        """Give where the clock times behind the first of a list stand, which ends at a place; [] without."""
        if clock is None or not clock.is_open:
            return []
        found = self._rest(place, clock.hour % HOURS * MINUTES + clock.minute, 0)
        return found if len(found) >= LEAST else []

    def _rest(self, place: int, first: int, before: int) -> list[Stretch]:
        """Give the clock times from a place on, each so many minutes after the first, and after the last."""
        place += self.texts[place : place + 1] == [","]
        last = self.texts[place : place + 1] == ["and"]
        for end, minutes in self._clocks(place + last):
            behind = (minutes - first) % (HOURS * MINUTES)
            if behind <= before:
                continue
            if last and self._ends(place, end):
                return [(place + 1, end)]
            more = [] if last else self._rest(end, first, behind)
            if more:
                return [(place, end), *more]
        return []

    def _ends(self, place: int, end: int) -> bool:
        """Whether nothing is counted by the last of them: "cut boards at 3, 5 and 8 feet"."""
        piece = Piece("said", place, end, None, 0.0, "")
        return self._number(end) is None and not self.around.is_unit(end) and self.around.may_end(piece)

    def _clocks(self, place: int) -> Iterator[tuple[int, int]]:
        """Give where an hour, with minutes or without, ends that begins at a place, and its minutes."""
        hour = self._number(place)
        if hour is None or not 1 <= hour <= HOURS:
            return
        first, second = self._number(place + 1), self._number(place + 2)
        if first is not None and FEWEST_MINUTES <= first < MINUTES:
            tens = first % FEWEST_MINUTES == 0 and first > FEWEST_MINUTES
            if tens and second is not None and 1 <= second < FEWEST_MINUTES:
                yield place + 3, hour % HOURS * MINUTES + first + second
            yield place + 2, hour % HOURS * MINUTES + first
        yield place + 1, hour % HOURS * MINUTES

    def _number(self, place: int) -> int | None:
        """Give the number that a word is."""
        text = self.texts[place] if 0 <= place < len(self.texts) else ""
        known = self.lexicon.numbers.get(text)
        return int(text) if text.isdecimal() else None if known is None else int(known)


def typed_apart(words: Sequence[Word]) -> list[Word]:
    """Give the words of a list of hours that was typed without spaces as if it had some: "at 1,2 or 3"."""
    found = list(words)
    for place in (p + 1 for p, word in enumerate(words) if word.text in {"at", "@"}):
        end = place
        while _is_hour(words, end) and [word.text for word in words[end + 1 : end + 2]] == [","]:
            end += 2
        if end > place and _is_hour(words, end) and words[end + 1 :] and words[end + 1].text in JOINTS:
            found[place + 1 : end + 1] = [replace(word, glued=False) for word in words[place + 1 : end + 1]]
    return found


def _is_hour(words: Sequence[Word], place: int) -> bool:
    word = next(iter(words[place : place + 1]), None)
    return word is not None and word.is_digits and 1 <= int(word.text) <= HOURS
