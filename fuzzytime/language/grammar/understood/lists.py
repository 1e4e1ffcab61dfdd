"""Several times of one thing, said as a list: "at eight, noon and again at six", "on the 5th and the 12th".

All are meant, or one ("at seven or at eight"). What a member leaves out its neighbours give (``filled``).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.calendar import is_weekday
from fuzzytime.language.meaning.days.nested import Within
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat, TimeWord
from fuzzytime.language.meaning.joined.bounded_repeats import is_of_day
from fuzzytime.requirement import BOUNDS, Constraint

LIST = 2
"""Weekdays side by side, without "and", that are hardly a list."""

TYPED_JOINTS = frozenset({"/", "+"})
"""Marks between two clock times that are both meant."""


@dataclass(frozen=True, slots=True)
class TimeList:
    """The times of a list, in their order; of those ``either`` joins, one is kept."""

    members: tuple[Phrase, ...]
    either: bool

    @property
    def further(self) -> Span:
        """Where its times stand behind the first."""
        return self.members[0].span[1], self.members[-1].span[1]

    def is_closed(self, words: Sequence[Word], lexicon: Lexicon) -> bool:
        """Whether the last is none of what follows: "at six and at seven"; but "…, and at seven ring Ann"."""
        first, last = self.members[0], self.members[-1]
        if first.said.preposition == "for":
            # "Order flowers for saturday and sunday"
            return False
        if last.said.preposition is None:
            return True
        if last.end == len(words) or not first.first:
            return True
        follower = words[last.end].text
        ends = lexicon.beside.polite_ends | lexicon.closed.further_clause | {")"}
        more = follower in lexicon.closed.prepositions_behind_times
        led = longest_match(words, last.end, lexicon.clauses) is not None
        # "Feed the cat at six, and at seven, ring Ann"
        apart = follower == "," and words[self.members[-2].end].text == ","
        return (follower in ends and not apart) or more or led


def lists_of(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[TimeList]:
    """Give the lists among the times of a text."""
    place = 0
    while place < len(phrases):
        group, joints = _joined(phrases[place:], words, lexicon)
        either = not joints.isdisjoint(lexicon.closed.alternatives)
        named = either or bool(joints & lexicon.closed.additions - {","})
        if len(group) > 1 and (named or _are_several(group) or _are_two_days(group, words, lexicon)):
            yield TimeList(tuple(group), either)
        place += len(group)


def closed_lists(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> list[TimeList]:
    """Give the lists of which each is of one thing, whatever stands behind it."""
    return [times for times in lists_of(phrases, words, lexicon) if times.is_closed(words, lexicon)]


def _are_several(group: Sequence[Phrase]) -> bool:
    """Whether times that only commas join are no one time."""
    several = len(group) > LIST and (all(map(_is_weekday, group)) or all(map(_is_clock, group)))
    # "Friday at nine, saturday at ten", "at ten, at sunset", "twice in the morning, once at night"
    alike = all(map(_is_whole, group)) or all(map(_is_at, group))
    return several or alike or any(map(_is_counted, group))


def _are_two_days(group: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether they are two weekdays that end what is said: "gym tue thu", "home tues, thurs next week"."""
    behind = [word.text for word in words[group[-1].end : group[-1].end + 1]]
    ends = lexicon.closed.end_of_an_order | {",", ")"} >= {*behind}
    typed = all(_is_weekday(one) and one.said.preposition is None for one in group)
    return typed and ends and group[0].first > 0 and not any(one.said.wall.is_timed for one in group)


def _joined(
    phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon
) -> tuple[list[Phrase], set[str]]:
    """Give the first time with those that are joined to it, and the words that join them."""
    group, joints = [phrases[0]], set[str]()
    for following in phrases[1:]:
        between = _between(group[-1], following, words, lexicon)
        if not between or between - lexicon.closed.additions - lexicon.closed.alternatives:
            break
        pair = (group[-1], following)
        if between == {","} and len({*map(_is_counted, pair)}) > 1:
            # "Twice tomorrow, at eight and six"
            break
        either = not between.isdisjoint(lexicon.closed.alternatives)
        both = not either and _are_two_of_a_day(*pair)
        if not both and not all(_is_when(one) or (either and one.said.constraint in BOUNDS) for one in pair):
            break
        group.append(following)
        joints |= between
    return group, joints


def _between(first: Phrase, second: Phrase, words: Sequence[Word], lexicon: Lexicon) -> set[str]:
    """Give what joins two times, as if it were said in full."""
    between, beside, pair = (
        {word.text for word in words[first.end : second.first]},
        lexicon.beside,
        (first, second),
    )
    joined: set[str] = between & lexicon.closed.joints_of_things
    again = (beside.again | beside.beside_twice) - {"then"}
    if joined and between & beside.twice & beside.again and between <= again:
        # "At eight, again at ten and once more at noon"; but "one at eight and another one at noon"
        return {"and"}
    if joined and between - joined <= beside.one_time:
        # "Once in the morning and once at night"
        return joined
    if between & beside.second_choice:
        # "Today if you can, otherwise tomorrow", "at noon or, failing that, at two"
        between -= beside.courteous | lexicon.closed.singular_anaphors
    if between <= {"/"} and all(map(_is_weekday, pair)):
        # "Monday wednesday and friday", as it is said; "mon/wed/fri", "tue/thu at six"
        return {"&"} if between else {","}
    if between and between <= TYPED_JOINTS and all(map(_is_clock, pair)):
        # "7am/7pm", "7am + 7pm"
        return {"&"}
    if not between and (all(map(_is_clock, pair)) or all(map(_is_whole, pair))):
        # "For 6 am 6 15 am and 6 30 am", as it is said
        return {","}
    return between


def _are_two_of_a_day(first: Phrase, second: Phrase) -> bool:
    """Whether one of two is beside a meal, and both bound no stretch: "before breakfast and at six"."""
    meals = [one for one in (first, second) if _is_beside_meal(one)]
    others = [one for one in (first, second) if not _is_beside_meal(one)]
    if not meals or not all(_is_when(one) and is_of_day(one.said.time) for one in others):
        return False
    parts = {one.said.constraint: one.said.wall.part for one in meals}
    begins, ends = parts.get(Constraint.AFTER), parts.get(Constraint.BEFORE)
    # "Before dinner and after work"
    return begins is None or ends is None or begins.end > ends.start


def _is_beside_meal(phrase: Phrase) -> bool:
    """Whether it is before or after a meal of a day that is not said."""
    said, part = phrase.said, phrase.said.wall.part
    beside = said.constraint in BOUNDS and said.preposition in {"before", "after"}
    return beside and part is not None and part.meal and is_of_day(said.time)


def _is_when(phrase: Phrase) -> bool:
    """Whether it is a time at which something may be done, and not a bound, a length or a repetition."""
    said = phrase.said
    if isinstance(said.time, TimeWord):
        return (said.constraint or said.time.constraint) is Constraint.AT
    if isinstance(said.time, Duration):
        return said.constraint is Constraint.AT
    if _is_counted(phrase):
        return True
    return said.constraint in {None, Constraint.AT, Constraint.BETWEEN} and not isinstance(said.time, Repeat)


def _is_counted(phrase: Phrase) -> bool:
    """Whether it is so many times in one stretch: "twice in the afternoon"."""
    time = phrase.said.time
    return isinstance(time, Repeat) and time.times is not None and time.every is None and not time.apart


def _is_weekday(phrase: Phrase) -> bool:
    """Whether it is a day of the week, with or without a time of day, or which week it is of."""
    days = phrase.said.wall.days
    return is_weekday(days.inner if isinstance(days, Within) else days)


def _is_clock(phrase: Phrase) -> bool:
    """Whether it is a clock time of a day that is not said."""
    return phrase.said.wall.clock is not None and phrase.said.wall.days is None


def _is_whole(phrase: Phrase) -> bool:
    """Whether it is a clock time of a day that is said."""
    return phrase.said.wall.clock is not None and phrase.said.wall.days is not None


def _is_at(phrase: Phrase) -> bool:
    """Whether it is at a time of a day that is not said."""
    wall = phrase.said.wall
    return phrase.said.preposition == "at" and wall.is_timed and wall.days is None
