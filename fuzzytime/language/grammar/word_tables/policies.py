"""Reading ``calendar.yaml``: the policy."""

from datetime import time

from fuzzytime.language.grammar.lexicon import Form, Forms, form_of
from fuzzytime.language.grammar.word_tables.tables import Row, Tables, numbered
from fuzzytime.language.policy import DateOrder, Hours, Midnight, Policy, SameWeekday


def read_usual_hours(tables: Tables) -> Forms[Hours]:
    """Give the hours at which people do things, by the words for them."""
    found: dict[Form, Hours] = {}
    for name, node in tables.rows("usual_hours"):
        key = f"usual_hours.{name.text}"
        row = Row(tables, key, tables.reader.mapping(node, key, ("from", "to", "also"), ("from",)))
        if row.has("from"):
            hours = (_time(row, "from"), _time(row, "to") if row.has("to") else None)
            found.update(dict.fromkeys([form_of(name.text), *row.forms("also")], hours))
    return Forms(found)


NAMES = (
    "plausible", "soon_hours", "night", "ahead_from", "hours_before", "workday_from", "same_weekday",
    "midnight", "week_starts", "weekend", "date_order", "bare_pair_from", "planned_from",
    "round_the_clock_hours", "kept_off", "ask",
)  # fmt: skip
"""What a policy says: all of it."""


def read_policy(tables: Tables) -> Policy:
    """Give the policy that a file says, the default one where it says none, or not all of it."""
    node = tables.sections.get("policy")
    said = Row(tables, "policy", {} if node is None else tables.reader.mapping(node, "policy", NAMES, NAMES))
    if not said.has(*NAMES):
        return Policy()
    plausible = said.part("plausible", "from", "to")
    night = said.part("night", "from", "to", "hours")
    weekend = said.part("weekend", "from", "days")
    if not (plausible.has("from", "to") and night.has("from", "to", "hours") and weekend.has("from", "days")):
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
        kept_off=said.whole("kept_off", 0, 720),
        ask=said.flag("ask"),
    )


def _time(row: Row, name: str) -> time:
    seconds = row.clock(name)
    return time(seconds // 3600, seconds // 60 % 60, seconds % 60)
