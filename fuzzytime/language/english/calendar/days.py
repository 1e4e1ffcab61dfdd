"""Days, weekdays, weeks and stretches of them: "tomorrow", "next tuesday", "the weekend", "in three days"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend, is_weekday
from fuzzytime.language.meaning.days.nested import Share, WeekOf, Within
from fuzzytime.language.meaning.days.relations import (
    Away,
    Deictic,
    Following,
    Relative,
    Stretch,
    Which,
    days_away,
)
from fuzzytime.language.meaning.days.side_by_side import weekday_at
from fuzzytime.language.meaning.days.workdays import Workday
from fuzzytime.language.meaning.expressions import Coming, Duration, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.units import Quantity, UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()

PAST_WORDS = frozenset({Which.LAST, Which.PAST})


MIDDLE = (0.25, 0.75)
"""Which share of a week its middle is."""


# -- days by name ---------------------------------------------------------------------------------------


@grammar.rule("days", "<day>", "the? <feast>")
@grammar.rule("series", "<season>", "<feast>")
def named(found: Calendar) -> Calendar:
    """Today, tomorrow, christmas; summer and easter, in "last easter"."""
    return found


@grammar.rule("days", "<weekday> next")
def weekday_next(number: int) -> Calendar:
    """Tuesday next: the one that comes, and not today."""
    return Deictic(Which.COMING, Fields(weekday=number))


@grammar.rule("days", "the? <weekday>", "this? <weekday> coming")
@grammar.rule("days", "a|any|some <weekday>", weight=0.15)
@grammar.rule("series", "<weekday>")
@grammar.rule("weekday series", "<weekday>")
def weekday(number: int) -> Calendar:
    """Monday, in "next monday" too; this monday coming; a monday: the next."""
    return Fields(weekday=number)


@grammar.rule("days", "a|any|some weekend")
def any_weekend() -> Calendar:
    """A weekend: the next."""
    return Deictic(Which.THIS, Weekend())


@grammar.rule("series", "weekend|weekends|wkend", "week end", "week - end")
def weekend() -> Calendar:
    """The weekend."""
    return Weekend()


@grammar.rule("series", "workweek|workweeks", "working week", "work week", "business week")
def working_week() -> Calendar:
    """The working week."""
    return Weekend(working=True)


@grammar.rule("series", "calendar? <unit>")
def cycle(unit: UnitWord) -> Calendar | None:
    """Week, month, fortnight; but "minute" is no day."""
    # "The coming days" are not one.
    several = unit.form.endswith("s")
    return None if unit.unit in SUB_DAY or len(unit.form) == 1 or several else Cycle(unit.unit, unit.count)


@grammar.rule("series", "<month>")
def month_series(number: int) -> Calendar:
    """March, in "next march"."""
    return Fields(month=number)


@grammar.rule("days", "<deictic> <series>", weight=0.1)
def this_or_next(which: Which, series: Calendar) -> Calendar | None:
    """Next week, this monday, last march."""
    # "The same day" may be another than today.
    none = isinstance(series, Workday) or series == Cycle(Unit.DAY)
    return None if none and which is Which.THIS else Deictic(which, series)


@grammar.rule("days", "midweek <days>?", "mid -? week <days>?", weight=0.5)
def midweek(week: Calendar | None = None) -> Calendar:
    """Midweek: the middle days of the week."""
    return Share(*MIDDLE, week or Cycle(Unit.WEEK))


@grammar.rule("days", "one|some|any day <days>", "one|some|any day in|of|during <days>", weight=0.5)
def some_day(days: Calendar) -> Calendar | None:
    """One day next week."""
    return None if days.grain is Unit.DAY else days


@grammar.rule("days", "the <series>", "over the <series>", weight=-0.2)
def the_present(series: Calendar) -> Calendar | None:
    """The week: this week; but "the day" alone is none."""
    if isinstance(series, (Fields, Workday)) or series == Cycle(Unit.DAY):
        return None
    return Deictic(Which.THIS, series)


@grammar.rule("days", "<series> after next", "the <series> after next", weight=0.2)
def after_next(series: Calendar) -> Calendar:
    """The week after next, wednesday after next."""
    if is_weekday(series):
        return Following(2, series, Relative(0))
    return Following(1, series, Deictic(Which.NEXT, series))


@grammar.rule("days", "the? <series> before last", weight=0.5)
def before_last(series: Calendar) -> Calendar:
    """The week before last."""
    return Following(-1, series, Deictic(Which.LAST, series))


@grammar.rule("days", "<deictic> <series> 's <weekday>", weight=0.3)
def weekday_of(which: Which, series: Calendar, number: int) -> Calendar | None:
    """Next week's friday."""
    return Within(Fields(weekday=number), Deictic(which, series)) if series == Cycle(Unit.WEEK) else None


@grammar.rule("days", "<duration> from now", "<duration> hence", weight=-0.3)
def days_from_now(duration: Duration) -> Calendar | None:
    """Three days from now, beside a time of that day."""
    return days_away(duration, Relative(0), 1) if not duration.hedges else None


@grammar.rule("days", "<duration> ago", weight=-0.3)
def days_ago(duration: Duration) -> Calendar | None:
    """Three days ago, beside a time of that day."""
    return days_away(duration, Relative(0), -1) if not duration.hedges else None


@grammar.rule(
    "days",
    "<weekday> ,? <duration> from now|today",
    "<duration> from now|today on <weekday>",
    "the? <weekday> in <duration>",
    weight=0.2,
)
def weekday_near(first: int | Duration, second: int | Duration) -> Calendar | None:
    """Monday two weeks from now, the friday in two weeks."""
    duration, number = (first, second) if isinstance(first, Duration) else (second, first)
    if not isinstance(duration, Duration) or not isinstance(number, int):
        return None
    away = days_away(duration, Relative(0), 1)
    return None if away is None else Within(Fields(weekday=number), WeekOf(away))


@grammar.rule(
    "days",
    "the? <weekday> <duration> after|from|following <days>|<date>",
    "the? <duration> after|from|following <days>|<date> ,? on a|the? <weekday>",
    weight=0.7,
)
def weekday_after(*said: int | Duration | Calendar) -> Calendar | None:
    """Sunday three weeks after march 15th, two months from today on a tuesday."""
    duration = next(part for part in said if isinstance(part, Duration))
    anchor = next(part for part in said if isinstance(part, Calendar))
    number = next(part for part in said if isinstance(part, int))
    away = days_away(duration, anchor, 1) if not duration.hedges else None
    if not isinstance(away, Away) or away.unit is Unit.DAY:
        return None
    return weekday_at(away, Fields(weekday=number))


@grammar.rule("days away", "a week on|from <weekday>")
@grammar.rule(
    "days",
    "<weekday> week",
    "a week on|from <weekday>",
    "a week <weekday>",
    "<weekday> in a|one week",
    weight=0.2,
)
def weekday_week(number: int) -> Calendar:
    """Tuesday week: a week after the next Tuesday."""
    return Away(1, Unit.WEEK, Fields(weekday=number))


# -- so long after a day --------------------------------------------------------------------------------


@grammar.rule("day of month", "<weak date>")
def day_of_month(days: Calendar) -> Calendar | None:
    """The 28th; but "in two years since 2011"."""
    return days if days.grain is Unit.DAY else None


@grammar.rule("weekday with date", "<weekday> ,? the? <date>|<day of month>", weight=0.4)
def weekday_with_date(number: int, date: Calendar) -> Calendar | None:
    """(two days after) friday, may 22: one day; but "a week from friday, may 22" may say the day again."""
    return Fields(weekday=number).joined(date) if isinstance(date, Fields) else None


@grammar.rule("days away", "<duration> from <days>|<date>|<day of month>")
@grammar.rule("days", "<duration> from|after|following|since <days>|<date>|<day of month>", weight=0.2)
@grammar.rule("days", "<duration> after|following|since <weekday with date>", weight=0.2)
def days_after(duration: Duration, anchor: Calendar) -> Calendar | None:
    """Three days after Easter, a week from tuesday, two day after this day."""
    return days_away(duration, anchor, 1) if not duration.hedges else None


@grammar.rule("days", "<duration> into <days>|<weak date>", weight=0.2)
def days_into(duration: Duration, period: Calendar) -> Calendar | None:
    """Ten days into april; but "an hour into the film" is no day."""
    return None if period.grain is Unit.DAY or duration.hedges else days_away(duration, period, 1)


@grammar.rule(
    "days",
    "<duration> before <days>|<date>|<day of month>|<weekday with date>",
    "<duration> prior to <days>|<date>|<day of month>|<weekday with date>",
    weight=0.2,
)
@grammar.rule("days", "<duration> ago <day>", weight=0.6)
def days_before(duration: Duration, anchor: Calendar) -> Calendar | None:
    """Two weeks before christmas, a month ago today."""
    return days_away(duration, anchor, -1) if not duration.hedges else None


# -- stretches of days ----------------------------------------------------------------------------------


@grammar.rule(
    "stretch",
    "the? <deictic> <duration>",
    "<quantity> <deictic> <unit>",
    weight=0.15,
)
def stretch(first: object, second: object, third: object = None) -> Wall | Coming | None:
    """The next three days, the last two hours, 5 coming minutes."""
    which = next(x for x in (first, second) if isinstance(x, Which))
    if isinstance(third, UnitWord) and isinstance(first, Quantity):
        one = which is Which.NEXT and third.unit not in SUB_DAY and not third.form.endswith("s")
        if third.form == "night" or one:
            # "Between 9 and 11 next week"
            return None
        duration = Duration(((first.value * third.count, third.unit),), first.hedges)
    else:
        duration = next((x for x in (first, second) if isinstance(x, Duration)), Duration(()))
    if which is Which.THIS or duration.until is not None or not duration.terms:
        return None
    direction = -1 if which in PAST_WORDS else 1
    amount, unit = duration.terms[0]
    if len(duration.terms) == 1 and unit not in SUB_DAY and amount == int(amount) and amount < 10_000:
        return Wall(Stretch(int(amount) * direction, unit))
    return Coming(duration, direction)


@grammar.rule("stretch", "the? <deictic> <unit> and a? <fraction>", weight=0.3)
def stretch_of_one_and_a_half(which: Which, unit: UnitWord, fraction: float) -> Coming | None:
    """The next hour and a half; but "the next week and a half" has no days."""
    if unit.unit not in SUB_DAY or which is not Which.NEXT or len(unit.form) == 1:
        return None
    return Coming(Duration(((unit.count * (1 + fraction), unit.unit),)))


@grammar.rule("stretch", "the? <deictic> <unit>", "the? <deictic> <unit> and <duration>", weight=0.15)
def stretch_of_one(which: Which, unit: UnitWord, more: Duration | None = None) -> Coming | None:
    """The next hour, the last minute, the next day and five hours."""
    if (unit.unit not in SUB_DAY and more is None) or which is Which.THIS:
        return None
    terms = ((unit.count, unit.unit), *(more.terms if more is not None else ()))
    return Coming(Duration(terms), -1 if which in PAST_WORDS else 1)


@grammar.rule("wall", "<days>", "<date>")
def wall(days: Calendar) -> Wall:
    """A day, or a date, alone."""
    return Wall(days)
