"""The weeks, or days, of a plan that lines count from one on: "Week 1", then "Day 2: rest the legs"."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import groupby, pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.days.relations import Numbered
from fuzzytime.requirement import Unit

MARK = re.compile(
    r"[\s>*#•+-]*(?P<name>(?P<unit>[a-z]+)\s+(?P<number>\d{1,2}|[a-z]+)(?:\s?[-–—]\s?(?P<last>\d{1,2}))?)"
    r"[\s*]*(?:[:.)–—-][\s*]*|(?=\()|\Z)",
    re.IGNORECASE,
)
"""A word, its number, and what parts them from the rest of a line."""

COUNTED = (Unit.WEEK, Unit.DAY)


@dataclass(frozen=True, slots=True)
class NumberedPeriod:
    """What a line says of where it stands in a plan: the stretch of its words, their name, and when that is.

    Without ``days`` the words are only a title: "Week 3" alone, long after the third week of the year.
    """

    span: Span
    name: str
    days: Numbered | None


def numbered_periods(
    entries: Sequence[tuple[str, datetime | None]], lexicon: Lexicon
) -> list[NumberedPeriod | None]:
    """Give for each line the period of a plan that it begins with, where lines count such from one on.

    So does one alone above all others, where the year's week of its number is over: "Week 3".
    """
    found: list[NumberedPeriod | None] = [None] * len(entries)
    marks = [(place, one) for place, (text, _) in enumerate(entries) for one in _marks_in(text, lexicon)]
    for now, said in groupby(marks, key=lambda mark: entries[mark[0]][1]):
        lines = list(said)
        for unit in COUNTED:
            same = [(place, span, name, days) for place, (span, name, days) in lines if days.unit is unit]
            numbers = [days.number for *_, days in same]
            series = numbers[:1] == [1] and all(one < other for one, other in pairwise(numbers))
            title = len(same) == 1 and same[0][0] == 0 and len(entries) > 1 and _is_over(same[0][3], now)
            counted = series and (len(same) > 1 or same[0][0] == 0)
            for place, span, name, days in same if counted or title else ():
                found[place] = NumberedPeriod(span, name, days if series else None)
    return found


def _marks_in(text: str, lexicon: Lexicon) -> list[tuple[Span, str, Numbered]]:
    match = MARK.match(text)
    entries = () if match is None else lexicon.entries.get(match["unit"].lower(), ())
    unit = next((entry.value.unit for entry in entries if entry.category == "unit"), None)
    if match is None or unit not in COUNTED:
        return []
    first = _number(match["number"], lexicon)
    last = _number(match["last"] or match["number"], lexicon)
    if first is None or last is None:
        return []
    days = Numbered(first, unit, last - first + 1)
    return [((match.start("name"), match.end()), match["name"], days)] if first <= last else []


def _number(said: str, lexicon: Lexicon) -> int | None:
    return int(said) if said.isdigit() else lexicon.numbers.get(said.lower())


def _is_over(days: Numbered, now: datetime | None) -> bool:
    """Whether that week of the year of a moment is over."""
    return days.unit is Unit.WEEK and now is not None and days.number < now.isocalendar().week
