"""Durations with a preposition, from now on: "in about ten minutes", "within the hour", "two days ago"."""

from dataclasses import replace

from fuzzytime.language.english.amounts.durations import typed
from fuzzytime.language.english.clock_times.clocks import minutes_of
from fuzzytime.language.english.clock_times.hours_with_h import EARLIEST_WITH_MINUTES
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.expressions import Coming, Duration, Goal, Said
from fuzzytime.language.meaning.joined.distances import LATER, UPPER, said_length, said_offset
from fuzzytime.language.meaning.units import UNIT_SECONDS, Quantity, UnitWord
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


def coming_deadline(goal: Goal) -> Said:
    """Give "the next ten minutes" as a deadline: ten minutes from now."""
    time = goal.time
    duration = time.duration if isinstance(time, Coming) else Duration(())
    return said_length(duration.hedged(*goal.hedges), Constraint.BEFORE, "before")


@grammar.rule(
    "said",
    "in the? <duration>",
    "in <duration> time",
    "in <duration> '|'s time",
    "in <duration> from now",
    weight=0.3,
)
@grammar.rule("said", "starting|beginning|commencing in <duration>", weight=0.4)
@grammar.rule("said", "today in <duration>", weight=0.5)
def in_duration(duration: Duration) -> Said:
    """In ten minutes, in half an hour's time, starting in an hour."""
    return said_length(duration, Constraint.AT, "in")


@grammar.rule("said", "in <duration> ,? about", weight=0.4)
@grammar.rule(
    "said", "in like|say ,? <duration>", "in about|around|roughly ,? say|like ,? <duration>", weight=0.6
)
def in_like(duration: Duration) -> Said:
    """In like ten minutes, in ten minutes about; but "write in ten minutes about the flat" is refused."""
    return said_length(duration.hedged("about"), Constraint.AT, "in")


@grammar.rule("said", "in <quantity>", weight=-0.1)
def in_number(quantity: Quantity) -> Said | None:
    """In 15: minutes."""
    if not 1 <= quantity.value <= 240 or quantity.indefinite or quantity.value != int(quantity.value):
        return None
    return said_length(minutes_of(quantity), Constraint.AT, "in")


@grammar.rule("said", "in <integer> -|to|or <integer>", weight=0.6)
def in_numbers(first: Integer, last: Integer) -> Said | None:
    """In 5-10: minutes."""
    if not 1 <= first.value < last.value <= 240:
        return None
    shorter, longer = (minutes_of(Quantity(number.value)) for number in (first, last))
    return said_length(replace(shorter, until=longer), Constraint.AT, "in")


@grammar.rule(
    "said",
    "after <duration>",
    "after another <duration>",
    "after the? first|initial <duration>",
    "<hedge> after <duration>",
    weight=0.3,
)
def after_duration(first: str | Duration, second: Duration | None = None) -> Said | None:
    """After ten minutes."""
    duration = second if isinstance(first, str) else first
    if duration is None:
        return None
    hedges = (first,) if isinstance(first, str) else ()
    # "After not more than two minutes"
    bounded = not UPPER.isdisjoint(duration.hedges) and duration.until is None
    return said_length(duration.hedged(*hedges), Constraint.BEFORE if bounded else Constraint.AFTER, "after")


@grammar.rule("said", "after another <integer>", "after <integer> more", weight=0.3)
def after_another(number: Integer) -> Said:
    """(flip it after two minutes and again) after another two: of the unit that was said before."""
    return said_length(minutes_of(Quantity(number.value)), Constraint.AFTER, "after")


@grammar.rule("said", "after <hedge>? <15h30>", "after <hedge>? <hh:mm> hours|hrs", weight=0.9)
def after_typed(hedge: str | None, numbers: Typed) -> Said | None:
    """After 1h20, after about 1:30 hours; but "after 14h30", "after 06h30", "after 13:30 hours"."""
    duration = typed(numbers)
    if duration is None or numbers[0] >= EARLIEST_WITH_MINUTES or numbers.parts[0].startswith("0"):
        return None
    return after_duration(duration if hedge is None else duration.hedged(hedge))


@grammar.rule(
    "said",
    "before|within|in <hedge>? the? next <duration>",
    "before|within|in the? <hedge>? next <duration>",
    weight=0.6,
)
def before_the_next(hedge: str | None, duration: Duration) -> Said:
    """Before the next ten minutes, before approximately the next ten minutes."""
    return said_length(duration.hedged(*([hedge] if hedge else [])), Constraint.BEFORE, "before")


@grammar.rule("said", "before|within|in|over|during the? next|coming <unit> or <quantity>", weight=0.6)
def before_the_next_or_two(unit: UnitWord, more: Quantity) -> Said | None:
    """In the next hour or two."""
    if len(unit.form) == 1 or more.indefinite or more.value <= 1:
        return None
    last = Duration(((more.value * unit.count, unit.unit),), bare_end=True)
    return said_length(Duration(((unit.count, unit.unit),), until=last), Constraint.BEFORE, "before")


@grammar.rule("said", "before <duration>", "before <duration> from now", weight=0.2)
def before_duration(duration: Duration) -> Said:
    """Before ten minutes."""
    return said_length(duration, Constraint.BEFORE, "before")


@grammar.rule("said", "<within> the? <duration>", "<within> <duration> from now|today", weight=0.5)
def within(preposition: Preposition, duration: Duration) -> Said:
    """Within ten minutes; another such preposition counts from now as it binds."""
    return said_length(duration, preposition.constraint, preposition.name)


@grammar.rule("said", "within|in the <unit>", weight=0.3)
def within_the_hour(unit: UnitWord) -> Said | None:
    """Within the hour."""
    if unit.unit not in {Unit.HOUR, Unit.MINUTE} or len(unit.form) == 1:
        return None
    return said_length(Duration(((unit.count, unit.unit),)), Constraint.BEFORE, "within")


@grammar.rule("said", "<preposition_before> in <duration>", weight=0.5)
@grammar.rule("said", "<preposition_before>|<within> <duration> <forward>", weight=0.3)
def deadline_in(preposition: Preposition, duration: Duration, _forward: Preposition | None = None) -> Said:
    """No later than in ten minutes, before ten minutes from now."""
    return said_length(duration, Constraint.BEFORE, preposition.name)


@grammar.rule(
    "said",
    "<preposition_after> in <duration>",
    "<preposition_after> <duration>",
    "<preposition_after> <duration> from now",
    "not for another? <duration>",
    "not in less than <duration>",
    weight=0.5,
)
def not_for(first: Preposition | Duration, second: Duration | None = None) -> Said | None:
    """No sooner than in ten minutes, not before ten minutes, not for another ten minutes."""
    if isinstance(first, Preposition) and first.name != "not before":
        return None
    duration = first if isinstance(first, Duration) else second
    if duration is None or (duration.hedges and len(duration.terms) > 1 and _is_late_clock(duration)):
        return None
    return said_length(duration, Constraint.AFTER, "not before")


def _is_late_clock(duration: Duration) -> bool:
    """Whether hours and minutes are rather a clock time: "not before about 14h30"."""
    hours = duration.seconds / UNIT_SECONDS[Unit.HOUR]
    return EARLIEST_WITH_MINUTES <= hours < UNIT_SECONDS[Unit.DAY] / UNIT_SECONDS[Unit.HOUR]


@grammar.rule("said", "<duration> <forward>", "<duration> '|'s <forward>", weight=0.3)
def from_now(duration: Duration, preposition: Preposition) -> Said:
    """Ten minutes from now, half an hour later."""
    return said_offset(duration, preposition.name)


@grammar.rule("said", "<duration> in", weight=0.2)
@grammar.rule(
    "said",
    "when|once|after it's|its|it been <duration>",
    "when|once|after it has been <duration>",
    weight=0.5,
)
def so_far_in(duration: Duration) -> Said:
    """Ten minutes in, when it's been ten minutes: counted from what was begun."""
    return said_offset(duration, LATER)


@grammar.rule("said", "<duration> <back>", weight=0.3)
def ago(duration: Duration, preposition: Preposition) -> Said:
    """Two days ago."""
    return said_offset(duration, preposition.name, -1)


@grammar.rule(
    "said", "<preposition_at> <duration> <forward>", "<preposition_at> <duration> ' <forward>", weight=0.3
)
def at_offset(first: Preposition, duration: Duration, second: Preposition) -> Said | None:
    """For five minutes from now."""
    return said_offset(duration, first.name) if second.name == "from now" else None


@grammar.rule("said", "past <duration> from now|hence", weight=0.5)
def past_offset(duration: Duration) -> Said:
    """Past ten minutes from now: not before that."""
    return said_length(duration, Constraint.AFTER, "after")
