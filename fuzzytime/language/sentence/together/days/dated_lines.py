"""Lines that begin with a day, above others with the hours of that day: "Fri 6 - Lisbon", "Sat: show day".

Where one typed date begins with the day, all do: "9/3 eye clinic", "17/3 scan".
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Phrase, Wall, wall_of
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import Heading
from fuzzytime.language.sentence.together.days.titles import (
    APART,
    LONGEST,
    begins_order,
    held,
    is_of_calendar,
    names_day,
)
from fuzzytime.language.sentence.together.days.windows import clocks_in
from fuzzytime.requirement import Unit

DAY_FIRST = re.compile(r"(?<![\d/])(?:1[3-9]|2\d|3[01])/(?:0?[1-9]|1[0-2])(?![\d/])")
"""A date that begins with the day, as no month is so high."""

AHEAD = 14
"""Days within which a number behind a weekday is its date: "Fri 6"."""

FEWEST, NEAR = 2, 4
"""Lines with hours below one that heads them, at least, and among how many."""


def with_dates(drafts: Sequence[Draft]) -> list[Draft]:
    """Give drafts in which the number behind a weekday in front is its date, not an hour: "Fri 6 - Lisbon".

    So it is on that date, above lines with the hours of that day, or where another line begins so.
    """
    if any(DAY_FIRST.search(draft.text) for draft in drafts):
        drafts = [replace(one, phrases=tuple(map(_with_day_first, one.phrases))) for one in drafts]
    dated = [_dated(draft) for draft in drafts]
    several = sum(one is not None for one in dated) > 1
    return [
        replace(draft, phrases=(date, *draft.phrases[1:]))
        if date is not None and (several or _has_hours(drafts, place))
        else draft
        for place, (draft, date) in enumerate(zip(drafts, dated, strict=True))
    ]


def _with_day_first(phrase: Phrase) -> Phrase:
    """Give a date of two numbers that may change places the first as its day."""
    wall = phrase.said.time
    days = wall.days if isinstance(wall, Wall) else None
    turns = isinstance(days, Fields) and days.turnable and days.weekday is None
    if not (isinstance(wall, Wall) and isinstance(days, Fields) and turns):
        return phrase
    return phrase.at(replace(wall, days=replace(days, month=days.day, day=days.month, turnable=False)))


def _dated(draft: Draft) -> Phrase | None:
    """Give the weekday and date that a line begins with, if its number is not an hour for sure."""
    first = next((phrase for phrase in draft.phrases if phrase.first == 0), None)
    time = None if first is None else first.said.time
    if first is None or not isinstance(time, Wall) or time.clock is None or draft.now is None:
        return None
    words, hour = draft.scanned.words, time.clock.hour
    behind = "".join(word.text for word in words[first.end : first.end + 1])
    apart = behind == "" or behind in APART
    if not apart or not isinstance(time.days, Fields) or words[first.end - 1].text != str(hour):
        return None
    ahead = (draft.now + timedelta(days=days) for days in range(AHEAD))
    fits = any((day.weekday(), day.day) == (time.days.weekday, hour) for day in ahead)
    date = Wall(replace(time.days, day=hour))
    return replace(first, said=replace(first.said, time=date, clocks=None)) if fits else None


def heads_lines(drafts: Sequence[Draft], place: int) -> bool:
    """Whether a line names a day, and what that is about, above lines with the hours of it."""
    draft = drafts[place]
    if len(draft.phrases) != 1 or not (names_day(draft.phrases[0]) and is_of_calendar(draft.phrases[0])):
        return False
    (day,), words = draft.phrases, draft.scanned.words
    behind = words[day.end : day.end + 1]
    apart = day.first == 0 and all(word.text in APART for word in behind) and len(words) - day.end <= LONGEST
    return apart and _has_hours(drafts, place) and not begins_order(draft)


def days_gone_on_with(drafts: Sequence[Draft]) -> list[Heading | None]:
    """Give for each line with an hour and no day the day that the line before it begins with.

    So it is where two lines at least begin with their days: "Sat - castle at ten", "boat 2.30", "Sun - home".
    """
    begun = [_day_in_front(draft) for draft in drafts]
    several = len({wall_of(day.said.time).days for day in begun if day is not None}) > 1
    found: list[Heading | None] = []
    heading: Heading | None = None
    for place, (draft, day) in enumerate(zip(drafts, begun, strict=True)):
        if place and draft.now != drafts[place - 1].now:
            heading = None
        if day is not None:
            name = draft.text[slice(*day.span)]
            heading = Heading(name, draft.text, draft.scanned, held(draft, (day,)))
        timed = clocks_in(draft) and not any(map(names_day, draft.phrases))
        found.append(heading if several and timed else None)
    return found


def _day_in_front(draft: Draft) -> Phrase | None:
    """Give the day that a line begins with, and not every such day, without its hour."""
    first = next((phrase for phrase in draft.phrases if phrase.first == 0), None)
    wall = None if first is None else first.said.time
    if first is None or not isinstance(wall, Wall) or wall.days is None or wall.days.grain is not Unit.DAY:
        return None
    return first.at(Wall(wall.days)) if first.said.preposition is None else None


def _has_hours(drafts: Sequence[Draft], place: int) -> bool:
    """Whether lines below have hours, and none of them a day of its own."""
    below = drafts[place + 1 : place + 1 + NEAR]
    return sum(bool(clocks_in(draft)) for draft in below) >= FEWEST and not any(
        names_day(phrase) for draft in below[:FEWEST] for phrase in draft.phrases
    )
