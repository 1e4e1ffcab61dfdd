"""Reading ``calendar.yaml``: units, days, parts of the day, clock words, zones, and the policy."""

from collections.abc import Iterable, Mapping
from datetime import time
from typing import Any

from fuzzytime.documents.nodes import Scalar
from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.grammar.lexicon import Form, Forms, form_of
from fuzzytime.language.grammar.word_tables.tables import FULL_STOP_BELOW, Row, Tables, numbered
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.days.relations import Relative, Which
from fuzzytime.language.meaning.expressions import Edge, Ending
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.language.policy import DateOrder, Hours, Midnight, Policy, SameWeekday, Steps
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
    parts: dict[str, Part] = {}
    main: list[Part] = []

    def part(name: str, row: Row) -> Iterable[tuple[str, Any]]:
        start, end, half = row.clock("from"), row.clock("to"), row.choice("half", Half.DAY)
        meal, place, event = row.flag("meal"), row.flag("place"), row.flag("event")
        late = row.clock("late") if row.has("late") else None
        if late is not None and not start <= late <= end:
            tables.reader.mistake(*row.at("late"), "a part's late half must begin inside it")
        end += 86400 if end < start else 0
        parts[name] = Part(name, start, end, half, meal, late, place, event=event)
        if not meal and parts[name].start != parts[name].end:
            plural = (*form_of(name)[:-1], form_of(name)[-1] + "s")
            tables.add(row.fields["from"], row.key, "parts", parts[name], [plural])
        if row.flag("main"):
            main.append(parts[name])
        if row.has("each"):
            tables.add(row.fields["each"], row.key, "parts", parts[name], row.forms("each"))
        return [("meal" if meal else "part", parts[name])]

    tables.table(
        "parts",
        {"from": True, "to": True, "half": True, "meal": False, "late": False, "place": False}
        | {"main": False, "each": False, "event": False},
        part,
    )
    if main and "all_meals" in tables.sections:
        node = tables.sections["all_meals"]
        tables.add(node, "all_meals", "meals", tuple(main), tables.words("all_meals"))

    _read_named_parts(tables, parts)
    _read_shares(tables)


def _read_named_parts(tables: Tables, parts: Mapping[str, Part]) -> None:
    """Add what names a part of the day by another word: halves of days, and parts of certain days."""
    for section, category in NAMED_PARTS.items():
        for name, node in tables.rows(section):
            key = f"{section}.{name.text}"
            chosen = tables.reader.choice(name, key, tuple(parts))
            if chosen:
                tables.add(node, key, category, parts[chosen], tables.forms(node, section))

    def day_part(_: str, row: Row) -> Iterable[tuple[str, Any]]:
        day, chosen = row.whole("day", -9, 9), row.chosen("part", tuple(parts))
        return [("day_part", (Relative(day), parts[chosen]))] if chosen else []

    tables.table("day_parts", {"day": True, "part": True}, day_part)


def _read_shares(tables: Tables) -> None:
    """Add shares and edges of periods."""
    reader, ends = tables.reader, ("start", "end")

    def share(_: str, row: Row) -> Iterable[tuple[str, Any]]:
        return [("share", (row.number("from", 0, 1), row.number("to", 0, 1)))]

    tables.table("shares", {"from": True, "to": True}, share)
    tables.plain("edges", lambda n: [("edge", Edge(reader.choice(n, "edges", ends) or "end"))], named=False)

    def edge(_: str, row: Row) -> Iterable[tuple[str, Any]]:
        chosen = row.choice("edge", Edge.END, Edge.START, Edge.END)
        return [("ending", Ending(chosen, Cycle(row.choice("unit", Unit.DAY))))]

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


def read_hours(tables: Tables, section: str) -> Forms[Hours]:
    """Give the hours at which people do things, by the words for them."""
    found: dict[Form, Hours] = {}
    for name, node in tables.rows(section):
        key = f"{section}.{name.text}"
        row = Row(tables, key, tables.reader.mapping(node, key, ("from", "to", "also"), ("from",)))
        if row.has("from"):
            hours = (_time(row, "from"), _time(row, "to") if row.has("to") else None)
            found.update(dict.fromkeys([form_of(name.text), *row.forms("also")], hours))
    return Forms(found)


NAMES = (
    "plausible", "soon_hours", "night", "ahead_from", "begun_hours", "under_way", "hours_before",
    "workday_from", "same_weekday", "midnight", "week_starts", "weekend", "date_order", "bare_pair_from",
    "planned_from", "round_the_clock_hours", "steps", "sure_hours", "kept_off", "ask",
)  # fmt: skip
"""What a policy says: all of it."""

STEPS = ("lines", "leaning", "same", "least", "timed", "lasting")
"""What it says of lines that lean on each other."""


def read_policy(tables: Tables) -> Policy:
    """Give the policy that a file says, the default one where it says none, or not all of it."""
    node = tables.sections.get("policy")
    said = Row(tables, "policy", {} if node is None else tables.reader.mapping(node, "policy", NAMES, NAMES))
    if not said.has(*NAMES):
        return Policy()
    plausible = said.part("plausible", "from", "to")
    night = said.part("night", "from", "to", "hours")
    weekend = said.part("weekend", "from", "days")
    steps = said.part("steps", *STEPS)
    parts = plausible.has("from", "to") and night.has("from", "to", "hours") and weekend.has("from", "days")
    if not (parts and steps.has(*STEPS)):
        return Policy()
    weekdays = numbered(tables, "weekdays")
    return Policy(
        plausible_from=_time(plausible, "from"),
        plausible_to=_time(plausible, "to"),
        soon_hours=said.whole("soon_hours", 0, 12),
        night_from=_time(night, "from"),
        night_to=_time(night, "to"),
        night_hours=night.whole("hours", 0, 12),
        ahead_from=_time(said, "ahead_from"),
        begun_hours=said.whole("begun_hours", 0, 12),
        under_way=said.whole("under_way", 0, 100),
        hours_before=said.whole("hours_before", 0, 24),
        workday_from=_time(said, "workday_from"),
        same_weekday=said.choice("same_weekday", SameWeekday.NEXT),
        midnight=said.choice("midnight", Midnight.END),
        week_starts=weekdays.get(said.chosen("week_starts", weekdays), 0),
        weekend_from=weekdays.get(weekend.chosen("from", weekdays), 5),
        weekend_days=weekend.whole("days", 1, 6),
        date_order=said.choice("date_order", DateOrder.MONTH_DAY),
        planned_from=said.whole("planned_from", 1, 9999),
        bare_pair_from=said.whole("bare_pair_from", 0, 24),
        round_the_clock_hours=said.whole("round_the_clock_hours", 1, 24),
        steps=Steps(**{name: steps.whole(name, 1, 100) for name in STEPS}),
        sure_hours=said.whole("sure_hours", 0, 100),
        kept_off=said.whole("kept_off", 0, 720),
        ask=said.flag("ask"),
    )


def _time(row: Row, name: str) -> time:
    seconds = row.clock(name)
    return time(seconds // 3600, seconds // 60 % 60, seconds % 60)
