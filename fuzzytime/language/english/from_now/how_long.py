"""How long something takes, from now on: "for eight minutes", "over the next two hours"."""

from dataclasses import replace

from fuzzytime.language.english.clock_times.clocks import minutes_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.expressions import Coming, Duration, Said, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.distances import said_length
from fuzzytime.language.meaning.units import Quantity, UnitWord
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("said", "for like|say ,? <duration>", weight=0.6)
def for_like(duration: Duration) -> Said:
    """For like ten minutes."""
    return said_length(duration.hedged("about"), Constraint.FOR, "for")


@grammar.rule(
    "said",
    "for <duration>",
    "for another <duration>",
    "for a? total of <duration>",
    "for <duration> in? total|all|altogether",
    "lasting|taking|of? <duration> long",
    "lasting|taking <duration>",
    weight=0.35,
)
def for_duration(duration: Duration) -> Said:
    """For eight minutes, for the next hour."""
    return said_length(duration, Constraint.FOR, "for")


@grammar.rule("said", "for another <integer>", weight=0.2)
def for_another(number: Integer) -> Said:
    """For another five: minutes."""
    return said_length(minutes_of(Quantity(number.value)), Constraint.FOR, "for")


@grammar.rule("said", "during|in|within the? first <duration>", weight=0.5)
@grammar.rule("said", "over|during|for the? next|coming <duration>", weight=0.5)
def over_the_next(duration: Duration) -> Said:
    """Over the next two hours, during the first twenty minutes: any time in them."""
    return Said(Coming(replace(duration, hedges=())), Constraint.BETWEEN, "during", duration.hedges)


@grammar.rule("said", "for the next|coming <unit>", weight=0.5)
def for_the_next_one(unit: UnitWord) -> Said | None:
    """For the next week, as for the next seven days: from now on."""
    if len(unit.form) == 1 or unit.unit in SUB_DAY or unit.unit is Unit.DAY:
        return None
    return over_the_next(Duration(((unit.count, unit.unit),)))


@grammar.rule("said", "for the? first <duration>", weight=0.5)
def for_the_first(duration: Duration) -> Said:
    """For the first twenty minutes."""
    return replace(over_the_next(duration), preposition="for")


@grammar.rule(
    "said",
    "for|during|in|within the? first <unit>",
    "for|during|in|within the? first <unit> and a? <fraction>",
    weight=0.5,
)
def for_the_first_one(unit: UnitWord, fraction: float = 0.0) -> Said | None:
    """For the first hour, in the first hour and a half; but "for the first quarter" is of a year."""
    length = Duration(((unit.count * (1 + fraction), unit.unit),))
    return for_the_first(length) if len(unit.form) > 1 and unit.unit in SUB_DAY else None


@grammar.rule("said", "for the? <stretch>", weight=0.45)
def for_stretch(stretch: Wall | Coming) -> Said | None:
    """For the next hour: that long, from now."""
    if not isinstance(stretch, Coming) or stretch.direction < 0:
        return None
    return said_length(stretch.duration, Constraint.FOR, "for")


@grammar.rule("said", "<duration>", weight=-0.2)
def duration_alone(duration: Duration) -> Said:
    """Ten minutes: how long."""
    return said_length(duration, Constraint.FOR, None)
