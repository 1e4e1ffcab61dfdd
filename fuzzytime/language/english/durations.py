"""Lengths of time: "ten minutes", "an hour and a half", "1h30", "five to ten minutes"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import SMALLER, Integer, Typed
from fuzzytime.language.meaning.expressions import UNIT_SECONDS, Duration, Quantity, UnitWord
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.requirement import Unit

grammar = Grammar()

METRES = 100
"""From how many on "m" is hardly minutes: "turn left in 300 m"."""

YEARS = range(1800, 2100)
"""Numbers that an "s" makes a decade: "hits of the 1980s"."""

FIVE = 5
"""What larger numbers of minutes are counted in."""

LARGEST = 1e11
"""Seconds that a length of time may have at most, about three thousand years."""


def _length(quantity: Quantity, unit: UnitWord) -> Duration | None:
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
    return _length(quantity, unit)


@grammar.rule("duration", "<fraction> of? a|an|one|the? <unit>", "<quantity> of a|an|the? <unit>")
def fraction_of(part: float | Quantity, unit: UnitWord) -> Duration | None:
    """Half an hour, a quarter of an hour, three quarters of an hour, one and a quarter of hour."""
    quantity = part if isinstance(part, Quantity) else Quantity(part)
    return _length(quantity, unit) if quantity.value != 1 and not quantity.indefinite else None


@grammar.rule("duration", "<quantity> <unit> and|- <fraction>")
def and_a_half(quantity: Quantity, unit: UnitWord, fraction: float) -> Duration | None:
    """An hour and a half, one month and half."""
    return _length(Quantity(quantity.value + fraction, quantity.hedges), unit)


@grammar.rule("duration", "<quantity> <unit> and a bit|little")
def and_a_bit(quantity: Quantity, unit: UnitWord) -> Duration | None:
    """An hour and a bit."""
    length = _length(quantity, unit)
    return None if length is None else length.hedged("about")


@grammar.rule("duration", "<duration> , <duration>", weight=0.1)
def listed(first: Duration, second: Duration) -> Duration | None:
    """2 years, 3 months; but "for a week, an hour before food" are two lengths."""
    return None if first.indefinite or second.indefinite else sum_of(first, second)


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


@grammar.rule("duration", "<quantity> <unit> or <quantity>", weight=0.2)
def one_or_two(quantity: Quantity, unit: UnitWord, more: Quantity) -> Duration | None:
    """An hour or two."""
    first, last = _length(quantity, unit), _length(more, unit)
    if first is None or last is None or more.indefinite or first.seconds >= last.seconds:
        return None
    return replace(first, until=replace(last, bare_end=True), indefinite=False)


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


@grammar.rule("duration", '<integer> "')
def seconds_mark(number: Integer) -> Duration | None:
    """30"."""
    return Duration(((number.value, Unit.SECOND),)) if number.digits else None


@grammar.rule("duration", "all|full|whole|entire -? <unit>", "the|an|a whole|full|entire <unit>", weight=-0.1)
def whole_of(unit: UnitWord) -> Duration | None:
    """All day, a full week; "all night" is when, not how long."""
    return Duration(((unit.count, unit.unit),)) if unit.form != "night" else None


@grammar.rule(
    "duration",
    "<duration> to|or|- <duration>",
    "<quantity> to|or|- <duration>",
    "<quantity> ,? or? maybe|perhaps|possibly|rather|even <duration>",
    "<duration> ,? or? maybe|perhaps|possibly|even <duration>",
    "between <quantity> and <duration>",
)
def between(shorter: Duration | Quantity, longer: Duration) -> Duration | None:
    """Five to ten minutes, two or three hours, half an hour to an hour."""
    if isinstance(shorter, Quantity):
        if len(longer.terms) != 1 or shorter.indefinite:
            return None
        first = Duration(((shorter.value, longer.terms[0][1]),), shorter.hedges)
    else:
        first = shorter
    if (
        first.until is not None
        or longer.until is not None
        or first.seconds >= longer.seconds
        or first.bare_end
    ):
        return None
    return replace(first, until=longer, ordinal_end=longer.ordinal_end)


@grammar.rule("duration", "<integer> <duration>", weight=0.3)
def one_or_the_next(shorter: Integer, longer: Duration) -> Duration | None:
    """Two three minutes, five-ten minutes: one or five more; but "two thirty minute walks" are two."""
    steps = {1, FIVE, 2 * FIVE} if shorter.value % FIVE == 0 else {1}
    spoken = not shorter.digits and longer.terms[0][0] - shorter.value in steps
    return between(Quantity(shorter.value), longer) if spoken and not longer.hedges else None


@grammar.rule("duration", "<quantity> <unit> ,|or|to <unit> and <fraction>", weight=0.3)
def one_or_one_and_a_half(
    quantity: Quantity, unit: UnitWord, again: UnitWord, part: float
) -> Duration | None:
    """An hour, hour and a half."""
    first, last = _length(quantity, unit), _length(Quantity(1 + part), again)
    if first is None or last is None or unit.unit is not again.unit or quantity.value != 1:
        return None
    return replace(first, until=last, indefinite=False)


@grammar.rule(
    "duration",
    "<duration> ,? and|but <hedge> <quantity>|<duration>",
    "<duration> , <hedge> <quantity>|<duration>",
    weight=0.3,
)
def at_least_and_at_most(shorter: Duration, hedge: str, longer: Quantity | Duration) -> Duration | None:
    """At least two hours and no more than four."""
    bounded = "at least" in shorter.hedges and hedge in {"at most", "less than"}
    if not bounded or len(shorter.terms) != 1 or shorter.until is not None:
        return None
    if isinstance(longer, Quantity):
        longer = Duration(((longer.value, shorter.terms[0][1]),), bare_end=True)
    if longer.hedges or longer.until is not None or shorter.seconds >= longer.seconds:
        return None
    return replace(shorter, hedges=(), until=longer)


@grammar.rule("duration", "<quantity> ,? and|but <duration>", weight=0.4)
def at_least_and_no_more(shorter: Quantity, longer: Duration) -> Duration | None:
    """At least two but no more than six hours."""
    upper = next(iter(longer.hedges), "") if len(longer.hedges) == 1 else ""
    if shorter.hedges != ("at least",) or len(longer.terms) != 1:
        return None
    first = Duration(((shorter.value, longer.terms[0][1]),), shorter.hedges)
    return at_least_and_at_most(first, upper, replace(longer, hedges=()))


@grammar.rule(
    "duration",
    "<duration> ,? give or take <quantity>|<duration>",
    "<duration> ,? plus|+ or|/? minus|- <quantity>|<duration>",
    "<duration> ± <quantity>|<duration>",
    "<quantity> give or take <duration>",
    "<quantity> plus|+ or|/? minus|- <duration>",
    "<quantity> ± <duration>",
    weight=0.4,
)
def give_or_take(middle: Duration | Quantity, width: Quantity | Duration) -> Duration | None:
    """Ten minutes give or take two, ten plus or minus two minutes: between eight and twelve."""
    if isinstance(middle, Quantity):
        if not isinstance(width, Duration) or len(width.terms) != 1:
            return None
        middle = Duration(((middle.value, width.terms[0][1]),), middle.hedges)
    if len(middle.terms) != 1 or middle.until is not None or middle.bare_end:
        return None
    amount, unit = middle.terms[0]
    seconds = width.seconds if isinstance(width, Duration) else width.value * UNIT_SECONDS[unit]
    off = seconds / UNIT_SECONDS[unit]
    if not 0 < off < amount:
        return None
    longer = Duration(((amount + off, unit),), bare_end=isinstance(width, Quantity))
    return Duration(((amount - off, unit),), middle.hedges, until=longer)


@grammar.rule("duration", "a|an good|solid <fraction> <unit>", weight=0.1)
def a_good_part(fraction: float, unit: UnitWord) -> Duration | None:
    """A good half hour: that long, or longer."""
    found = _length(Quantity(fraction), unit)
    return None if found is None or fraction == 1 else found.hedged("at least")


@grammar.rule("duration", "<hedge> the? <duration>", weight=0.05)
def hedged(hedge: str, duration: Duration) -> Duration:
    """Roughly ten minutes, at least an hour."""
    return duration.hedged(hedge)


@grammar.rule("duration", "<duration> -|,? <hedge_after>", weight=0.05)
def hedged_after(duration: Duration, hedge: str) -> Duration:
    """Ten minutes or so, half an hour at most."""
    return replace(duration, hedges=(*duration.hedges, hedge))
