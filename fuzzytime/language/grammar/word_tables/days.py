"""Reading ``calendar.yaml``: units, days, parts of the day, clock words, zones."""

from collections.abc import Iterable, Mapping
from datetime import time
from typing import Any

from fuzzytime.documents.nodes import Node, Scalar
from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.grammar.lexicon import Form, form_of
from fuzzytime.language.grammar.word_tables.tables import FULL_STOP_BELOW, Tables
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.days.relations import Relative, Which
from fuzzytime.language.meaning.expressions import Edge, Ending, UnitWord
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.requirement import Unit
from fuzzytime.times import parse_clock, parse_zone


def read_units(tables: Tables) -> None:
    """Add units and fractions."""
    for name, node in tables.rows("units"):
        key = f"units.{name.text}"
        count, _, unit = name.text.rpartition(" ")
        if unit not in tuple(Unit) or not (count or "1").isdecimal():
            tables.reader.mistake(name, key, f"a unit must be a number of known units, got {name.text!r}")
            continue
        for form in tables.forms(node, key):
            tables.add(
                node,
                key,
                "unit",
                UnitWord(Unit(unit), int(count or 1), " ".join(form)),
                [form, *_stopped(form)],
            )

    def fraction(name: Scalar) -> Iterable[tuple[str, Any]]:
        return [("fraction", tables.reader.number(name, f"fractions.{name.text}", 0, 1))]

    tables.plain("fractions", fraction, named=False)


def read_days(tables: Tables) -> None:
    """Add weekdays, months, days by their distance, and which one of a series."""
    reader = tables.reader
    for section, category, last in (("weekdays", "weekday", 6), ("months", "month", 12)):
        for name, node in tables.rows(section):
            key = f"{section}.{name.text}"
            number = reader.whole(name, key, 0, last)
            for form in tables.forms(node, key):
                tables.add(node, key, category, number, [form, *_stopped(form)])
                if category == "weekday" and len(form[0]) >= FULL_STOP_BELOW:
                    tables.add(node, key, "weekdays", number, [(form[0] + "s",)])
    tables.plain("days", lambda n: [("day", Relative(reader.whole(n, "days", -9, 9)))], named=False)
    tables.plain(
        "days_on", lambda n: [("day", Relative(reader.whole(n, "days_on", -1, 9), onward=True))], named=False
    )
    tables.plain(
        "deictics",
        lambda n: [("deictic", Which(reader.choice(n, "deictics", tuple(Which)) or Which.THIS))],
        named=True,
    )


def _stopped(form: Form) -> list[Form]:
    """Give an abbreviation's form with its full stop; "hours" is none."""
    whole = form[0].removesuffix("s") in tuple(Unit)
    return [(*form, ".")] if len(form) == 1 and len(form[0]) < FULL_STOP_BELOW and not whole else []


NAMED_PARTS = {
    "day_halves": "day_half",
    "first_thing": "first thing",
    "last_thing": "last thing",
    "weeknights": "weeknight",
}
"""Sections whose rows give words to a part of the day, and the categories of those."""


def read_parts(tables: Tables) -> None:
    """Add parts of the day, and shares and edges of longer periods."""
    reader = tables.reader
    parts: dict[str, Part] = {}
    main: list[Part] = []

    def part(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        key = f"parts.{name}"
        start, end = tables.clock(fields["from"], f"{key}.from"), tables.clock(fields["to"], f"{key}.to")
        half = reader.choice(fields["half"], f"{key}.half", tuple(Half)) or Half.DAY
        meal = "meal" in fields and reader.boolean(fields["meal"], f"{key}.meal")
        place = "place" in fields and reader.boolean(fields["place"], f"{key}.place")
        late = tables.clock(fields["late"], f"{key}.late") if "late" in fields else None
        if late is not None and not start <= late <= end:
            reader.mistake(fields["late"], f"{key}.late", "a part's late half must begin inside it")
        parts[name] = Part(name, start, end + (86400 if end < start else 0), Half(half), meal, late, place)
        if not meal and parts[name].start != parts[name].end:
            tables.add(
                fields["from"], key, "parts", parts[name], [(*form_of(name)[:-1], form_of(name)[-1] + "s")]
            )
        if "main" in fields and reader.boolean(fields["main"], f"{key}.main"):
            main.append(parts[name])
        if "each" in fields:
            tables.add(fields["each"], key, "parts", parts[name], tables.forms(fields["each"], f"{key}.each"))
        return [("meal" if meal else "part", parts[name])]

    tables.table(
        "parts",
        {"from": True, "to": True, "half": True, "meal": False, "late": False, "place": False}
        | {"main": False, "each": False},
        part,
    )
    if main and "all_meals" in tables.sections:
        node = tables.sections["all_meals"]
        tables.add(node, "all_meals", "meals", tuple(main), tables.words("all_meals"))

    _read_named_parts(tables, parts)
    _read_shares(tables)


def _read_named_parts(tables: Tables, parts: Mapping[str, Part]) -> None:
    """Add what names a part of the day by another word: halves of days, and parts of certain days."""
    reader = tables.reader

    for section, category in NAMED_PARTS.items():
        for name, node in tables.rows(section):
            key = f"{section}.{name.text}"
            chosen = reader.choice(name, key, tuple(parts))
            if chosen:
                tables.add(node, key, category, parts[chosen], tables.forms(node, section))

    def day_part(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        day = reader.whole(fields["day"], f"day_parts.{name}.day", -9, 9)
        chosen = reader.choice(fields["part"], f"day_parts.{name}.part", tuple(parts))
        return [("day_part", (Relative(day), parts[chosen]))] if chosen else []

    tables.table("day_parts", {"day": True, "part": True}, day_part)


def _read_shares(tables: Tables) -> None:
    """Add shares and edges of periods."""
    reader = tables.reader

    def share(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        low = reader.number(fields["from"], f"shares.{name}.from", 0, 1)
        return [("share", (low, reader.number(fields["to"], f"shares.{name}.to", 0, 1)))]

    tables.table("shares", {"from": True, "to": True}, share)
    tables.plain(
        "edges", lambda n: [("edge", Edge(reader.choice(n, "edges", ("start", "end")) or "end"))], named=False
    )

    def edge(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        chosen = reader.choice(fields["edge"], f"abbreviated_edges.{name}.edge", ("start", "end")) or "end"
        unit = reader.choice(fields["unit"], f"abbreviated_edges.{name}.unit", tuple(Unit)) or Unit.DAY
        return [("ending", Ending(Edge(chosen), Cycle(Unit(unit))))]

    tables.table("abbreviated_edges", {"edge": True, "unit": True}, edge)


def read_clocks(tables: Tables) -> None:
    """Add halves of the day and zones."""
    reader = tables.reader
    halves = (Half.AM, Half.PM, Half.EITHER)
    tables.plain(
        "meridiem",
        lambda n: [("meridiem", Half(reader.choice(n, "meridiem", halves) or Half.EITHER))],
        named=False,
    )

    def zone(name: Scalar) -> Iterable[tuple[str, Any]]:
        if name.text[:1] not in "+-":
            reader.read(name, f"zones.{name.text}", parse_zone)
        elif _offset(name.text) is None:
            reader.mistake(name, f"zones.{name.text}", f"an offset must look like +05:30, got {name.text!r}")
        return [("zone", name.text)]

    tables.plain("zones", zone, named=False)


def _offset(text: str) -> time | None:
    try:
        return parse_clock(text[1:])
    except FuzzytimeError:
        return None
