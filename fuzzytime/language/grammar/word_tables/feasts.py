"""Reading ``calendar.yaml``: feasts and seasons, and how their names are written: "st. andrews day"."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from fuzzytime.documents.nodes import Node, Scalar, Sequence
from fuzzytime.language.grammar.lexicon import Entry, Form
from fuzzytime.language.grammar.word_tables.tables import Row, Tables, numbered
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

MOST_DAYS = 366
"""How far a feast is from another, and how long it lasts, at most."""

NTHS = ("-4", "-3", "-2", "-1", "1", "2", "3", "4")
"""Which weekday of a month there is in every one, from its end where negative."""

FROM_EVENING = frozenset({"hebrew", "islamic"})
"""Calendars whose days begin in the evening before."""

OF_LATIN_SCRIPT = (OnDate, OnWeekday, FromEaster, OneOf)
"""Calendars whose feasts have names that are spelt in one way."""

OF_SOME = {"at": ("hindu", "hindu sun"), "later": ("hindu",)}
"""What is said of the feasts of some calendars only."""

GREGORIAN_MONTHS = (31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
LUNAR_MONTHS = (30,) * 12
PERSIAN_MONTHS = (31,) * 6 + (30,) * 5 + (29,)
"""Days of months: of the sun, those that every year has; of the moon, the most that there may be."""

Read = Callable[[Node, str], Observance]
OnDay = Callable[[int, int], Observance]

POSSESSIVE = "'s"

APOSTROPHE = "'"

MOST = 64
"""Ways that are given of one name, at most."""


def read_feasts(tables: Tables) -> None:
    """Add feasts and seasons."""
    _Feasts(tables).read()

    def season(name: str, row: Row) -> Iterable[tuple[str, Any]]:
        begins, ends = (_month_day(tables, *row.at(edge)) for edge in ("from", "to"))
        return [("season", Season(name, begins, ends))]

    tables.table("seasons", {"from": True, "to": True}, season)


def is_transliterated(entry: Entry) -> bool:
    """Whether it is the name of a feast that is spelt in many ways: of a calendar in another script."""
    return isinstance(entry.value, Feast) and not isinstance(entry.value.kept, OF_LATIN_SCRIPT)


class _Feasts:
    """The holidays of a calendar, which may tell of those above them."""

    def __init__(self, tables: Tables) -> None:
        self.tables = tables
        self.reader = tables.reader
        self.weekdays = numbered(tables, "weekdays")
        self.months = numbered(tables, "months")
        self.names = {name.text for name, _ in tables.rows("holidays")}
        self.found: dict[str, Feast] = {}
        self.calendars: dict[str, Read] = {
            "date": partial(self._on_day, kind=OnDate, months=GREGORIAN_MONTHS),
            "nth": self._nth,
            "easter": partial(self._easter, orthodox=False),
            "orthodox easter": partial(self._easter, orthodox=True),
            "hebrew": partial(self._on_day, kind=OnHebrewDate),
            "islamic": partial(self._on_day, kind=OnIslamicDate),
            "chinese": partial(self._on_day, kind=partial(OnEastAsianDate, hours=CHINA)),
            "korean": partial(self._on_day, kind=partial(OnEastAsianDate, hours=KOREA)),
            "vietnamese": partial(self._on_day, kind=partial(OnEastAsianDate, hours=VIETNAM)),
            "solar term": self._solar_term,
            "persian": partial(self._on_day, kind=OnPersianDate, months=PERSIAN_MONTHS),
            "hindu": partial(self._on_day, kind=OnLunarDay),
            "hindu sun": self._suns_entry,
            "hindu star": self._star,
            "one of": self._one_of,
        }

    def read(self) -> None:
        """Add them."""
        others = ("days", "moves", "lasts", "until", "doubtful", *OF_SOME)
        allowed = dict.fromkeys((*self.calendars, *others), False)
        ways = partial(otherwise, shortened=self._shortened())
        self.tables.table("holidays", allowed, self._feast, one_of=self.calendars, otherwise=ways)

    def _shortened(self) -> dict[str, list[Form]]:
        """Give what words of names are shortened to: weekdays are as they are everywhere."""
        found: dict[str, list[Form]] = {}
        for section in ("weekdays", "shortened"):
            for name, node in self.tables.rows(section):
                first, *others = self.tables.forms(node, f"{section}.{name.text}")
                key, short = (first[0], others) if section == "weekdays" else (name.text, [first, *others])
                found[key] = short
        return found

    def _feast(self, name: str, row: Row) -> Iterable[tuple[str, Any]]:
        calendar = next(filter(row.has, self.calendars))
        kept = self.calendars[calendar](*row.at(calendar))
        for field, of in OF_SOME.items():
            if row.has(field) and calendar not in of:
                message = f"{field!r} goes with {' or '.join(map(repr, of))}, got {calendar!r}"
                self.reader.mistake(*row.at(field), message)
        if isinstance(kept, OnSunsEntry):
            kept = self._behind(kept, row)
        elif isinstance(kept, OnLunarDay):
            kept = self._prevailing(kept, row)
        feast = Feast(
            name,
            kept,
            days=row.whole("days", -MOST_DAYS, MOST_DAYS),
            moves=self._moves(row),
            lasts=row.whole("lasts", 1, MOST_DAYS, 1),
            until=self._until(row),
            from_evening=calendar in FROM_EVENING,
            doubtful=row.flag("doubtful"),
        )
        self.found[name] = feast
        return [("feast", feast)]

    def _moves(self, row: Row) -> tuple[tuple[int, int], ...]:
        if not row.has("moves"):
            return ()
        node, key = row.at("moves")
        moves = Row(self.tables, key, self.reader.mapping(node, key, self.weekdays))
        return tuple((self.weekdays[weekday], moves.whole(weekday, -7, 7)) for weekday in moves.fields)

    def _until(self, row: Row) -> Feast | None:
        if not row.has("until"):
            return None
        if row.has("lasts"):
            self.reader.mistake(*row.at("until"), "a holiday has one of 'lasts' and 'until', got both")
        return self._above(*row.at("until"))

    # -- calendars --------------------------------------------------------------------------------------

    def _nth(self, node: Node, key: str) -> Observance:
        items = self.reader.sequence(node, key, 3)
        if not items:
            return OnWeekday(1, 0, 1)
        nth = int(self.reader.choice(items[0], f"{key}[0]", NTHS) or 1)
        weekday = self.weekdays.get(self.reader.choice(items[1], f"{key}[1]", self.weekdays), 0)
        month = self.months.get(self.reader.choice(items[2], f"{key}[2]", self.months), 1)
        return OnWeekday(nth, weekday, month)

    def _easter(self, node: Node, key: str, *, orthodox: bool) -> Observance:
        return FromEaster(self.reader.whole(node, key, -MOST_DAYS, MOST_DAYS), orthodox)

    def _solar_term(self, node: Node, key: str) -> Observance:
        return OnSolarTerm(self.reader.whole(node, key, 0, 359))

    def _on_day(
        self, node: Node, key: str, *, kind: OnDay, months: tuple[int, ...] = LUNAR_MONTHS
    ) -> Observance:
        """Read month and day."""
        return kind(*_month_day(self.tables, node, key, months))

    def _suns_entry(self, node: Node, key: str) -> Observance:
        return OnSunsEntry(self.reader.whole(node, key, 0, 359))

    def _star(self, node: Node, key: str) -> Observance:
        items = self.reader.sequence(node, key, 2)
        if not items:
            return OnStar(0, 1)
        sign = self.reader.whole(items[0], f"{key}[0]", 0, 11)
        return OnStar(sign, self.reader.whole(items[1], f"{key}[1]", 1, 27))

    def _behind(self, kept: OnSunsEntry, row: Row) -> Observance:
        """Read behind which time of the day it is on the next."""
        time = row.chosen("at", list(At))
        return replace(kept, at=At(time)) if time else kept

    def _prevailing(self, kept: OnLunarDay, row: Row) -> Observance:
        """Read at which times of the day it is to prevail, and which of two such days it is."""
        items = self._items(*row.at("at")) if row.has("at") else ()
        said = (self.reader.choice(item, path, list(At)) for item, path in items)
        at = tuple(At(time) for time in said if time) or kept.at
        return replace(kept, at=at, later=row.flag("later"))

    def _one_of(self, node: Node, key: str) -> Observance:
        """Read feasts that stand above, on the days of any of which it is."""
        feasts = (self._above(item, path) for item, path in self._items(node, key))
        return OneOf(tuple(feast for feast in feasts if feast is not None))

    def _above(self, node: Node, key: str) -> Feast | None:
        """Read the name of a feast that stands above."""
        if isinstance(node, Scalar) and node.text in self.names and node.text not in self.found:
            self.reader.mistake(node, key, f"must be a holiday that stands above, got {node.text!r}")
            return None
        return self.found.get(self.reader.choice(node, key, self.found))

    def _items(self, node: Node, key: str) -> list[tuple[Node, str]]:
        """Give one value, or those of a list, each with its path."""
        if isinstance(node, Sequence) and not node.items:
            self.reader.mistake(node, key, "must not be empty")
        return self.reader.one_or_more(node, key)


def _month_day(
    tables: Tables, node: Node, key: str, months: tuple[int, ...] = GREGORIAN_MONTHS
) -> tuple[int, int]:
    """Read month and day of a calendar, given the days of its months."""
    if not isinstance(node, Scalar):
        tables.reader.string(node, key)
        return 1, 1
    month, _, day = node.text.partition("-")
    known = month.isdecimal() and day.isdecimal() and 1 <= int(month) <= len(months)
    if known and 1 <= int(day) <= months[int(month) - 1]:
        return int(month), int(day)
    message = f"month and day must look like 12-24, and be in every year, got {node.text!r}"
    tables.reader.mistake(node, key, message)
    return 1, 1


def otherwise(form: Form, shortened: Mapping[str, list[Form]]) -> Iterator[Form]:
    """Give other ways to write a name, given what its words are shortened to.

    >>> list(otherwise(("ash", "wednesday"), {"wednesday": [("wed",)]}))
    [('ash', 'wed')]
    >>> [" ".join(way) for way in otherwise(("father's", "day"), {})]
    ['fathers day', "fathers ' day", 'father day']
    """
    ways: list[Form] = [()]
    place = 0
    while place < len(form):
        text, behind = form[place], form[place + 1 : place + 2]
        owned = place + 1 < len(form) and (text.endswith(POSSESSIVE) or behind == (APOSTROPHE,))
        here = _owners(text) if owned else [(text,), *shortened.get(text, ())]
        ways = [(*before, *word) for before in ways for word in here][:MOST]
        place += 2 if owned and behind == (APOSTROPHE,) else 1
    yield from (way for way in dict.fromkeys(ways) if way != form)


def _owners(text: str) -> list[Form]:
    """Give the ways to write whose day it is: "father's", "fathers", "fathers'", "father"."""
    owner = text.removesuffix(POSSESSIVE)
    if owner != text:
        several = owner + ("es" if owner.endswith("s") else "s")
        return [(text,), (several,), (several, APOSTROPHE), (owner,)]
    one = text.removesuffix("s")
    return [(text, APOSTROPHE), (text,), (one + POSSESSIVE,)]
