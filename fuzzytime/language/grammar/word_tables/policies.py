"""Reading ``calendar.yaml``: the policy."""

from datetime import time

from fuzzytime.documents.nodes import Node
from fuzzytime.language.grammar.lexicon import Form, Forms, form_of
from fuzzytime.language.grammar.word_tables.tables import Tables, numbered
from fuzzytime.language.policy import DateOrder, Hours, Midnight, Policy, SameWeekday


def read_usual_hours(tables: Tables) -> Forms[Hours]:
    """Give the hours at which people do things, by the words for them."""
    found: dict[Form, Hours] = {}
    for name, node in tables.rows("usual_hours"):
        key = f"usual_hours.{name.text}"
        fields = tables.reader.mapping(node, key, ("from", "to", "also"), ("from",))
        if "from" not in fields:
            continue
        last = _time(tables, fields["to"], f"{key}.to") if "to" in fields else None
        hours = (_time(tables, fields["from"], f"{key}.from"), last)
        also = tables.forms(fields["also"], f"{key}.also") if "also" in fields else []
        found.update(dict.fromkeys([form_of(name.text), *also], hours))
    return Forms(found)


NIGHT = ("from", "to", "hours")


def _time(tables: Tables, node: Node, key: str) -> time:
    seconds = tables.clock(node, key)
    return time(seconds // 3600, seconds // 60 % 60, seconds % 60)


def read_policy(tables: Tables) -> Policy:
    """Give the policy that a file says, the default one where it says none."""
    reader = tables.reader
    node = tables.sections.get("policy")
    if node is None:
        return Policy()
    names = (
        "plausible",
        "soon_hours",
        "night",
        "ahead_from",
        "hours_before",
        "workday_from",
        "same_weekday",
        "midnight",
        "week_starts",
        "weekend",
        "date_order",
        "bare_pair_from",
        "planned_from",
        "round_the_clock_hours",
        "kept_off",
        "ask",
    )
    fields = reader.mapping(node, "policy", names, names)
    if len(fields) < len(names):
        return Policy()
    weekdays = numbered(tables, "weekdays")
    plausible = reader.mapping(fields["plausible"], "policy.plausible", ("from", "to"), ("from", "to"))
    night = reader.mapping(fields["night"], "policy.night", NIGHT, NIGHT)
    weekend = reader.mapping(fields["weekend"], "policy.weekend", ("from", "days"), ("from", "days"))
    if len(plausible) < 2 or len(weekend) < 2 or len(night) < len(NIGHT):
        return Policy()

    return Policy(
        plausible_from=_time(tables, plausible["from"], "policy.plausible.from"),
        plausible_to=_time(tables, plausible["to"], "policy.plausible.to"),
        soon_hours=reader.whole(fields["soon_hours"], "policy.soon_hours", 0, 12),
        night_from=_time(tables, night["from"], "policy.night.from"),
        night_to=_time(tables, night["to"], "policy.night.to"),
        night_hours=reader.whole(night["hours"], "policy.night.hours", 0, 12),
        ahead_from=_time(tables, fields["ahead_from"], "policy.ahead_from"),
        hours_before=reader.whole(fields["hours_before"], "policy.hours_before", 0, 24),
        workday_from=_time(tables, fields["workday_from"], "policy.workday_from"),
        same_weekday=SameWeekday(
            reader.choice(fields["same_weekday"], "policy.same_weekday", tuple(SameWeekday))
            or SameWeekday.NEXT
        ),
        midnight=Midnight(
            reader.choice(fields["midnight"], "policy.midnight", tuple(Midnight)) or Midnight.END
        ),
        week_starts=weekdays.get(reader.choice(fields["week_starts"], "policy.week_starts", weekdays), 0),
        weekend_from=weekdays.get(reader.choice(weekend["from"], "policy.weekend.from", weekdays), 5),
        weekend_days=reader.whole(weekend["days"], "policy.weekend.days", 1, 6),
        date_order=DateOrder(
            reader.choice(fields["date_order"], "policy.date_order", tuple(DateOrder)) or DateOrder.MONTH_DAY
        ),
        planned_from=reader.whole(fields["planned_from"], "policy.planned_from", 1, 9999),
        bare_pair_from=reader.whole(fields["bare_pair_from"], "policy.bare_pair_from", 0, 24),
        round_the_clock_hours=reader.whole(
            fields["round_the_clock_hours"], "policy.round_the_clock_hours", 1, 24
        ),
        kept_off=reader.whole(fields["kept_off"], "policy.kept_off", 0, 720),
        ask=reader.boolean(fields["ask"], "policy.ask"),
    )
