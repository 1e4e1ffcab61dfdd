"""Days that are left out of a repetition: "every day except sundays", "at six except on weekends"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import Repeat, Wall
from fuzzytime.language.meaning.joined.weekdays_left_out import without_weekdays
from fuzzytime.requirement import Unit

grammar = Grammar()


@grammar.rule(
    "repeat",
    "<repeat> ,? except|but|excluding|bar|save|unless for|not? on|at? <weekday list>|<weekdays>|<off>",
    "<repeat> ,? and? not on|at? <weekday list>|<weekdays>|<off>",
    "<repeat> ,? apart|aside|other from|than on|at? <weekday list>|<weekdays>|<off>",
    "<repeat> ( except|but|excluding|bar|not|no for|not? on|at? <weekday list>|<weekdays>|<off> )",
    weight=0.6,
)
def except_on(repeat: Repeat, days: tuple[int, ...] | int) -> Repeat | None:
    """Every day except sundays, on weekdays but friday, every day apart from sunday."""
    return without_weekdays(repeat, days if isinstance(days, tuple) else (days,))


@grammar.rule("left out days", "<weekdays>|<off>")
@grammar.rule("left out days", "<weekdays> and|, <weekdays>", weight=0.7)
def left_out_days(days: tuple[int, ...] | int, more: int | None = None) -> tuple[int, ...]:
    """Weekends, saturdays and sundays."""
    return (*(days if isinstance(days, tuple) else (days,)), *(() if more is None else (more,)))


@grammar.rule(
    "repeat",
    "at|in the? <wall> ,? except|excluding|bar|but|unless for|on? <left out days>",
    "at|in the? <wall> ,? but? not on? <left out days>",
    weight=0.7,
)
def daily_except_on(wall: Wall, days: tuple[int, ...]) -> Repeat | None:
    """At six except on weekends: on the other days."""
    if wall.days is not None or (wall.clock is None and wall.part is None):
        return None
    return without_weekdays(Repeat(walls=(replace(wall, days=Cycle(Unit.DAY)),)), days)


@grammar.rule("off", "weekends", "the? weekend")
def off() -> tuple[int, ...]:
    """Weekends, as what is left out of a repetition."""
    return (5, 6)
