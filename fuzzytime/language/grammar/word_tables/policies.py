"""Reading ``calendar.yaml``: the policy."""

from datetime import time

from fuzzytime.language.grammar.word_tables.tables import Tables
from fuzzytime.language.policy import DateOrder, Policy, SameWeekday


def read_policy(tables: Tables) -> Policy:
    """Give the policy that a file says, the default one where it says none."""
    reader = tables.reader
    node = tables.sections.get("policy")
    if node is None:
        return Policy()
    names = ("plausible", "same_weekday", "week_starts", "weekend", "date_order", "bare_pair_from", "ask")
    fields = reader.mapping(node, "policy", names, names)
    if len(fields) < len(names):
        return Policy()
    weekdays = {f[0]: int(n.text) for n, rows in tables.rows("weekdays") for f in tables.forms(rows, "")}
    plausible = reader.mapping(fields["plausible"], "policy.plausible", ("from", "to"), ("from", "to"))
    weekend = reader.mapping(fields["weekend"], "policy.weekend", ("from", "days"), ("from", "days"))
    if len(plausible) < 2 or len(weekend) < 2:
        return Policy()

    def clock(seconds: int) -> time:
        return time(seconds // 3600, seconds // 60 % 60, seconds % 60)

    return Policy(
        plausible_from=clock(tables.clock(plausible["from"], "policy.plausible.from")),
        plausible_to=clock(tables.clock(plausible["to"], "policy.plausible.to")),
        same_weekday=SameWeekday(
            reader.choice(fields["same_weekday"], "policy.same_weekday", tuple(SameWeekday))
            or SameWeekday.NEXT
        ),
        week_starts=weekdays.get(reader.choice(fields["week_starts"], "policy.week_starts", weekdays), 0),
        weekend_from=weekdays.get(reader.choice(weekend["from"], "policy.weekend.from", weekdays), 5),
        weekend_days=reader.whole(weekend["days"], "policy.weekend.days", 1, 6),
        date_order=DateOrder(
            reader.choice(fields["date_order"], "policy.date_order", tuple(DateOrder)) or DateOrder.MONTH_DAY
        ),
        bare_pair_from=reader.whole(fields["bare_pair_from"], "policy.bare_pair_from", 0, 24),
        ask=reader.boolean(fields["ask"], "policy.ask"),
    )
