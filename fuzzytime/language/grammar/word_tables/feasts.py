"""Reading ``calendar.yaml``: feasts and seasons."""

from collections.abc import Iterable
from typing import Any

from fuzzytime.language.grammar.word_tables.tables import Tables
from fuzzytime.language.meaning.feasts import Feast, Reckoning, Season
from fuzzytime.yaml_nodes import Node


def read_feasts(tables: Tables) -> None:
    """Add feasts and seasons."""
    reader = tables.reader
    weekdays = {f[0]: int(n.text) for n, node in tables.rows("weekdays") for f in tables.forms(node, "")}
    months = {f[0]: int(n.text) for n, node in tables.rows("months") for f in tables.forms(node, "")}

    def feast(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        key = f"holidays.{name}"
        days = reader.whole(fields["days"], f"{key}.days", -366, 366) if "days" in fields else 0
        if "date" in fields:
            month, day = _month_day(tables, fields["date"], f"{key}.date")
            kept = fields.get("not on")
            free = None if kept is None else weekdays.get(reader.choice(kept, f"{key}.not on", weekdays))
            return [("feast", Feast(name, Reckoning.DATE, month, day, days=days, never_on=free))]
        if "easter" in fields:
            days += reader.whole(fields["easter"], f"{key}.easter", -366, 366)
            return [("feast", Feast(name, Reckoning.EASTER, days=days))]
        if "nth" in fields:
            items = reader.sequence(fields["nth"], f"{key}.nth", 3)
            if not items:
                return []
            nth = reader.whole(items[0], f"{key}.nth[0]", -4, 4) or 1
            weekday = weekdays.get(reader.choice(items[1], f"{key}.nth[1]", weekdays), 0)
            month = months.get(reader.choice(items[2], f"{key}.nth[2]", months), 1)
            return [("feast", Feast(name, Reckoning.NTH, month, nth=nth, weekday=weekday, days=days))]
        reader.mistake(next(iter(fields.values())), key, "a holiday needs 'date', 'nth' or 'easter'")
        return []

    tables.table(
        "holidays", {"date": False, "nth": False, "easter": False, "days": False, "not on": False}, feast
    )

    def season(name: str, fields: dict[str, Node]) -> Iterable[tuple[str, Any]]:
        begins = _month_day(tables, fields["from"], f"seasons.{name}.from")
        return [("season", Season(name, begins, _month_day(tables, fields["to"], f"seasons.{name}.to")))]

    tables.table("seasons", {"from": True, "to": True}, season)


def _month_day(tables: Tables, node: Node, key: str) -> tuple[int, int]:
    text = tables.reader.string(node, key)
    month, _, day = text.partition("-")
    if (
        month.isdecimal()
        and day.isdecimal()
        and 1 <= int(month) <= 12
        and 1 <= int(day) <= 28 + 3 * (month != "02")
    ):
        return int(month), int(day)
    tables.reader.mistake(node, key, f"a day of the year must look like 12-24, got {text!r}")
    return 1, 1
