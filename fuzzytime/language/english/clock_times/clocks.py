"""Times of day: "six", "half past three", "8:30 pm", "15h30", "1730", "noon"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.expressions import Duration, Wall
from fuzzytime.language.meaning.times_of_day import DAY_HOURS, NOON, Clock, Half, Part
from fuzzytime.language.meaning.units import Quantity
from fuzzytime.requirement import Unit

grammar = Grammar()

FULL_DIGITS = 4
"""Digits of hour and minute together: "1830"."""

QUARTERS = frozenset({15, 30, 45})
"""Minutes of an hour that is surely one."""

NOON_HOUR = NOON // 3600

EARLIEST_MILITARY = 100
"""From here on, a number is an hour with its minutes: "100 hours" is one o'clock."""

EARLIEST_HUNDREDS = 10
"""From here on, so many hundred hours are no length of time."""

TO_AN_HOUR = frozenset({15, 20})
"""Hours of the afternoon that, in words, may as well be minutes: "twenty to seven"."""

AS_MINUTES = frozenset({5, 10})
"""Hours that, in words, may as well be minutes to the one behind them: "tomorrow ten to six"."""


@grammar.rule("clock", "<integer>", weight=-0.4)
def number(hour: Integer) -> Clock | None:
    """Six, 20, 0730, 1730, one hundred and thirty."""
    value, digits = hour.value, hour.digits
    if len(digits) == 4 or (100 <= value < 2400 and len(digits) in {0, 3}):
        if value // 100 > 24 or value % 100 >= 60:
            return None
        full_day = digits.startswith("0") or value >= 1300
        return Clock(value // 100, value % 100, 0, Unit.MINUTE, full_day=full_day, bare=True)
    if value > 24 or len(digits) > 2 or (not value and digits != "00"):
        # "From 0 to 100"
        return None
    minutes = value in TO_AN_HOUR and not digits
    full_day, hours = value > 12 or digits.startswith("0"), value in AS_MINUTES and not digits
    return Clock(value % 24, full_day=full_day, bare=True, minutes=minutes, hours=hours)


@grammar.rule("clock behind at", "<integer> hours|hrs")
@grammar.rule(
    "clock",
    "<integer> o'clock|oclock",
    "<integer> o ' clock",
    "<integer> o clock",
)
def oclock(hour: Integer) -> Clock | None:
    """Six o'clock; (at) five hours."""
    return Clock(hour.value % 24, full_day=hour.value > 12) if hour.value <= 24 else None


@grammar.rule("clock", "<integer> hundred hours|hrs")
def hundreds(hour: Integer) -> Clock | None:
    """Nine hundred hours, fourteen hundred hours: of the whole day."""
    return Clock(hour.value % 24, full_day=True) if hour.value <= 24 else None


@grammar.rule("unfinished", "<integer> o'clock|oclock", "<integer> <meridiem>")
def no_such_hour(hour: Integer, half: Half | None = None) -> bool | None:
    """25 o'clock, 27 pm: no day has such an hour."""
    return True if hour.value > 24 else None


@grammar.rule("clock", "o|oh|zero <integer> hundred hours?", weight=0.1)
def early_hundred(hour: Integer) -> Clock | None:
    """Oh six hundred hours."""
    return Clock(hour.value, full_day=True) if 0 < hour.value < 10 else None


@grammar.rule("clock", "<integer> hours|hrs")
def military(hour: Integer) -> Clock | None:
    """1730 hours; "two hours" is a length."""
    found = number(hour)
    if found is None or (hour.value < EARLIEST_MILITARY and len(hour.digits) < FULL_DIGITS):
        return None
    return replace(found, bare=False, full_day=True)


@grammar.rule("clock", "<integer> <integer> hours|hrs", weight=0.4)
def spaced_military(hour: Integer, minute: Integer) -> Clock | None:
    """17 30 hours, eighteen thirty hours; but "in 2 10 hours" is none."""
    typed = len(hour.digits) == len(minute.digits) == 2
    # "Fifteen, twenty hours" is a length.
    spoken = not (hour.digits or minute.digits) and hour.value > NOON_HOUR and minute.value in QUARTERS
    if not (typed or spoken) or hour.value > 24 or minute.value >= 60:
        return None
    return Clock(hour.value % 24, minute.value, 0, Unit.MINUTE, full_day=True)


@grammar.rule("clock behind at", "<hh.mm> hours|hrs")
@grammar.rule("four digits with hours", "<hh:mm> hours|hrs")
@grammar.rule("clock", "<hh:mm>", "<hh:mm> o'clock|oclock|hours|h|hrs")
@grammar.rule("clock behind at", "<hh.mm> h")
def typed(numbers: Typed) -> Clock | None:
    """8:30, 08:30; (at) 18.30 hrs; (not before) 20:00 hours: no length is typed so."""
    hour, minute = numbers[0], numbers[1]
    if hour > 24 or minute >= 60:
        return None
    full_day = hour > NOON_HOUR or numbers.parts[0].startswith("0")
    return Clock(hour % 24, minute, 0, Unit.MINUTE, full_day=full_day, ends_day=hour == DAY_HOURS)


@grammar.rule("clock", "<hh.mm> hours|hrs", weight=0.4)
def dotted_with_hours(numbers: Typed) -> Clock | None:
    """18.00 hrs, 08.30 hours: of the whole day; "1.50 hours", and "10.50 hours", are lengths."""
    whole = typed(numbers) if 2 * len(numbers.parts[0]) == FULL_DIGITS else None
    return whole if whole is not None and whole.full_day else None


@grammar.rule("clock", "<hh:mm:ss>", weight=0.1)
def typed_to_the_second(numbers: Typed) -> Clock | None:
    """8:30:15."""
    whole, second = typed(Typed(numbers.parts[:2])), numbers[2]
    return None if whole is None or second >= 60 else replace(whole, second=second, grain=Unit.SECOND)


@grammar.rule("clock", "<clock> and <integer> seconds", weight=0.6)
def with_seconds(clock: Clock, seconds: Integer) -> Clock | None:
    """Six twenty-two and thirty seconds."""
    if clock.grain is not Unit.MINUTE or clock.bare or clock.shift or not 0 < seconds.value < 60:
        return None
    return replace(clock, second=seconds.value, grain=Unit.SECOND, pair=False)


@grammar.rule("four digits with hours", "<integer> hours|hrs")
def four_digits_with_hours(hour: Integer) -> Clock | None:
    """(not before) 1330 hours: a length of time is hardly as long."""
    return military(hour) if len(hour.digits) == FULL_DIGITS else None


@grammar.rule("four digits with hours", "<integer> hundred hours|hrs")
def hundreds_with_hours(hour: Integer) -> Clock | None:
    """(before) twenty hundred hours: "two thousand hours" is a length."""
    return hundreds(hour) if hour.value >= EARLIEST_HUNDREDS else None


# Behind "at", and only there, these are clock times.


@grammar.rule("clock", "<hh.mm>", weight=-0.3)
def dotted(numbers: Typed) -> Clock | None:
    """2.30, behind a preposition."""
    found = typed(numbers)
    return found if found is None else replace(found, pair=True)


@grammar.rule("clock", "<integer> <integer>", weight=-0.15)
def pair(hour: Integer, minute: Integer) -> Clock | None:
    """Ten thirty, 3 15, 5 thirty; but "one 30", as in "one 30 minute walk", may count."""
    if hour.value > 24 or len(hour.digits) > 2 or (not hour.digits and minute.digits and hour.value < 2):
        return None
    if hour.value == 20 and minute.value < 10:
        # "Twenty-five"
        return None
    if not 10 <= minute.value < 60 and not (not minute.digits and minute.value == 5):
        return None
    return Clock(hour.value % 24, minute.value, 0, Unit.MINUTE, full_day=hour.value > 12, pair=True)


@grammar.rule("clock", "<integer> o|oh|ou|zero|nought <integer>")
def pair_with_zero(hour: Integer, minute: Integer) -> Clock | None:
    """Twelve oh three."""
    if not 0 < hour.value <= 24 or not 0 < minute.value < 10 or hour.digits:
        return None
    return Clock(hour.value % 24, minute.value, 0, Unit.MINUTE, full_day=hour.value > 12)


@grammar.rule("clock", "o|oh|zero <integer> <integer>", "o|oh|zero <integer> o|oh|zero <integer>", weight=0.1)
def early_pair(hour: Integer, minute: Integer) -> Clock | None:
    """Oh seven thirty, oh six oh five."""
    if not 0 < hour.value < 10 or not 0 < minute.value < 60:
        return None
    return Clock(hour.value, minute.value, 0, Unit.MINUTE, full_day=True)


@grammar.rule("clock", "<integer> o'clock? <integer> minutes", weight=-0.4)
def with_minutes(hour: Integer, minute: Integer) -> Clock | None:
    """Six forty-three minutes, seven o'clock five minutes; but "course 2 twenty minutes later"."""
    said = number(hour) if bool(hour.digits) == bool(minute.digits) else None
    if said is None or said.grain is not Unit.HOUR or not 0 < minute.value < 60:
        return None
    return replace(said, minute=minute.value, grain=Unit.MINUTE, bare=False)


@grammar.rule(
    "clock", "<clock> in? the? <meridiem>", "<clock> .|: <meridiem>", "<hh.mm> <meridiem>", weight=0.2
)
def with_half(clock: Clock | Typed, half: Half) -> Clock | None:
    """3 pm, 3:30 p.m., 3 in the AM, 8.30pm, 330 p.m."""
    found = typed(clock) if isinstance(clock, Typed) else clock
    if found is None or found.half is not None or (found.hour > 12 and half is Half.AM):
        return None
    if found.pair and found.hour > NOON_HOUR >= found.minute:
        # "Saturday march 14 12 pm" is at noon.
        return None
    return replace(found, half=half, bare=False, pair=False, full_day=found.full_day and found.hour > 12)


# -- words for clock times ------------------------------------------------------------------------------


@grammar.rule("moment part", "<part>")
def moment(part: Part) -> Part | None:
    """Noon, midnight, mid-morning."""
    return part if part.is_point else None


@grammar.rule("clock", "the? <moment part>", weight=0.1)
def named(part: Part) -> Clock:
    """Noon, midnight."""
    grain = Unit.HOUR if part.start % 3600 == 0 else Unit.MINUTE
    hour, minute = part.start // 3600, part.start // 60 % 60
    return Clock(hour, minute, 0, grain, full_day=True, midnight=not part.start)


@grammar.rule("clock", "<integer> o'clock? <moment part>", weight=0.3)
def named_twice(hour: Integer, part: Part) -> Clock | None:
    """Twelve noon, 12 midnight, 1 o'clock midnight."""
    if hour.value > 12 or (part.start == NOON and hour.value != NOON_HOUR):
        # "Give him pills at eight noon and six": three times.
        return None
    return Clock(hour.value % 12 or 12, half=part.half, midnight=not part.start and hour.value == 12)


@grammar.rule("clock", "<hh:mm> <moment part>", weight=0.3)
def typed_twice(numbers: Typed, part: Part) -> Clock | None:
    """12:00 noon, 12:00 midnight."""
    return named(part) if (numbers[0], numbers[1]) == (12, 0) and part.start % NOON == 0 else None


@grammar.rule("wall", "<clock>")
def wall(clock: Clock) -> Wall:
    """A clock time alone."""
    return Wall(clock=clock)


def minutes_of(quantity: Quantity) -> Duration:
    """Give a number without a unit, as in "in fifteen", as minutes."""
    return Duration(((quantity.value, Unit.MINUTE),), quantity.hedges, bare_end=True)
