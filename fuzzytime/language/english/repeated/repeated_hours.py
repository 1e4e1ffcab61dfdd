"""Repetitions with times of day: "daily at nine", "twice a day, at eight and six"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Cycle, is_weekday
from fuzzytime.language.meaning.expressions import Repeat, Said, Wall
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat, timed_as
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Part
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("repeat", "<repeat> at|@|on|in|around the? <wall>", "<repeat> , on|at the? <wall>", weight=0.2)
def repeat_at(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Every day at nine, on mondays at 4pm."""
    return narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "<repeat> ,? the? <wall>", weight=0.2)
def repeat_beside(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Every day 9 am, every day this week; but of "every two minutes, 15 children" no number is an hour."""
    counted = wall.bare and repeat.every is not None and repeat.every.seconds < DAY_SECONDS
    return None if counted else narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "<wall> ,|on? <repeat>", weight=0.2)
def clock_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """9am on sundays, 0815 on weekdays; but "two nights" are no nights at two."""
    sure = wall.clock is not None and wall.clock.full_day and wall.clock.grain is Unit.MINUTE
    counts = wall.bare or _counts(wall, repeat)
    return None if (counts and not sure) or wall.weak else narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "at|@ <wall> ,|on? <repeat>", weight=0.2)
def at_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """At noon every day, at nine on weekdays; but "at night for three | nights" has no hour."""
    return None if _counts(wall, repeat) and not wall.bare else narrowed_repeat(repeat, wall)


@grammar.rule(
    "said", "for <wall> ,|on? <repeat>", "for <wall> on? <repeat> ,|and <wall> on? <repeat>", weight=0.4
)
def for_repeat(wall: Wall, repeat: Repeat, *more: Wall | Repeat) -> Said | None:
    """(an alarm) for six on weekdays and eight at weekends."""
    found = None if _counts(wall, repeat) else narrowed_repeat(repeat, wall)
    if more and found is not None:
        second, days = more
        other = (
            narrowed_repeat(days, second) if isinstance(days, Repeat) and isinstance(second, Wall) else None
        )
        found = None if other is None else both(found, other)
    return None if found is None else Said(found, Constraint.EVERY, "for")


@grammar.rule("repeat", "on|in <wall> ,|on? <repeat>", weight=0.2)
def in_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """In the morning every day; but "in two working days" is none."""
    return None if wall.bare or _counts(wall, repeat) else narrowed_repeat(repeat, wall)


def _counts(wall: Wall, repeat: Repeat) -> bool:
    """Whether the number that a time ends in says how many parts of the day those behind it are."""
    return repeat.plural and wall.clock is not None and (wall.clock.bare or wall.part is not None)


@grammar.rule("repeat", "<repeat> ,|and at|@? <wall>", "at|@? <wall> ,|and <repeat>", weight=0.3)
def more_clocks(first: Repeat | Wall, second: Wall | Repeat) -> Repeat | None:
    """Every day at 8 am and 8 pm, at eight and nine every day."""
    repeat, wall = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat) or not isinstance(wall, Wall) or wall.clock is None:
        return None
    clocked = bool(repeat.walls) and all(old.clock is not None for old in repeat.walls)
    if not clocked or wall.days is not None or wall.part is not None:
        return None
    clock = replace(wall.clock, bare=False, pair=False)
    more = dict.fromkeys(replace(old, clock=clock) for old in repeat.walls)
    return replace(repeat, walls=tuple(dict.fromkeys((*repeat.walls, *more))))


@grammar.rule("moments", "<wall>", weight=-0.1)
def moment(wall: Wall) -> tuple[Wall, ...] | None:
    """At eight, in the morning."""
    return (wall,) if wall.days is None and (wall.clock is not None or wall.part is not None) else None


@grammar.rule("moments", "<day_half>", weight=-0.1)
def half_as_moment(half: Part) -> tuple[Wall, ...]:
    """(twice a day) am (and pm)."""
    return (Wall(part=half),)


@grammar.rule(
    "moments",
    "<moments> ,|and|& at|@|in|once? <wall>|<day_half>",
    "<moments> , and at|@|in|once? <wall>|<day_half>",
)
def more_moments(moments: tuple[Wall, ...], further: Wall | Part) -> tuple[Wall, ...] | None:
    """At eight, at noon and at six."""
    last = moment(further) if isinstance(further, Wall) else half_as_moment(further)
    return None if last is None else (*moments, *last)


@grammar.rule(
    "repeat",
    "<repeat> ,|:|-? at|@|in|once? <moments>",
    "<repeat> ( at|@|in|once? <moments> )",
    "at|@|in? <moments> , <repeat>",
    weight=0.7,
)
def so_often_at(first: Repeat | tuple[Wall, ...], second: tuple[Wall, ...] | Repeat) -> Repeat | None:
    """Twice a day, at eight and six; three times a day: morning, noon and night; twice a day (am and pm)."""
    repeat, moments = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat) or isinstance(moments, Repeat) or repeat.every is None:
        return None
    if (
        not repeat.shared
        or len(moments) == 1
        or repeat.every.seconds * len(moments) != UNIT_SECONDS[Unit.DAY]
    ):
        return None
    clocks = (wall.clock and replace(wall.clock, bare=False, pair=False) for wall in moments)
    walls = (
        replace(wall, days=Cycle(Unit.DAY), clock=clock, weak=False)
        for wall, clock in zip(moments, clocks, strict=True)
    )
    return Repeat(walls=tuple(walls))


@grammar.rule("repeat", "at|@ <wall> ,|and <wall> <repeat>", weight=0.35)
def two_clocks(first: Wall, second: Wall, repeat: Repeat) -> Repeat | None:
    """At 8 and 20 daily."""
    once = narrowed_repeat(repeat, second) if second.clock is not None else None
    return None if once is None else more_clocks(once, first)


@grammar.rule(
    "repeat",
    "<repeat> ,|and at? <wall> on? <repeat>",
    "<repeat> ,|and for|at|on? <repeat>",
    "<repeat> , and for|at|on? <repeat>",
    weight=0.35,
)
def both(first: Repeat, second: Wall | Repeat, third: Repeat | None = None) -> Repeat | None:
    """At 8 every morning and at 8 every night, every monday morning and every friday evening."""
    other = second if third is None and isinstance(second, Repeat) else None
    if third is not None and isinstance(second, Wall):
        other = narrowed_repeat(third, second)
    if other is None or not all(_is_plain(repeat) for repeat in (first, other)):
        return None
    # "On saturdays and sundays at ten", "at ten on saturdays and sundays"
    first, other = timed_as(first, other), timed_as(other, first)
    return replace(first, every=None, walls=tuple(dict.fromkeys((*first.walls, *other.walls))))


def _is_plain(repeat: Repeat) -> bool:
    """Whether it is nothing but days with times of day, or weekdays."""
    timed = all(wall.clock is not None or wall.part is not None for wall in repeat.walls)
    timed = timed or all(is_weekday(wall.days) for wall in repeat.walls)
    return bool(repeat.walls) and timed and repeat.skip == 1 and not (repeat.starting or repeat.until)
