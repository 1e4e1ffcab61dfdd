"""Lengths of time between two: "five to ten minutes", "an hour or two", "ten minutes give or take two"."""

from dataclasses import replace

from fuzzytime.language.english.amounts.durations import length_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.units import UNIT_SECONDS, Quantity, UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()

FARTHEST = 10
"""How many times as long the longer of two may be, where only the shorter has its unit."""

FIVE = 5
"""What larger numbers of minutes are counted in."""


@grammar.rule("duration", "<quantity> <unit> or <quantity>", weight=0.2)
def one_or_two(quantity: Quantity, unit: UnitWord, more: Quantity) -> Duration | None:
    """An hour or two; but "six months or 5,000 (km)" are two measures."""
    first, last = length_of(quantity, unit), length_of(more, unit)
    if first is None or last is None or more.indefinite or not 1 < last.seconds / first.seconds < FARTHEST:
        return None
    return replace(first, until=replace(last, bare_end=True), indefinite=False)


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
        # "8.30 - 20 mins": nobody counts so, and the first is an hour.
        odd = longer.terms[0][1] is Unit.MINUTE and 2 * shorter.value % 1
        if len(longer.terms) != 1 or shorter.indefinite or odd:
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
    first, last = length_of(quantity, unit), length_of(Quantity(1 + part), again)
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


@grammar.rule("duration", "<duration> ,|or <quantity>|<duration>", weight=0.6)
def so_long_or_longer(usual: Duration, longest: Quantity | Duration) -> Duration | None:
    """Ten minutes, fifteen at most."""
    if longest.hedges != ("at most",) or usual.hedges:
        return None
    return at_least_and_at_most(usual.hedged("at least"), "at most", replace(longest, hedges=()))


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
