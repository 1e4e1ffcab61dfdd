"""A plan as an iCalendar file (RFC 5545): one event a skill; rejected ones are left out."""

import hashlib
from datetime import UTC, datetime

from icalendar import Calendar, Event

from fuzzytime.interpreter import Plan
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import plain


def calendar_text(plan: Plan) -> str:
    """Write the calendar; an instant with a zone is written in UTC, one without as local time."""
    calendar = Calendar()
    calendar.add("prodid", "-//fuzzytime//fuzzytime//EN")
    calendar.add("version", "2.0")
    stamp = plan.request.now.astimezone(UTC)
    clock = Clock(plan.request.now, with_seconds=True)
    for position in plan.schedule.order:
        if plan.schedule.rejected[position]:
            continue
        interpreted, specific = plan.skills[position], plan.schedule.skills[position]
        event = Event()
        # The same plan gives the same events, so that importing it again replaces them.
        words = f"{plan.request.now.isoformat()}|{interpreted.identifier}|{specific.name}"
        event.add("uid", f"{hashlib.sha256(words.encode('utf-8', 'replace')).hexdigest()[:32]}@fuzzytime")
        event.add("dtstamp", stamp)
        until = specific.done if interpreted.skill.happens else specific.worked_until
        start, end = _written(plan.instant(specific.start)), _written(plan.instant(until))
        event.add("dtstart", start)
        if end > start:  # What takes no time has no end in a calendar.
            event.add("dtend", end)
        event.add("summary", plain(specific.name))
        facts = [plain(interpreted.words or specific.name)]
        facts.append(f"satisfaction {plan.schedule.satisfactions[position]:.2f}")
        if specific.done > until:
            facts.append(f"done at {clock.of(specific.done)}")
        if plan.request.agents > 1:
            facts.append(f"agent {specific.agent}")
        event.add("description", "\n".join(facts))
        calendar.add_component(event)
    return str(calendar.to_ical(), "utf-8")


def _written(instant: datetime) -> datetime:
    whole = instant.replace(microsecond=0)
    return whole.astimezone(UTC) if whole.tzinfo is not None else whole
