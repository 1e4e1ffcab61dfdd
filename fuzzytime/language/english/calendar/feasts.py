"""Feasts, and the days of them and beside them: "easter 2027", "the third night of hanukkah"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.days.nested import Nth, WeekOf
from fuzzytime.language.meaning.days.relations import Away, Deictic, Following, Which
from fuzzytime.language.meaning.expressions import Repeat, Wall
from fuzzytime.language.meaning.feasts import Feast, OfYear, Yearly
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.requirement import Unit

grammar = Grammar()


def feast_in(days: Calendar | None) -> Feast | None:
    """Give the feast that is named, of a year or "next" or without either; None for other days."""
    if isinstance(days, OfYear):
        return feast_in(days.feast)
    if isinstance(days, Deictic):
        return feast_in(days.of)
    return days if isinstance(days, Feast) else None


@grammar.rule("date", "<feast> of|in|,? <year>", weight=0.3)
def feast_of_year(feast: Yearly, number: int) -> Calendar:
    """Easter 2018."""
    return OfYear(feast, number)


@grammar.rule("date", "<feast> weekend", "<feast> <year> weekend", "the? weekend of the? <feast>", weight=0.3)
def feast_weekend(feast: Yearly, number: int | None = None) -> Calendar:
    """Labor day weekend."""
    return _weekend_about(feast if number is None else OfYear(feast, number))


@grammar.rule("date", "the? weekend of <date>|<weak date>", weight=0.3)
def weekend_of(days: Calendar) -> Calendar | None:
    """The weekend of the 14th."""
    return _weekend_about(days) if days.grain is Unit.DAY else None


@grammar.rule("date", "the? weekend of <month> <month day> -|/|and|to <month day>", weight=1.5)
def weekend_of_two(month: int, first: int, last: int) -> Calendar | None:
    """The weekend of march 14-15."""
    return weekend_of(Fields(month=month, day=first)) if last == first + 1 else None


@grammar.rule("date", "the? weekend of <month day> -|/|and|to <month day> of? <month>", weight=1.5)
def weekend_of_two_before_month(first: int, last: int, month: int) -> Calendar | None:
    """The weekend of the 14th and 15th of march."""
    return weekend_of_two(month, first, last)


def _weekend_about(days: Calendar) -> Calendar:
    return Following(1, Weekend(), Away(-5, Unit.DAY, days))


@grammar.rule("date", "<feast> week", "<feast> <year> week", weight=0.3)
def feast_week(feast: Yearly, number: int | None = None) -> Calendar:
    """Christmas week, diwali week."""
    return WeekOf(feast if number is None else OfYear(feast, number))


@grammar.rule("days", "the day|evening|morning|night before <feast>", weight=0.7)
@grammar.rule("days", "day|evening|morning|night before <feast>", weight=0.3)
@grammar.rule("days", "erev <feast>", "<feast> eve", weight=0.3)
def eve(feast: Yearly) -> Calendar:
    """The day before christmas, erev passover, easter eve."""
    return Away(-1, Unit.DAY, feast)


@grammar.rule("wall", "the? <ordinal> <part> of the? <days>|<date>", weight=1.3)
def nth_night(number: int, part: Part, days: Calendar) -> Wall | None:
    """The third night of hanukkah: in a calendar whose days begin in the evening, before its third day."""
    return _part_of(number, part, days)


@grammar.rule("wall", "the last <part> of the? <days>|<date>", weight=1.3)
def last_night(part: Part, days: Calendar) -> Wall | None:
    """The last night of hanukkah."""
    return _part_of(-1, part, days)


def _part_of(number: int, part: Part, days: Calendar) -> Wall | None:
    feast = feast_in(days)
    if feast is None or not feast.is_several or part.is_point or part.meal:
        return None
    day: Calendar = Nth(number, Cycle(Unit.DAY), days)
    return Wall(Away(-1, Unit.DAY, day) if feast.from_evening and part.half is Half.NIGHT else day, part)


@grammar.rule("repeat", "<repeat> of|during|throughout the? <wall>", weight=0.25)
def repeat_during(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Every evening of passover, every day during next week; but "every second friday of the month"."""
    whole = wall.days is not None and not wall.is_timed
    # "Every day of the week": of any week.
    days = wall.days if isinstance(wall.days, Deictic) else None
    any_of_them = days is not None and days.which is Which.THIS and isinstance(days.of, Cycle)
    counted = repeat.skip > 1 and feast_in(wall.days) is None
    return narrowed_repeat(repeat, wall) if whole and not (wall.weak or any_of_them or counted) else None


@grammar.rule("repeat", "every|each single? <part> of <days>|<date>", weight=0.9)
def every_night(part: Part, days: Calendar) -> Repeat | None:
    """Every night of hanukkah: from the one in which it begins."""
    feast = feast_in(days)
    if feast is None or not feast.from_evening or not feast.is_several or part.half is not Half.NIGHT:
        return None
    first, last = Away(-1, Unit.DAY, days), Nth(-2, Cycle(Unit.DAY), days)
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part),), starting=Wall(first), until=Wall(last))
