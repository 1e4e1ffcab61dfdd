"""Days by how far they are from another: "a week tomorrow", "a month ago today", "over the next week"."""

from dataclasses import replace

from fuzzytime.language.english.calendar.days import stretch
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend, is_weekly
from fuzzytime.language.meaning.days.nested import Nth
from fuzzytime.language.meaning.days.relations import (
    Away,
    Deictic,
    Following,
    Relative,
    Stretch,
    Which,
    days_away,
)
from fuzzytime.language.meaning.expressions import Coming, Duration, Offset, Said, Wall
from fuzzytime.language.meaning.feasts import Yearly
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.times_of_day import Clock, Part
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()

BACK = frozenset({"ago", "earlier"})
"""Prepositions of distances back from now."""

TODAY = Relative(0)

MOST_COUNTED = 100
"""Weekdays and weekends are counted to fewer than these."""

LONGEST_AGE = 60
"""Years that a feast is named by how far away it is, at most: as far as is searched."""


@grammar.rule("wall", "on|in? the <part> before <days>|<date>|<day of month>|<weekday with date>", weight=1.3)
def part_before(found: Part, days: Calendar) -> Wall | None:
    """The night before friday: thursday night."""
    return _part_beside(found, days, -1)


@grammar.rule("wall", "on|in? the <part> after <days>|<date>|<day of month>|<weekday with date>", weight=1.3)
def part_after(found: Part, days: Calendar) -> Wall | None:
    """The morning after friday: saturday morning."""
    return _part_beside(found, days, 1)


def _part_beside(found: Part, days: Calendar, direction: int) -> Wall | None:
    if found.is_point or days.grain is not Unit.DAY:
        return None
    return Wall(Away(direction, Unit.DAY, days), found)


@grammar.rule("wall", "on? the eve of <days>|<date>|<day of month>|<weekday with date>", weight=1.5)
def eve_of(days: Calendar) -> Wall | None:
    """On the eve of friday: the day before."""
    return Wall(Away(-1, Unit.DAY, days)) if days.grain is Unit.DAY else None


@grammar.rule("days", "on the day itself?", "on his|her|their birthday", weight=0.3)
def on_the_day() -> Calendar:
    """(The wedding is on saturday; do the flowers) on the day."""
    return Relative(0, onward=True, event=True)


@grammar.rule("days", "this|same day <deictic> <series>", "the same day <deictic> <series>", weight=0.6)
def same_day(which: Which, series: Calendar) -> Calendar | None:
    """This day next week, the same day next month."""
    if which not in {Which.NEXT, Which.COMING} or not isinstance(series, Cycle) or series.grain is Unit.DAY:
        return None
    return Away(series.count, series.unit, Relative(0))


@grammar.rule("days away", "<duration> on|come <weekday>")
@grammar.rule("days", "<duration> on|come <weekday>", weight=0.6)
def weeks_on(duration: Duration, weekday: int) -> Calendar | None:
    """A fortnight on friday, a month on monday: so long after the next."""
    weeks = duration.unit in {Unit.WEEK, Unit.MONTH} and not duration.hedges
    return days_away(duration, Fields(weekday=weekday), 1) if weeks else None


@grammar.rule("days", "<duration> <day>", weight=0.6)
def weeks_from(duration: Duration, day: Relative) -> Calendar | None:
    """A week tomorrow, a fortnight today."""
    whole = duration.unit is Unit.WEEK and day.days >= 0 and not duration.hedges
    return days_away(duration, day, 1) if whole else None


@grammar.rule("days", "<unit> from <days>|<date>", weight=-0.5)
def a_unit_from(unit: UnitWord, anchor: Calendar) -> Calendar | None:
    """Week from tuesday, month from tomorrow: one of it."""
    return None if _is_several(unit) else days_away(_one(unit), anchor, 1)


@grammar.rule("said", "<unit> from now|hence", weight=-0.5)
def a_unit_from_now(unit: UnitWord) -> Said | None:
    """Hour from now, fortnight from now."""
    return None if _is_several(unit) else Said(Offset(_one(unit)), None, "from now")


def _one(unit: UnitWord) -> Duration:
    return Duration(((unit.count, unit.unit),))


def _is_several(unit: UnitWord) -> bool:
    """Whether the word means more than one of the unit, or is too short to be sure."""
    return unit.form.endswith("s") or len(unit.form) < 3


@grammar.rule("days", "<weekday> fortnight", weight=0.2)
def weekday_fortnight(number: int) -> Calendar:
    """Friday fortnight."""
    return Away(2, Unit.WEEK, Fields(weekday=number))


@grammar.rule("days", "<day> week", weight=0.6)
def day_week(day: Relative) -> Calendar | None:
    """Tomorrow week, today week."""
    return Away(1, Unit.WEEK, day) if day.days >= 0 else None


@grammar.rule("days", "<deictic> <date>", weight=0.5)
def which_date(which: Which, date: Calendar) -> Calendar | None:
    """Next july 5, last march 3rd; but "past march 3rd" is after it."""
    dated = isinstance(date, Fields) and date.month is not None and date.year is date.weekday is None
    said = dated and date.grain is Unit.DAY and which not in {Which.THIS, Which.PAST}
    return Deictic(which, date) if said else None


@grammar.rule(
    "days",
    "<integer> <weekdays>|<weekday> from now|today",
    "<integer> <weekdays>|<weekday> hence",
    "in <integer> <weekdays>",
    "in <integer> <weekdays> '|'s time",
    weight=0.5,
)
def weekdays_from_now(number: Integer, weekday: int) -> Calendar | None:
    """Three fridays from now, in two sundays."""
    return _counted(number.value, Fields(weekday=weekday))


@grammar.rule("days", "<integer> <weekdays>|<weekday> later|afterwards", weight=0.5)
def weekdays_later(number: Integer, weekday: int) -> Calendar | None:
    """(sow it today, and plant it) two mondays later: behind the day that was said."""
    return _counted(number.value, Fields(weekday=weekday), Relative(0, onward=True))


@grammar.rule("days", "<integer> <weekdays>|<weekday> ago", weight=0.5)
def weekdays_ago(number: Integer, weekday: int) -> Calendar | None:
    """Two thursdays ago."""
    return _counted(number.value, Fields(weekday=weekday), back=True)


@grammar.rule("days", "<integer> weekends|weekend from now|today", "<integer> weekends hence", weight=0.5)
@grammar.rule("days", "in <integer> weekends", "in <integer> weekends '|'s time", weight=0.5)
def weekends_from_now(number: Integer) -> Calendar | None:
    """Two weekends from now."""
    return _counted(number.value, Weekend())


@grammar.rule("days", "<integer> weekends|weekend ago", weight=0.5)
def weekends_ago(number: Integer) -> Calendar | None:
    """Two weekends ago."""
    return _counted(number.value, Weekend(), back=True)


def _counted(
    number: int, series: Calendar, anchor: Calendar = TODAY, *, back: bool = False
) -> Calendar | None:
    """Give the nth of a series behind a day, or before it; None behind none, and behind too many."""
    counted = anchor.grain is Unit.DAY and 0 < number < MOST_COUNTED
    return Following(-number if back else number, series, anchor) if counted else None


@grammar.rule("days", "the? <ordinal> <weekday> from now|today", "the? <ordinal> <weekday> hence", weight=0.6)
def nth_weekday_from_now(number: int, weekday: int) -> Calendar | None:
    """The third friday from now."""
    return _counted(number, Fields(weekday=weekday))


@grammar.rule("days", "<integer> <weekdays> before <days>|<date>|<day of month>", weight=1.0)
def weekdays_before(number: Integer, weekday: int, anchor: Calendar) -> Calendar | None:
    """Two fridays before easter."""
    return _counted(number.value, Fields(weekday=weekday), anchor, back=True)


@grammar.rule("days", "<integer> <weekdays> after <days>|<date>|<day of month>", weight=1.0)
def weekdays_after(number: Integer, weekday: int, anchor: Calendar) -> Calendar | None:
    """Two fridays after easter."""
    return _counted(number.value, Fields(weekday=weekday), anchor)


@grammar.rule("days", "the? <series> just gone", weight=0.6)
def just_gone(series: Calendar) -> Calendar:
    """(on) friday just gone: the last one."""
    return Deictic(Which.PAST, series)


@grammar.rule("days", "the? <series> after this|that one", weight=0.6)
def after_this_one(series: Calendar) -> Calendar | None:
    """The friday after this one."""
    if is_weekly(series):
        return Following(2, series, Relative(0))
    return Deictic(Which.NEXT, series) if isinstance(series, Cycle) else None


@grammar.rule(
    "days",
    "not this <series> ,? but the? next one?",
    "not this <series> ,? but the? following one?",
    weight=1.5,
)
def not_this_but_next(series: Calendar) -> Calendar:
    """Not this friday but next."""
    return Deictic(Which.NEXT, series)


@grammar.rule(
    "said", "this <series> ,? or the? next one?", "this <series> ,? or the following one?", weight=1.0
)
def this_one_or_next(series: Calendar) -> Said | None:
    """This weekend or next, this friday or the next: one of the two."""
    if isinstance(series, Cycle):
        return None
    first, last = (Wall(Deictic(which, series)) for which in (Which.THIS, Which.NEXT))
    return Said(first, listed=(Said(last, alternative=True),))


@grammar.rule("days", "<days> in|after <duration>", "<days> ,? <duration> <forward>|<back>", weight=0.6)
def feast_of_year_away(
    anchor: Calendar, duration: Duration, preposition: Preposition | None = None
) -> Calendar | None:
    """Thanksgiving in two years, christmas two years ago: in the year so far away."""
    (amount, unit), *more = duration.terms
    named = isinstance(anchor, Yearly) and not more and duration.until is None and not duration.hedges
    if not named or unit is not Unit.YEAR or amount != int(amount) or not 0 < amount < LONGEST_AGE:
        return None
    years = -int(amount) if preposition is not None and preposition.name in BACK else int(amount)
    return Nth(1, anchor, Following(years, Cycle(Unit.YEAR), Relative(0)))


@grammar.rule("said", "over|in|during|throughout the next|coming <unit>", weight=0.5)
def stretch_ahead(unit: UnitWord) -> Said | None:
    """Over the next fortnight, in the next week: from today on, and no week of the calendar."""
    if unit.unit in SUB_DAY or unit.unit is Unit.DAY:
        return None
    return Said(Wall(Stretch(unit.count, unit.unit)), None, "during")


@grammar.rule("said", "<duration> from <wall> ,? for <duration>", weight=1.0)
def lasting_from_then(away: Duration, wall: Wall, duration: Duration) -> Said | None:
    """A week from sunday at six for an hour."""
    days = None if wall.days is None or away.hedges else days_away(away, wall.days, 1)
    return None if days is None else Said(replace(wall, days=days), None, None, lasting=duration)


@grammar.rule("said", "at <clock> ,? <days away> ,? for <duration>", weight=2.0)
def lasting_at_clock_then(clock: Clock, days: Calendar, duration: Duration) -> Said:
    """At six a week from today for an hour: no six a week."""
    return Said(Wall(days, clock=replace(clock, bare=False)), None, "at", lasting=duration)


@grammar.rule("said", "for <duration> ,? <days away> ,? at <clock>|<clock behind at>", weight=2.0)
def lasting_days_away(duration: Duration, days: Calendar, clock: Clock) -> Said:
    """For an hour a week from monday at six: no hour a week."""
    return Said(Wall(days, clock=replace(clock, bare=False)), None, None, lasting=duration)


@grammar.rule("stretch", "the? <duration> <deictic>", weight=-0.3)
def stretch_behind(duration: Duration, which: Which) -> Wall | Coming | None:
    """The two hours following; but "for two hours next monday" is on that one."""
    return stretch(which, duration)
