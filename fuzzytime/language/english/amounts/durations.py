"""Lengths of time: "ten minutes", "an hour and a half", "1h30"."""

from collections.abc import Callable
from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import SMALLER, Integer, Typed
from fuzzytime.language.grammar.understood.minutes_of_steps import MARKS
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.units import UNIT_SECONDS, Quantity, UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()

METRES = 100
"""From how many on "m" is hardly minutes: "turn left in 300 m"."""

SEVERAL = 2
"""Turns between which there is a rest."""

TURNS = "<integer> x|× <duration> hard|fast|on|work?"
"""How often, and for how long, something is done."""

BETWEEN = (
    "a? <duration> rest|rests|break|breaks|pause|recovery|off|easy|slow|jog|walk|walking|jogging|standing"
)
"""How long nothing, or less, is done between the turns."""

YEARS = range(1800, 2100)
"""Numbers that an "s" makes a decade: "hits of the 1980s"."""

LARGEST = 1e11
"""Seconds that a length of time may have at most, about three thousand years."""


def length_of(quantity: Quantity, unit: UnitWord) -> Duration | None:
    """Give so many units as a length; None where they are hardly one."""
    amount = quantity.value * unit.count
    # "a m" is half of "10 a m".
    # "In a mo": a moment, no month.
    short = len(unit.form) == 1 or unit.form == "mo"
    if unit.form == "m" and amount >= METRES:
        return None
    if unit.form == "s" and amount % 10 == 0 and amount in YEARS:
        # "The 1990s"
        return None
    if amount * UNIT_SECONDS[unit.unit] > LARGEST or (quantity.indefinite and short):
        return None
    return Duration(
        ((amount, unit.unit),),
        quantity.hedges,
        ordinal_end=unit.form == "second",
        indefinite=quantity.indefinite,
    )


AFTERTHOUGHT = "or so"
"""The hedge of what is said behind a length, and ends it."""


@grammar.rule("duration", "<quantity> <unit>")
def amount(quantity: Quantity, unit: UnitWord) -> Duration | None:
    """Ten minutes, a few hours, 2.5 h, another week."""
    return length_of(quantity, unit)


@grammar.rule("duration", "<fraction> of? a|an|one|the? <unit>", "<quantity> of a|an|the? <unit>")
def fraction_of(part: float | Quantity, unit: UnitWord) -> Duration | None:
    """Half an hour, a quarter of an hour, three quarters of an hour, one and a quarter of hour."""
    quantity = part if isinstance(part, Quantity) else Quantity(part)
    return length_of(quantity, unit) if quantity.value != 1 and not quantity.indefinite else None


@grammar.rule("duration", "<quantity> <unit> and|- <fraction>", "<quantity> <unit> an|n|and a? <fraction>")
def and_a_half(quantity: Quantity, unit: UnitWord, fraction: float) -> Duration | None:
    """An hour and a half, one month and half, as it is heard: an hour an a half."""
    return length_of(Quantity(quantity.value + fraction, quantity.hedges), unit)


@grammar.rule("duration", "<unit> and a <fraction>", weight=-0.2)
def one_and_a_half(unit: UnitWord, fraction: float) -> Duration | None:
    """(leave at two,) hour and a half drive: the article is left out."""
    return length_of(Quantity(1 + fraction), unit)


@grammar.rule("duration", "<quantity> <unit> and a bit|little")
def and_a_bit(quantity: Quantity, unit: UnitWord) -> Duration | None:
    """An hour and a bit."""
    length = length_of(quantity, unit)
    return None if length is None else length.hedged("about")


@grammar.rule("duration", "<duration> , <duration>", weight=0.1)
def listed(first: Duration, second: Duration) -> Duration | None:
    """2 years, 3 months; but "for a week, an hour before food" are two lengths."""
    return None if first.indefinite or second.indefinite else said_together(first, second)


@grammar.rule("duration", "<duration> <duration>", weight=0.1)
def said_together(first: Duration, second: Duration) -> Duration | None:
    """1 hour 30 minutes; but "18h30 three days from now" is half past six on that day."""
    in_a_day = first.terms[-1][1] in SUB_DAY
    return sum_of(first, second) if second.unit in SUB_DAY or not in_a_day else None


@grammar.rule("duration", "<duration> and <duration>", "<duration> , and <duration>", weight=0.1)
def sum_of(first: Duration, second: Duration) -> Duration | None:
    """1 hour and 30 minutes; 2 years, 3 months; "an hour and a quarter" has no quarter of a year."""
    units, more = ({unit for _, unit in duration.terms} for duration in (first, second))
    if first.bare_end or first.until or second.until or second.hedges or units & more or Unit.QUARTER in more:
        return None
    if AFTERTHOUGHT in first.hedges:
        # "At least thirty minutes, ideally two hours"
        return None
    # "a day an hour", "an hour a day" are frequencies, no sums.
    often = first.terms[0][0] != 1 or second.seconds > first.seconds
    if second.indefinite and len(first.terms) == 1 and often:
        return None
    return replace(first, terms=(*first.terms, *second.terms), ordinal_end=second.ordinal_end)


@grammar.rule("duration", "<integer> x|× <duration>", weight=0.1)
def times_as_long(number: Integer, duration: Duration) -> Duration | None:
    """2 x 10 minutes: twice that, in all."""
    if number.value < 1 or duration.hedges or duration.until is not None or duration.indefinite:
        return None
    return replace(duration, terms=tuple((number.value * amount, unit) for amount, unit in duration.terms))


@grammar.rule(
    "duration",
    f"{TURNS} with {BETWEEN}",
    f"{TURNS} with|, {BETWEEN} in? between",
    f"{TURNS} with|, {BETWEEN} between|after each|sets|them|reps",
    weight=0.2,
)
def with_rests(number: Integer, work: Duration, rest: Duration) -> Duration | None:
    """3 x 5 min with 2 min rest: all of it, with two rests."""
    if number.value < SEVERAL or work.bare_end or rest.bare_end:
        return None
    seconds = number.value * work.seconds + (number.value - 1) * rest.seconds
    return Duration(((seconds / UNIT_SECONDS[Unit.MINUTE], Unit.MINUTE),))


@grammar.rule("duration", "<duration> more|longer|extra", weight=0.1)
def more_of(duration: Duration) -> Duration | None:
    """A minute more, ten minutes longer."""
    return None if duration.until is not None or duration.bare_end else replace(duration, ordinal_end=False)


@grammar.rule("duration", "<duration> and? <integer>", weight=-0.2)
def tail(first: Duration, number: Integer) -> Duration | None:
    """1 hour fifteen, 2 hours and 10."""
    _, unit = first.terms[-1]
    if (
        first.bare_end
        or first.hedges
        or unit not in SMALLER
        or unit not in {Unit.HOUR, Unit.MINUTE}
        or not 1 <= number.value < 60
    ):
        return None
    return replace(first, terms=(*first.terms, (number.value, SMALLER[unit])), bare_end=True)


@grammar.rule("duration", "<duration> less|minus <duration>", weight=0.4)
def less(longer: Duration, shorter: Duration) -> Duration | None:
    """An hour less five minutes."""
    seconds = longer.seconds - shorter.seconds
    if seconds <= 0 or longer.until is not None or shorter.until is not None or shorter.bare_end:
        return None
    return Duration(((seconds / 60, Unit.MINUTE),), (*longer.hedges, *shorter.hedges))


@grammar.rule("duration", "<15h30>", weight=-0.15)
def typed(numbers: Typed) -> Duration | None:
    """1h30."""
    hours, minutes = numbers[0], numbers[1]
    return Duration(((hours, Unit.HOUR), (minutes, Unit.MINUTE))) if minutes < 60 else None


@grammar.rule("duration", "<integer> hr|hrs|hour|hours <integer>", weight=0.2)
def hours_and_minutes(hours: Integer, minutes: Integer) -> Duration | None:
    """1hr30, 2 hrs 15."""
    typed = bool(hours.digits) and len(minutes.digits) == 2
    if not typed or minutes.value >= 60:
        return None
    return Duration(((hours.value, Unit.HOUR), (minutes.value, Unit.MINUTE)))


@grammar.rule("duration", "<hh:mm> <unit>", "<hh:mm> long", weight=-0.1)
def typed_with_unit(numbers: Typed, unit: UnitWord | None = None) -> Duration | None:
    """1:30 hours."""
    if numbers[1] >= 60 or (unit is not None and unit.unit not in {Unit.HOUR, Unit.MINUTE}):
        return None
    large = unit.unit if unit is not None else Unit.HOUR
    return Duration(((numbers[0], large), (numbers[1], SMALLER[large])))


@grammar.rule("duration", "<integer> ms|msec|millisecond|milliseconds")
def milliseconds(number: Integer) -> Duration:
    """500 ms."""
    return Duration(((number.value / 1000, Unit.SECOND),))


@grammar.rule("duration", "<integer> '")
def minutes_mark(number: Integer) -> Duration | None:
    """2'."""
    return Duration(((number.value, Unit.MINUTE),)) if number.digits else None


def _of_step(unit: Unit) -> Callable[[Quantity], Duration]:
    def of_step(number: Quantity) -> Duration:
        """(simmer 20 min, rest) 5, (hold for 30 seconds, rest) 10, (wait 2 hours, paint, wait) 4."""
        return Duration(((number.value, unit),), number.hedges, unsaid=True)

    return of_step


for _unit, _mark in MARKS.items():
    grammar.rule("duration", f"<quantity> {_mark}")(_of_step(_unit))


@grammar.rule("duration", '<integer> "')
def seconds_mark(number: Integer) -> Duration | None:
    """30"."""
    return Duration(((number.value, Unit.SECOND),)) if number.digits else None


@grammar.rule("duration", "all|full|whole|entire -? <unit>", "the|an|a whole|full|entire <unit>", weight=-0.1)
def whole_of(unit: UnitWord) -> Duration | None:
    """All day, a full week; "all night" is when, not how long."""
    return Duration(((unit.count, unit.unit),)) if unit.form != "night" else None


@grammar.rule("duration", "a|an good|solid <fraction> <unit>", weight=0.1)
def a_good_part(fraction: float, unit: UnitWord) -> Duration | None:
    """A good half hour: that long, or longer."""
    found = length_of(Quantity(fraction), unit)
    return None if found is None or fraction == 1 else found.hedged("at least")


@grammar.rule("duration", "<hedge> the? <duration>", weight=0.05)
def hedged(hedge: str, duration: Duration) -> Duration:
    """Roughly ten minutes, at least an hour."""
    return duration.hedged(hedge)


@grammar.rule("duration", "<duration> -|,? <hedge_after>", weight=0.05)
def hedged_after(duration: Duration, hedge: str) -> Duration:
    """Ten minutes or so, half an hour at most."""
    return replace(duration, hedges=(*duration.hedges, hedge))
