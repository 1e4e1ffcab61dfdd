"""A plan as an iCalendar file (RFC 5545): an event a skill, or one for all that follow a rule.

Rejected skills are left out.
"""

import hashlib
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime, timedelta

from icalendar import Calendar, Event

from fuzzytime.interpreter import Plan
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.formats.repeating import Series, planned_span, series_of
from fuzzytime_cli.render import plain


def calendar_text(plan: Plan) -> str:
    """Write the calendar; an instant with a zone is in UTC, or in its zone where it repeats, others local."""
    calendar = Calendar()
    calendar.add("prodid", "-//fuzzytime//fuzzytime//EN")
    calendar.add("version", "2.0")
    series = series_of(plan)
    followed = {position for one in series for position in one.places}
    for position in plan.schedule.order:
        if position not in followed and not plan.schedule.rejected[position]:
            calendar.add_component(_event(plan, position))
    for one in series:
        for event in _repeated(plan, one):
            calendar.add_component(event)
    if series:
        calendar.add_missing_timezones()
    return str(calendar.to_ical(), "utf-8")


def _event(plan: Plan, position: int) -> Event:
    """Give the event of a skill that is planned."""
    start, length = planned_span(plan, position)
    begin, end = (_written(plan.instant(time)) for time in (start, start + length))
    planned = plan.schedule.skills[position]
    facts = [f"satisfaction {plan.schedule.satisfactions[position]:.2f}"]
    if planned.done > start + length:
        facts.append(f"done at {Clock(plan.request.now, with_seconds=True).of(planned.done)}")
    if plan.request.agents > 1:
        facts.append(f"agent {planned.agent}")
    return _made(plan, position, plan.skills[position].identifier, (begin, end), facts)


def _repeated(plan: Plan, series: Series) -> Iterator[Event]:
    """Give the event of a series, and those of its occurrences that are elsewhere."""
    identifier = f"{plan.skills[series.like].identifier} and so on"
    end = series.first + timedelta(seconds=int(series.length))
    event = _made(plan, series.like, identifier, (series.first, end), [])
    event.add("rrule", {**series.rule, **({} if series.count is None else {"COUNT": series.count})})
    elsewhere = []
    for position in sorted(series.moved):
        if plan.schedule.rejected[position]:
            event.add("exdate", series.places[position])
            continue
        other = _event(plan, position)
        other["uid"] = event["uid"]
        other.add("recurrence-id", series.places[position])
        elsewhere.append(other)
    yield event
    yield from elsewhere


def _made(
    plan: Plan, position: int, identifier: str, span: tuple[datetime, datetime], facts: Sequence[str]
) -> Event:
    """Give an event of what a skill asks for."""
    event, name = Event(), plan.skills[position].skill.name
    # The same plan gives the same events, so that importing it again replaces them.
    words = f"{plan.request.now.isoformat()}|{identifier}|{name}"
    event.add("uid", f"{hashlib.sha256(words.encode('utf-8', 'replace')).hexdigest()[:32]}@fuzzytime")
    event.add("dtstamp", plan.request.now.astimezone(UTC))
    start, end = span
    event.add("dtstart", start)
    if end > start:  # What takes no time has no end in a calendar.
        event.add("dtend", end)
    event.add("summary", plain(name))
    event.add("description", "\n".join([plain(plan.skills[position].words or name), *facts]))
    return event


def _written(instant: datetime) -> datetime:
    whole = instant.replace(microsecond=0)
    return whole.astimezone(UTC) if whole.tzinfo is not None else whole
