"""A small German grammar of time: what another language's rules look like, and what they need.

Nothing here is taken from the rooms of English: pieces, pattern by pattern, and the values that they mean.
"""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields
from fuzzytime.language.meaning.days.relations import Deictic, Relative, Which
from fuzzytime.language.meaning.expressions import (
    Duration,
    Goal,
    Offset,
    Range,
    Repeat,
    Said,
    Time,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.feasts import Feast
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.range_ends import lent
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import Clock, Half, Part
from fuzzytime.language.meaning.units import Quantity, UnitWord
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

HOURS = 12
HALF_HOUR = 30
QUARTER = 15
"""Minutes."""


# -- lengths --------------------------------------------------------------------------------------------


@grammar.rule("quantity", "<integer>")
def number(value: Integer) -> Quantity:
    """Zehn."""
    return Quantity(value.value)


@grammar.rule("quantity", "ein|eine|einer|einem|einen")
def one() -> Quantity:
    """Eine (Stunde)."""
    return Quantity(1, indefinite=True)


@grammar.rule("quantity", "anderthalb|eineinhalb")
def one_and_a_half() -> Quantity:
    """Anderthalb (Stunden)."""
    return Quantity(1.5)


@grammar.rule("quantity", "eine|einer? <fraction>")
def part_of(fraction: float) -> Quantity:
    """Eine halbe (Stunde)."""
    return Quantity(fraction)


@grammar.rule("duration", "<quantity> <unit>")
def length(quantity: Quantity, unit: UnitWord) -> Duration:
    """Zehn Minuten, eine Viertelstunde, ein paar Tage."""
    return Duration(((quantity.value * unit.count, unit.unit),), quantity.hedges)


@grammar.rule("duration", "<duration> und? <duration>", weight=0.1)
def both(first: Duration, second: Duration) -> Duration | None:
    """Eine Stunde und zehn Minuten."""
    if first.hedges or second.hedges or second.seconds > first.seconds:
        return None
    return Duration((*first.terms, *second.terms))


@grammar.rule("duration", "<hedge> <duration>")
def hedged_length(hedge: str, duration: Duration) -> Duration:
    """Etwa zehn Minuten."""
    return duration.hedged(hedge)


# -- times of day ---------------------------------------------------------------------------------------


@grammar.rule("hour", "<integer>", "ein")
def hour(value: Integer | None = None) -> Clock | None:
    """Sieben, 19; "ein" Uhr."""
    if value is None:
        return Clock(1, bare=True)
    return Clock(value.value % 24, full_day=value.value > HOURS, bare=True) if value.value <= 24 else None


@grammar.rule("clock", "<hour>", weight=-0.4)
def bare_hour(clock: Clock) -> Clock:
    """Sieben."""
    return clock


@grammar.rule("clock", "<hour> uhr", weight=0.1)
def whole_hour(clock: Clock) -> Clock:
    """Sieben Uhr."""
    return replace(clock, bare=False)


@grammar.rule("clock", "<hour> uhr <integer>", weight=0.2)
def hour_and_minute(clock: Clock, minute: Integer) -> Clock | None:
    """Sieben Uhr dreißig."""
    if minute.value >= 60:
        return None
    return replace(clock, minute=minute.value, grain=Unit.MINUTE, bare=False)


@grammar.rule("clock", "<hh:mm>|<hh.mm> uhr?", weight=0.1)
def typed(numbers: Typed) -> Clock | None:
    """19:30, 7.30 Uhr."""
    if numbers[0] > 24 or numbers[1] >= 60:
        return None
    return Clock(numbers[0] % 24, numbers[1], grain=Unit.MINUTE, full_day=numbers[0] > HOURS)


@grammar.rule("half hour", "halb <hour>")
def half_to(clock: Clock) -> Clock:
    """Halb sieben: half an hour before seven."""
    return replace(clock, shift=-HALF_HOUR * 60, grain=Unit.MINUTE, bare=False)


@grammar.rule("clock", "<half hour>")
def half_hour(clock: Clock) -> Clock:
    """Halb sieben."""
    return clock


@grammar.rule("minutes", "<integer> minuten?")
def minutes(value: Integer) -> int | None:
    """Fünf (vor sieben)."""
    return value.value if 0 < value.value < 60 else None


@grammar.rule("minutes", "viertel")
def quarter() -> int:
    """Viertel (nach sieben)."""
    return QUARTER


@grammar.rule("clock", "<minutes> vor <hour>|<half hour>", weight=0.4)
def minutes_to(before: int, clock: Clock) -> Clock:
    """Viertel vor sieben, fünf vor halb sieben."""
    return replace(clock, shift=clock.shift - before * 60, grain=Unit.MINUTE, bare=False)


@grammar.rule("clock", "<minutes> nach <hour>|<half hour>", weight=0.4)
def minutes_past(after: int, clock: Clock) -> Clock:
    """Viertel nach sieben, fünf nach halb sieben."""
    return replace(clock, shift=clock.shift + after * 60, grain=Unit.MINUTE, bare=False)


@grammar.rule("clock", "viertel <hour>", weight=0.2)
def quarter_of(clock: Clock) -> Clock:
    """Viertel sieben: a quarter of the hour that is over at seven."""
    return replace(clock, shift=-3 * QUARTER * 60, grain=Unit.MINUTE, bare=False)


@grammar.rule("clock", "dreiviertel <hour>", weight=0.2)
def three_quarters_of(clock: Clock) -> Clock:
    """Dreiviertel sieben."""
    return replace(clock, shift=-QUARTER * 60, grain=Unit.MINUTE, bare=False)


# -- days -----------------------------------------------------------------------------------------------


@grammar.rule("days", "<day>")
def day(relative: Relative) -> Calendar:
    """Heute, übermorgen."""
    return relative


@grammar.rule("days", "am? <weekday>", weight=0.05)
def weekday(which: int) -> Calendar:
    """Am Freitag."""
    return Fields(weekday=which)


@grammar.rule("days", "am? <deictic> <weekday>", weight=0.1)
def weekday_to_come(which: Which, weekday: int) -> Calendar:
    """Nächsten Montag."""
    return Deictic(which, Fields(weekday=weekday))


@grammar.rule("days", "in? <deictic> <unit>", weight=0.1)
def period(which: Which, unit: UnitWord) -> Calendar | None:
    """Nächste Woche."""
    return None if unit.unit in SUB_DAY else Deictic(which, Cycle(unit.unit, unit.count))


@grammar.rule("days", "am? <ordinal> <month>", "am? <integer> . <month>", weight=0.2)
def date(number_of_day: int | Integer, month: int) -> Calendar | None:
    """Am fünften März, 5. März."""
    found = number_of_day.value if isinstance(number_of_day, Integer) else number_of_day
    return Fields(month=month, day=found) if 1 <= found <= 31 else None


@grammar.rule("days", "am? <d.m.>|<last d.m.>|<n.n>", weight=0.2)
def typed_date(numbers: Typed) -> Calendar | None:
    """Am 5.3."""
    month, found = (
        sorted((numbers[0], numbers[1]))
        if max(numbers[0], numbers[1]) > HOURS
        else (
            numbers[1],
            numbers[0],
        )
    )
    return Fields(month=month, day=found) if 1 <= month <= HOURS and 1 <= found <= 31 else None


@grammar.rule("days", "zu|an? <feast>")
def feast(found: Feast) -> Calendar:
    """Weihnachten."""
    return found


# -- days, parts and clocks beside each other -------------------------------------------------------------


@grammar.rule("wall", "<clock>")
def wall_of_clock(clock: Clock) -> Wall:
    """Sieben Uhr."""
    return Wall(clock=clock)


@grammar.rule("wall", "<days>")
def wall_of_days(days: Calendar) -> Wall:
    """Heute."""
    return Wall(days)


@grammar.rule("wall", "am|zum|beim|der|in? der? <part>", weight=-0.05)
def wall_of_part(part: Part) -> Wall:
    """Am Abend, beim Mittagessen."""
    return Wall(part=part)


@grammar.rule("wall", "heute morgen", weight=0.5)
def this_morning() -> Wall:
    """Heute Morgen: the morning, and not tomorrow."""
    return Wall(Relative(0), Part("früh", 6 * 3600, 10 * 3600, Half.AM))


@grammar.rule("wall", "<wall> um? <wall>", weight=0.1)
def beside(first: Wall, second: Wall) -> Wall | None:
    """Morgen früh um sieben, am Freitag um halb acht."""
    return joined(first, second)


# -- how they bind --------------------------------------------------------------------------------------


@grammar.rule("goal", "<wall>|<word>")
def goal(time: Time) -> Goal:
    """Any time."""
    return Goal(time)


@grammar.rule("goal", "<hedge> <goal>", weight=0.05)
def hedged(hedge: str, goal: Goal) -> Goal:
    """Etwa sieben Uhr."""
    return replace(goal, hedges=(hedge, *goal.hedges))


@grammar.rule("said", "<goal>")
def plain(goal: Goal) -> Said:
    """Morgen."""
    return Said(goal.time, None, None, goal.hedges)


@grammar.rule("said", "<preposition_at> <goal>", weight=0.1)
def at(preposition: Preposition, goal: Goal) -> Said | None:
    """Um sieben, gegen Mittag; but "um bald" is nothing."""
    if isinstance(goal.time, TimeWord):
        return None
    return Said(goal.time, None, preposition.name, goal.hedges)


@grammar.rule("said", "<hedge> <preposition_at> <wall>", weight=0.15)
def about_at(hedge: str, preposition: Preposition, wall: Wall) -> Said:
    """Etwa um sieben."""
    return Said(wall, None, preposition.name, (hedge,))


@grammar.rule("said", "<wall> <preposition_before>|<preposition_after> <goal>", weight=0.5)
def bound_on_day(day: Wall, preposition: Preposition, goal: Goal) -> Said | None:
    """Morgen vor acht, am Freitag ab zehn."""
    whole = joined(day, goal.time) if isinstance(goal.time, Wall) else None
    if whole is None:
        return None
    return Said(whole, preposition.constraint, preposition.name, goal.hedges, preposition.edge)


@grammar.rule("said", "<preposition_before>|<preposition_after> <goal>", weight=0.2)
def bound(preposition: Preposition, goal: Goal) -> Said | None:
    """Bis Mittag, ab zehn, nicht vor morgen."""
    if isinstance(goal.time, TimeWord) and goal.time.constraint is not Constraint.AT:
        return None
    return Said(goal.time, preposition.constraint, preposition.name, goal.hedges, preposition.edge)


@grammar.rule("said", "<beside> <goal>", weight=0.3)
def just_off(hedge: str, goal: Goal) -> Said:
    """Kurz vor Mittag."""
    return Said(goal.time, None, None, (hedge, *goal.hedges), beside=True)


@grammar.rule("said", "in <duration>", weight=0.3)
def from_now(duration: Duration) -> Said:
    """In zehn Minuten."""
    return Said(Offset(replace(duration, hedges=())), None, "in", duration.hedges)


@grammar.rule("said", "vor <duration>", weight=0.3)
def ago(duration: Duration) -> Said:
    """Vor zehn Minuten."""
    return Said(Offset(replace(duration, hedges=()), -1), None, "ago", duration.hedges)


@grammar.rule("said", "<within> <duration>", weight=0.5)
def within(preposition: Preposition, duration: Duration) -> Said:
    """Innerhalb von zehn Minuten."""
    time = Offset(replace(duration, hedges=()))
    return Said(time, Constraint.BEFORE, preposition.name, duration.hedges, preposition.edge)


@grammar.rule("said", "für? <duration> lang", "für <duration>", weight=0.3)
def lasting(duration: Duration) -> Said:
    """Zehn Minuten lang."""
    return Said(duration, Constraint.FOR, None, duration.hedges)


@grammar.rule("said", "<wall>? zwischen <goal> und <goal>", "<wall>? von <goal> bis <goal>", weight=1.1)
def between(day: Wall | None, first: Goal, last: Goal) -> Said | None:
    """Zwischen sechs und sieben, morgen von neun bis Mittag."""
    if not isinstance(first.time, Wall) or not isinstance(last.time, Wall):
        return None
    begin: Wall | None = first.time
    if day is not None:
        begin = joined(day, first.time)
    ends = None if begin is None else lent(begin, last.time)
    return None if ends is None else Said(Range(*ends), Constraint.BETWEEN, "between", first.hedges)


# -- again and again ------------------------------------------------------------------------------------


@grammar.rule("repeat", "jede|jeden|jedes <unit>", "alle <duration>")
def every(said: UnitWord | Duration) -> Repeat:
    """Jede Stunde, alle zwanzig Minuten."""
    if isinstance(said, Duration):
        return Repeat(said)
    length_of_one = Duration(((said.count, said.unit),))
    walls = () if said.unit in SUB_DAY else (Wall(Cycle(said.unit)),)
    return Repeat(length_of_one, walls)


@grammar.rule("repeat", "jeden <weekday>")
def every_weekday(which: int) -> Repeat:
    """Jeden Montag."""
    return Repeat(walls=(Wall(Fields(weekday=which)),))


@grammar.rule("repeat", "jeden <part>")
def every_part(part: Part) -> Repeat:
    """Jeden Abend."""
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part=part),))


@grammar.rule("repeat", "<repeat> um? <wall>", weight=0.2)
def every_at(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Jeden Tag um acht."""
    return narrowed_repeat(repeat, wall)


@grammar.rule("said", "<repeat>", weight=0.5)
def repeated(repeat: Repeat) -> Said:
    """Alle zwei Stunden."""
    return Said(repeat, Constraint.EVERY)
