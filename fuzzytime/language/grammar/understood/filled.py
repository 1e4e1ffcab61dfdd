"""What the members of a list of times give each other: an hour, minutes past one, a month, a part of the day.

"On the 3rd and 17th at noon", "at ten past and half past three", "on the nights of the 4th and 5th".
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from fuzzytime.language.grammar.understood.crossed import crossed, first_of, is_listed
from fuzzytime.language.grammar.understood.lists import TimeList
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.calendar import Fields, is_day_of_month, is_weekday
from fuzzytime.language.meaning.days.nested import Within
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import (
    Duration,
    HourMark,
    Phrase,
    Range,
    Repeat,
    Time,
    Wall,
    wall_of,
)
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.requirement import BOUNDS

ON_CONDITION = "if_it_is.at_on_condition"
"""The rule of a clock time that a condition of the calendar stands behind."""

MERIDIEMS = frozenset({"am", "pm", "noon", "midnight"})
"""Words that end a clock time, and are no day."""

HOUR, MINUTE = 3600, 60


def filled(times: TimeList, words: Sequence[Word]) -> list[Phrase]:
    """Give the members of a list with what their neighbours give; of several kept, the others say so."""
    members = _with_part_of(_with_month_behind(times.members), words)
    members = _before_day(members if times.either else apart(members), words)
    # "Today if you can, otherwise tomorrow at ten": today at any time
    near = times.either and any(isinstance(one.said.wall.days, Relative) for one in members)
    if not near:
        hourly = _in_hour_behind(_in_other_parts(members))
        members = crossed(hourly, partial(_ends_with_day, words=words), either=times.either)
    if not times.either:
        return members
    first, *others = _behind_day(members)
    return [first, *(_bound_as(first, one) for one in others)]


def as_one(lists: Sequence[TimeList], phrases: Sequence[Phrase], words: Sequence[Word]) -> list[Phrase]:
    """Give times of which each list is one, with the meaning of its first."""
    found = [phrase for phrase in phrases if not any(phrase in times.members for times in lists)]
    for times in lists:
        first, last = filled(times, words)[0], times.members[-1]
        found.append(replace(first, end=last.end, span=(first.span[0], last.span[1])))
    return sorted(found, key=lambda phrase: phrase.first)


def apart(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give times for one thing with clock times that are said twice in both halves of a day: "at 8 and 8"."""
    clocks = [_open(phrase) for phrase in phrases]
    found = []
    for place, phrase in enumerate(phrases):
        time, clock = phrase.said.time, clocks[place]
        if clock is not None and isinstance(time, Wall) and clocks.count(clock) > 1:
            half = Half.PM if clock in clocks[:place] else Half.AM
            decided = replace(time, clock=replace(time.clock, half=half)) if time.clock else time
            found.append(phrase.at(decided))
        else:
            found.append(phrase)
    return found


def _open(phrase: Phrase) -> tuple[int, int, int] | None:
    """Give a clock time without am or pm, and without a day."""
    wall = phrase.said.wall
    clock = wall.clock if wall.days is None and wall.part is None else None
    return None if clock is None or not clock.is_open else (clock.hour, clock.minute, clock.shift)


def _in_hour_behind(members: Sequence[Phrase]) -> list[Phrase]:
    """Give minutes of no hour that which is said behind: "at ten to, quarter past and half past three"."""
    found = list(members)
    for place in range(len(members) - 2, -1, -1):
        mark, wall = found[place].said.time, found[place + 1].said.wall
        if isinstance(mark, HourMark) and mark.open and wall.clock is not None and wall.clock.shift:
            shift = mark.minute * MINUTE
            shift -= HOUR if shift > wall.clock.shift else 0
            found[place] = found[place].at(replace(wall, clock=replace(wall.clock, shift=shift)))
    return found


def _in_other_parts(members: Sequence[Phrase]) -> list[Phrase]:
    """Give a part of the day alone the hours of the one before: "six to eight, morning and evening"."""
    found = [members[0]]
    for member in members[1:]:
        wall, giver = member.said.wall, found[-1].said
        part = wall.part if wall == Wall(part=wall.part) and member.said.preposition is None else None
        first = first_of(giver)
        clock = None if first.part is None or first.clock is None else replace(first.clock, half=None)
        hours = () if clock is None or part is None else clock.candidates()
        if part is not None and any(part.start - HOUR <= seconds < part.end for seconds in hours):
            found.append(replace(member, said=replace(giver, time=_in_part(giver.time, part))))
        else:
            found.append(member)
    return found


def _in_part(time: Time | Duration | Repeat, part: Part) -> Time:
    """Give a time of day, or hours, in another part of the day."""
    if isinstance(time, Range):
        return replace(time, first=_in_part(time.first, part), last=_in_part(time.last, part))
    wall = wall_of(time)
    return replace(wall, part=part, clock=None if wall.clock is None else replace(wall.clock, half=None))


def _with_part_of(phrases: Sequence[Phrase], words: Sequence[Word]) -> list[Phrase]:
    """Give days of a list the part that the first is of: "on the nights of the 4th and 5th"."""
    walls = [phrase.said.wall for phrase in phrases]
    of = "of" in (word.text for word in words[phrases[0].first : phrases[0].end])
    parted = walls[0].part is not None and not any(wall.part for wall in walls[1:])
    if not of or not parted or not all(map(is_listed, walls)):
        return list(phrases)
    clock = walls[0].clock or walls[-1].clock
    told = (replace(wall, part=walls[0].part, clock=wall.clock or clock, weak=False) for wall in walls)
    return [phrase.at(wall) for phrase, wall in zip(phrases, told, strict=True)]


def _with_month_behind(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give days of a list the month, and the year, of the last of them: "on the 5th, 6th or 9th of may".

    So is the week of the last that of all: "mon, wed and fri next week".
    """
    last = phrases[-1].said.wall.days
    if isinstance(last, Within) and is_weekday(last.inner):
        given = ((phrase, phrase.said.wall) for phrase in phrases)
        return [
            phrase.at(replace(wall, days=replace(last, inner=wall.days)))
            if wall.days is not None and is_weekday(wall.days)
            else phrase
            for phrase, wall in given
        ]
    if not isinstance(last, Fields) or last.day is None or last.month is None:
        return list(phrases)
    found = []
    for phrase in phrases:
        wall = phrase.said.wall
        if isinstance(wall.days, Fields) and is_day_of_month(wall.days):
            dated = replace(wall.days, month=last.month, year=last.year)
            found.append(phrase.at(replace(wall, days=dated)))
        else:
            found.append(phrase)
    return found


def _before_day(members: Sequence[Phrase], words: Sequence[Word]) -> list[Phrase]:
    """Give clock times the day, or the part of it, behind the last: "at six and eight tomorrow".

    A day in front of its clock time is lent to none before, nor is a part to what is later in it: "at five or
    tomorrow at nine", "at ten and two in the afternoon".
    """
    last = members[-1]
    if not _ends_with_day(last, words):
        return list(members)
    whole, ends = last.said.wall, _in_half_day(last.said.wall)
    day = replace(whole, part=None)
    return [_on_day(one, whole if _in_half_day(one.said.wall) < ends else day) for one in members]


def _in_half_day(wall: Wall) -> int:
    """Give the seconds since noon or midnight of a clock time."""
    return 0 if wall.clock is None else wall.clock.seconds % (12 * HOUR)


def _behind_day(members: Sequence[Phrase]) -> list[Phrase]:
    """Give clock times the day, or the part of it, of the one before: "tomorrow at six or at seven"."""
    whole, found = None, []
    for member in members:
        wall = member.said.wall
        dated = wall.days is not None or wall.part is not None
        whole = wall if wall.clock is not None and dated else whole
        found.append(_on_day(member, whole))
    return found


def _on_day(phrase: Phrase, whole: Wall | None) -> Phrase:
    """Give a clock time alone the day of another."""
    clock = phrase.said.wall.clock
    alone = whole is not None and clock is not None and phrase.said.time == Wall(clock=clock)
    return phrase.at(replace(whole, clock=clock)) if whole is not None and alone else phrase


def _ends_with_day(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a day, or a part of it, stands behind a clock time: "at seven tomorrow".

    A condition holds for its own time alone: "at seven, or at eight if it's sunday".
    """
    if phrase.rule == ON_CONDITION:
        return False
    wall, last = phrase.said.wall, words[phrase.end - 1].text
    dated = wall.clock is not None and (wall.days is not None or wall.part is not None)
    before = [word.text for word in words[phrase.first : phrase.end - 1]]
    return dated and last.isalpha() and "at" not in before[1:] and last not in MERIDIEMS


def _bound_as(first: Phrase, phrase: Phrase) -> Phrase:
    """Give what may be kept instead of a time; a number alone has its side: "by six or eight"."""
    said, bound = replace(phrase.said, alternative=True), first.said
    if bound.constraint in BOUNDS and said.preposition is None and phrase.said.constraint is None:
        said = replace(said, constraint=bound.constraint, preposition=bound.preposition)
    return replace(phrase, said=said)
