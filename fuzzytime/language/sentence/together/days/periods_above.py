"""Weeks of lines above, in which the days of the lines below are: "Next week:", then "Monday: bank"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.language.meaning.calendar import Calendar, is_weekday
from fuzzytime.language.meaning.days.nested import Within
from fuzzytime.language.meaning.days.relations import Deictic, Which
from fuzzytime.language.meaning.expressions import Phrase, Range, Said, Wall, wall_of
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.heading import HEADED, Heading
from fuzzytime.language.sentence.together.days.titles import begins_order
from fuzzytime.requirement import Unit


def with_plan(drafts: Sequence[Draft]) -> list[Draft]:
    """Give drafts in which the weeks, or days, of a plan count from the date that the first of them names."""
    found: list[Draft] = []
    since: Calendar | None = None
    for draft in drafts:
        period = draft.period
        if period is not None and period.days is not None:
            dated = next(filter(None, map(_day_of, draft.phrases)), None)
            since = dated if period.days.number == 1 else since
            draft = replace(draft, period=replace(period, days=replace(period.days, since=since)))  # noqa: PLW2901
        found.append(draft)
    return found


def _day_of(phrase: Phrase) -> Calendar | None:
    time = phrase.said.time
    return wall_of(time.first if isinstance(time, Range) else time).days


def is_plan_title(drafts: Sequence[Draft], place: int) -> bool:
    """Whether a line only names the period of a plan, and what that is about: "Day 1: London"."""
    draft, below = drafts[place], drafts[place + 1 : place + 2]
    if draft.period is None or not draft.scanned.words:
        return draft.period is not None
    leads = bool(below) and below[0].period is None and below[0].now == draft.now
    dated = all(phrase.said.is_day for phrase in draft.phrases)
    return leads and dated and not begins_order(draft)


def plan_period(draft: Draft) -> Heading | None:
    """Give the week, or day, of a plan that a line begins with: "Week 2: run twice"."""
    period = draft.period
    if period is None:
        return None
    day = Phrase(Said(Wall(period.days)), 0, 0, (0, 0), HEADED, above=period.name)
    return Heading(period.name, draft.text, draft.scanned, () if period.days is None else (day,))


def when_begun(draft: Draft) -> tuple[Remark, ...]:
    """Say when the first week, or day, of a plan is taken to be, which no date tells."""
    period = draft.period
    if period is None or period.days is None or period.days.number > 1 or period.days.since is not None:
        return ()
    when = "today" if period.days.unit is Unit.DAY else "the week that begins today, or next"
    message = f"{period.name!r} is taken as {when}: say its date if it is another"
    return (Remark(RemarkKind.POLICY, period.span, message),)


def week_of(heading: Heading | None) -> Calendar | None:
    """Give the week that a line above names, but this one, whose days may be over."""
    time = None if heading is None or heading.day is None else heading.day.said.time
    days = time.days if isinstance(time, Wall) else None
    this = isinstance(days, Deictic) and days.which is Which.THIS
    return days if days is not None and days.grain is Unit.WEEK and not this else None


def in_week(phrases: Sequence[Phrase], week: Calendar | None) -> tuple[Phrase, ...]:
    """Give times with their weekdays in a week."""
    return tuple(phrase if week is None else _inside(phrase, week) for phrase in phrases)


def _inside(phrase: Phrase, week: Calendar) -> Phrase:
    time = phrase.said.time
    if not isinstance(time, Wall) or time.days is None or not is_weekday(time.days):
        return phrase
    return phrase.at(replace(time, days=Within(time.days, week)))
