"""Reading ``calendar.yaml``: feasts and seasons."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import Any

from fuzzytime.language.grammar.word_tables.tables import Tables
from fuzzytime.language.meaning.calendars.east_asian import (
    CHINA,
    KOREA,
    VIETNAM,
    OnEastAsianDate,
    OnSolarTerm,
)
from fuzzytime.language.meaning.calendars.easter import FromEaster
from fuzzytime.language.meaning.calendars.hebrew import OnHebrewDate
from fuzzytime.language.meaning.calendars.hindu import At, OnLunarDay, OnStar, OnSunsEntry
from fuzzytime.language.meaning.calendars.islamic import OnIslamicDate
from fuzzytime.language.meaning.calendars.observance import Observance, OnDate, OnWeekday
from fuzzytime.language.meaning.calendars.persian import OnPersianDate
from fuzzytime.language.meaning.feasts import Feast, OneOf, Season
from fuzzytime.yaml_nodes import Node

MOST_DAYS = 366
"""How far a feast is from another, and how long it lasts, at most."""

FROM_EVENING = frozenset({"hebrew", "islamic"})
"""Calendars whose days begin in the evening before."""

OF_LUNAR_DAYS = frozenset({"at", "later"})
"""What is said of Hindu feasts only."""

MOST_MONTHS, MOST_DAYS_OF_MONTH = 12, 31

Read = Callable[[Node, str], Observance]


def read_feasts(tables: Tables) -> None:
    """Add feasts and seasons."""
    _Feasts(tables).read()

    def season(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        begins = _month_day(tables, fields["from"], f"seasons.{name}.from")
        return [("season", Season(name, begins, _month_day(tables, fields["to"], f"seasons.{name}.to")))]

    tables.table("seasons", {"from": True, "to": True}, season)


class _Feasts:
    """The holidays of a calendar, which may tell of those above them."""

    def __init__(self, tables: Tables) -> None:
        self.tables = tables
        self.reader = tables.reader
        self.weekdays = self._numbers("weekdays")
        self.months = self._numbers("months")
        self.found: dict[str, Feast] = {}
        self.calendars: dict[str, Read] = {
            "date": self._date,
            "nth": self._nth,
            "easter": partial(self._easter, orthodox=False),
            "orthodox easter": partial(self._easter, orthodox=True),
            "hebrew": partial(self._lunar, kind=OnHebrewDate),
            "islamic": partial(self._lunar, kind=OnIslamicDate),
            "chinese": partial(self._lunar, kind=partial(OnEastAsianDate, hours=CHINA)),
            "korean": partial(self._lunar, kind=partial(OnEastAsianDate, hours=KOREA)),
            "vietnamese": partial(self._lunar, kind=partial(OnEastAsianDate, hours=VIETNAM)),
            "solar term": self._solar_term,
            "persian": partial(self._lunar, kind=OnPersianDate),
            "hindu": self._lunar_day,
            "hindu sun": self._suns_entry,
            "hindu star": self._star,
            "one of": self._one_of,
        }

    def read(self) -> None:
        """Add them."""
        others = ("days", "moves", "lasts", "until", "doubtful", *OF_LUNAR_DAYS)
        self.tables.table("holidays", dict.fromkeys((*self.calendars, *others), False), self._feast)

    def _numbers(self, section: str) -> dict[str, int]:
        rows = self.tables.rows(section)
        return {form[0]: int(name.text) for name, node in rows for form in self.tables.forms(node, "")}

    def _feast(self, name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        key = f"holidays.{name}"
        named = [calendar for calendar in self.calendars if calendar in fields]
        if len(named) != 1:
            if fields:
                at, known = next(iter(fields.values())), ", ".join(map(repr, self.calendars))
                self.reader.mistake(at, key, f"a holiday needs one of {known}, got {len(named) or 'none'}")
            return []
        (calendar,) = named
        kept = self.calendars[calendar](fields[calendar], f"{key}.{calendar}")
        if isinstance(kept, (OnLunarDay, OnSunsEntry)):
            kept = self._at(kept, key, fields)
        else:
            for field in OF_LUNAR_DAYS & fields.keys():
                message = f"{field!r} is for Hindu feasts, got {calendar!r}"
                self.reader.mistake(fields[field], f"{key}.{field}", message)
        feast = Feast(
            name,
            kept,
            self._whole(fields, key, "days", -MOST_DAYS, 0),
            self._moves(fields, key),
            self._whole(fields, key, "lasts", 1, 1),
            self._until(fields, key),
            calendar in FROM_EVENING,
            "doubtful" in fields and self.reader.boolean(fields["doubtful"], f"{key}.doubtful"),
        )
        self.found[name] = feast
        return [("feast", feast)]

    def _whole(self, fields: dict[str, Node], key: str, name: str, low: int, usual: int) -> int:
        return self.reader.whole(fields[name], f"{key}.{name}", low, MOST_DAYS) if name in fields else usual

    def _moves(self, fields: dict[str, Node], key: str) -> tuple[tuple[int, int], ...]:
        if "moves" not in fields:
            return ()
        days = self.reader.mapping(fields["moves"], f"{key}.moves", self.weekdays)
        return tuple(
            (self.weekdays[weekday], self.reader.whole(node, f"{key}.moves.{weekday}", -7, 7))
            for weekday, node in days.items()
        )

    def _until(self, fields: dict[str, Node], key: str) -> Feast | None:
        if "until" not in fields:
            return None
        # A feast that stands above.
        return self.found.get(self.reader.choice(fields["until"], f"{key}.until", self.found))

    # -- calendars --------------------------------------------------------------------------------------

    def _date(self, node: Node, key: str) -> Observance:
        return OnDate(*_month_day(self.tables, node, key))

    def _nth(self, node: Node, key: str) -> Observance:
        items = self.reader.sequence(node, key, 3)
        if not items:
            return OnWeekday(1, 0, 1)
        nth = self.reader.whole(items[0], f"{key}[0]", -4, 4) or 1
        weekday = self.weekdays.get(self.reader.choice(items[1], f"{key}[1]", self.weekdays), 0)
        return OnWeekday(
            nth, weekday, self.months.get(self.reader.choice(items[2], f"{key}[2]", self.months), 1)
        )

    def _easter(self, node: Node, key: str, *, orthodox: bool) -> Observance:
        return FromEaster(self.reader.whole(node, key, -MOST_DAYS, MOST_DAYS), orthodox)

    def _solar_term(self, node: Node, key: str) -> Observance:
        return OnSolarTerm(self.reader.whole(node, key, 0, 359))

    def _lunar(self, node: Node, key: str, *, kind: Callable[[int, int], Observance]) -> Observance:
        """Read month and day of a calendar with other months."""
        return kind(*_month_day(self.tables, node, key, other=True))

    def _lunar_day(self, node: Node, key: str) -> Observance:
        return OnLunarDay(*_month_day(self.tables, node, key, other=True))

    def _suns_entry(self, node: Node, key: str) -> Observance:
        return OnSunsEntry(self.reader.whole(node, key, 0, 359))

    def _star(self, node: Node, key: str) -> Observance:
        items = self.reader.sequence(node, key, 2)
        if not items:
            return OnStar(0, 1)
        sign = self.reader.whole(items[0], f"{key}[0]", 0, 11)
        return OnStar(sign, self.reader.whole(items[1], f"{key}[1]", 1, 27))

    def _at(self, kept: OnLunarDay | OnSunsEntry, key: str, fields: dict[str, Node]) -> Observance:
        """Read at which time of the day it is to prevail, and which of two such days it is."""
        said = self.reader.choices(fields["at"], f"{key}.at", list(At)) if "at" in fields else ()
        times = tuple(At(time) for time in said if time)
        if isinstance(kept, OnSunsEntry):
            return replace(kept, at=times[0]) if times else kept
        later = "later" in fields and self.reader.boolean(fields["later"], f"{key}.later")
        return replace(kept, at=times or kept.at, later=later)

    def _one_of(self, node: Node, key: str) -> Observance:
        """Read feasts that stand above, on the days of any of which it is."""
        names = self.reader.choices(node, key, self.found)
        return OneOf(tuple(self.found[name] for name in names if name in self.found))


def _month_day(tables: Tables, node: Node, key: str, *, other: bool = False) -> tuple[int, int]:
    text = tables.reader.string(node, key)
    month, _, day = text.partition("-")
    if month.isdecimal() and day.isdecimal() and 1 <= int(month) <= MOST_MONTHS:
        longest = MOST_DAYS_OF_MONTH if other else 28 + 3 * (int(month) != 2)
        if 1 <= int(day) <= longest:
            return int(month), int(day)
    shown = "month and day must look like 12-24" if other else "a day of the year must look like 12-24"
    tables.reader.mistake(node, key, f"{shown}, got {text!r}")
    return 1, 1
