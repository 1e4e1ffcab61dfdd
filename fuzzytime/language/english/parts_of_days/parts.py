"""Parts of the day and of longer periods: "tomorrow morning", "late tonight", "end of the month"."""

from dataclasses import replace

from fuzzytime.language.english.calendar.feasts import feast_in
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.days.nested import Share, WeekOf
from fuzzytime.language.meaning.days.relations import Away, Deictic, Relative, Which
from fuzzytime.language.meaning.expressions import Edge, Ending, Rest, Said, Wall
from fuzzytime.language.meaning.feasts import Season
from fuzzytime.language.meaning.joined.told_apart import ending_on
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, WHOLE_DAY, Half, Part
from fuzzytime.requirement import Unit

grammar = Grammar()

SPOKEN_OF = frozenset({"morning", "afternoon", "evening", "night"})
"""Parts of days behind "that": it joins what is said of others, "tell Tom that lunch is ready"."""


@grammar.rule("parted", "<part>")
def part(found: Part) -> Part | None:
    """Morning, evening, lunchtime."""
    return None if found.is_point else found


@grammar.rule("parted", "<share> the? <part>|<parts>", "<share> this|that <part>", weight=0.1)
def part_share(share: tuple[float, float], found: Part) -> Part | None:
    """Early morning, late in the evening."""
    return None if found.is_point else found.share(*share)


@grammar.rule("wall", "<parted>", "in|during|at|for|over? the? <parted>", "in the <day_half>", weight=-0.05)
def wall_of_part(found: Part) -> Wall:
    """Morning, in the evening, at lunch, in the pm."""
    return Wall(part=found)


@grammar.rule("wall", "that same? <part>", "the very? same <part>", weight=0.2)
def part_of_that_day(found: Part, days: int = 0) -> Wall | None:
    """(I'll read them) that afternoon, the same morning; but "tell Tom that bedtime is at eight"."""
    return Wall(Relative(days, onward=True), found) if found.name in SPOKEN_OF else None


@grammar.rule("wall", "on? the <part> before", "on|in? the previous|preceding <part>", weight=0.25)
def part_of_day_before(found: Part) -> Wall | None:
    """(pack) the evening before: of the day before that which was said."""
    return part_of_that_day(found, -1)


@grammar.rule("wall", "<part> before", weight=-0.3)
def night_before(found: Part) -> Wall | None:
    """Night before: (soak the beans)."""
    return part_of_day_before(found)


@grammar.rule("wall", "on? the <part> after", weight=0.25)
def part_of_day_after(found: Part) -> Wall | None:
    """(clean up) the morning after: of the day after that which was said."""
    return part_of_that_day(found, 1)


@grammar.rule("wall", "on? the? <parts> of <wall>", weight=1.2)
def parts_of_days(found: Part, wall: Wall) -> Wall | None:
    """(on) the nights of the 4th (and 5th)."""
    days = wall.days
    dated = days is not None and days.grain is Unit.DAY and wall.part is None and not found.is_point
    return replace(wall, part=found, weak=False) if dated else None


@grammar.rule("wall", "on? any <part>", weight=0.05)
def any_part(found: Part) -> Wall | None:
    """(come) any evening."""
    return None if found.is_point else Wall(part=found)


@grammar.rule(
    "wall", "one|some|any|an|a <part> <days>", "one|some|any|an|a <part> in|of|during <days>", weight=0.6
)
def some_part(found: Part, days: Calendar) -> Wall | None:
    """One evening this week."""
    weekend = isinstance(days, Deictic) and isinstance(days.of, Weekend)
    several = days.grain is not Unit.DAY or weekend
    return Wall(days, found) if several and not found.is_point else None


@grammar.rule("end", "midnight between <days> and <days>", weight=0.9)
def midnight_between(_first: Calendar, second: Calendar) -> Ending:
    """Midnight between thursday and friday: where friday begins."""
    return Ending(Edge.START, second)


@grammar.rule(
    "wall",
    "in? the? <part> from|of <days> to|on|into <days>",
    "in? the? <part> between <days> and <days>",
    weight=1.2,
)
def night_between(found: Part, first: Calendar, _second: Calendar) -> Wall | None:
    """The night from thursday to friday: that of thursday."""
    return Wall(first, found) if found.half.is_late and not found.is_point else None


@grammar.rule("wall", "outside of? the? <part>", weight=0.3)
def outside(found: Part) -> Wall | None:
    """Outside office hours: from where they end to where the next begin."""
    if found.is_point or found.half is not Half.DAY:
        return None
    return Wall(
        part=replace(found, start=found.end, end=found.start + DAY_SECONDS, late=None, half=Half.NIGHT)
    )


@grammar.rule("wall", "all|throughout|through the? <part>", "the? whole|entire <part>", weight=0.2)
def all_part(found: Part) -> Wall | None:
    """All morning, through the night."""
    # The night that something goes on through is over in the morning: "overnight".
    return None if found.is_point or found.name == "night" else Wall(part=found)


@grammar.rule(
    "wall", "the? whole|entire|all|entirety of <days>", "the? whole|entirety of <parted>", weight=0.3
)
def whole_period(found: Calendar | Part) -> Wall:
    """The whole of next week."""
    return Wall(part=found) if isinstance(found, Part) else Wall(found)


@grammar.rule("wall", "all|whole day <days>|<date>", "all|whole day on <days>|<date>", weight=0.4)
def all_day(days: Calendar) -> Wall | None:
    """All day tomorrow, all day on friday."""
    return Wall(days) if days.grain is Unit.DAY else None


@grammar.rule("wall", "at|during|over the? <meal>", "at|during|over my|your|our|his|her|their <meal>")
@grammar.rule(
    "wall",
    "on my|your|our|his|her|their <meal>",
    "on|in the|my|your|our|his|her|their <meal> break",
    weight=0.3,
)
@grammar.rule("wall", "all|right? through|throughout the? <meal>", weight=0.3)
@grammar.rule("wall", "for <meal>", weight=0.1)
def at_meal(found: Part) -> Wall | None:
    """At lunch, during our dinner, on my lunch break, (meet Sam) for lunch; "at school" is where."""
    return None if found.place else Wall(part=found)


@grammar.rule("wall", "<meal>", weight=-0.1)
def meal(found: Part) -> Wall:
    """Lunch: a thing, unless a preposition makes it a time."""
    return Wall(part=found, weak=True)


@grammar.rule("wall", "<deictic> <parted>", "<share> <deictic> <part>", weight=0.1)
def deictic_part(first: object, second: object, third: Part | None = None) -> Wall | None:
    """This morning, next evening, late this morning."""
    which, found = (first, second) if third is None else (second, third)
    if not isinstance(which, Which) or not isinstance(found, Part) or found.is_point:
        return None
    if third is not None and isinstance(first, tuple):
        found = found.share(*first)
    return Wall(Relative(which.offset, onward=which is Which.NEXT), found)


@grammar.rule("wall", "<share>? <day_part>", weight=0.3)
def tonight(share: tuple[float, float] | None, found: tuple[Relative, Part]) -> Wall:
    """Tonight, late last night."""
    days, part_of_day = found
    return Wall(days, part_of_day if share is None else part_of_day.share(*share))


@grammar.rule("wall", "<share> <days>|<date>", "<share> in? the day", weight=0.1)
def later_today(share: tuple[float, float], days: Calendar | None = None) -> Wall | None:
    """Later today, early tomorrow, late on friday."""
    if days is not None and (days.grain is not Unit.DAY or _is_several_days(days)):
        return None
    low, high = share
    whole = Part(WHOLE_DAY, 0, 24 * 3600, Half.DAY)
    return Wall(days or Relative(0), whole.share(low, high))


@grammar.rule("wall", "<days>|<date> <day_half>", weight=0.1)
def day_half(days: Calendar, half: Part) -> Wall | None:
    """Tuesday am; but "sunday week 4 pm" is at four."""
    return Wall(days, half) if days.grain is Unit.DAY else None


@grammar.rule("said", "<day_half>", weight=-0.2)
def half_alone(half: Part) -> Said:
    """AM, in front of what is to be done then."""
    return Said(Wall(part=half))


@grammar.rule("wall", "<share> <days> <part>", weight=0.3)
def share_of_day_part(share: tuple[float, float], days: Calendar, found: Part) -> Wall | None:
    """Early tomorrow morning, first thing monday morning."""
    return None if found.is_point else Wall(days, found.share(*share))


@grammar.rule("days", "<share> the? <days>|<date>", "<share> <month>", "<share> the? <season>", weight=0.3)
def share_of_days(share: tuple[float, float], days: Calendar | int) -> Calendar | None:
    """Early next week, mid november, late winter, halfway through lent."""
    whole = Fields(month=days) if isinstance(days, int) else days
    return None if whole.grain is Unit.DAY and not _is_several_days(whole) else Share(*share, whole)


@grammar.rule(
    "days", "<share> to|- <share> <days>|<date>", "<share> to|- <share> <month>|<season>", weight=1.3
)
def shares_of_days(
    first: tuple[float, float], last: tuple[float, float], days: Calendar | int
) -> Calendar | None:
    """Mid to late july."""
    return share_of_days((first[0], last[1]), days) if first[0] < last[0] else None


def _is_several_days(days: Calendar) -> bool:
    """Whether it is a season, or a feast of several days."""
    feast = feast_in(days)
    return isinstance(days.of if isinstance(days, Deictic) else days, Season) or (
        feast is not None and feast.is_several
    )


@grammar.rule("days", "the week before <days>|<date>", weight=0.4)
def week_before(days: Calendar) -> Calendar | None:
    """The week before christmas."""
    return WeekOf(Away(-1, Unit.WEEK, days)) if days.grain is Unit.DAY else None


@grammar.rule("days", "the week after <days>|<date>", weight=0.4)
def week_after(days: Calendar) -> Calendar | None:
    """The week after easter."""
    return WeekOf(Away(1, Unit.WEEK, days)) if days.grain is Unit.DAY else None


@grammar.rule("end", "the? <edge> of? the? <days>|<series>|<date>|<weak date>", "the? <ending>", weight=0.2)
def ending(first: Edge | Ending, days: Calendar | None = None) -> Ending:
    """End of the month, the beginning of next week, eod."""
    if isinstance(first, Ending):
        return replace(first, days=Deictic(Which.THIS, first.days))
    if isinstance(days, Cycle):
        return Ending(first, Deictic(Which.THIS, days))
    return Ending(first, days or Relative(0))


@grammar.rule("end", "the? <series> 's end", weight=0.5)
def end_of_its_own(series: Calendar) -> Ending | None:
    """(by) the week's end."""
    return Ending(Edge.END, Deictic(Which.THIS, series)) if isinstance(series, Cycle) else None


@grammar.rule("end", "<end> ,? <wall>", "<end> on|of the? <wall>", weight=0.6)
def ending_of_day(end: Ending, wall: Wall) -> Ending | None:
    """The end of the day tomorrow, eod friday, eod 3/13."""
    return ending_on(end, wall.days) if wall.part is None and wall.clock is None else None


@grammar.rule("end", "<wall> ,? <end>", weight=0.6)
def ending_behind_day(wall: Wall, end: Ending) -> Ending | None:
    """Friday eod."""
    return ending_of_day(end, wall)


@grammar.rule(
    "rest",
    "the? rest|remainder of? the|my <days>|<series>",
    "the? rest|remainder of <days>|<series>",
    "remaining of? the|my? <days>|<series>",
    weight=0.2,
)
def rest(days: Calendar) -> Rest:
    """The rest of the day."""
    return Rest(Wall(Deictic(Which.THIS, days) if isinstance(days, Cycle) else days))


@grammar.rule(
    "rest", "the? rest|remainder of? the|this|my <part>", "the? rest|remainder of <part>", weight=0.25
)
def rest_of_part(part: Part) -> Rest:
    """The rest of the morning."""
    return Rest(Wall(Relative(0), part))
