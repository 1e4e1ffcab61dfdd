"""Minutes past and to an hour: "a quarter past three", "ten to eleven", "half three", "half past"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.language.meaning.times_of_day import Clock, Part
from fuzzytime.requirement import Unit

grammar = Grammar()

QUARTER = 0.25
HALF_HOUR, HOUR = 30, 60

FIVE_AND_TWENTY = 25

NOON_HOUR = 12
"""Numbers up to it are hours, too."""


def moved(clock: Clock, minutes: float) -> Clock | None:
    """Give a clock time that many minutes after the hour, or the half hour, that is said."""
    if clock.shift or clock.minutes:
        # "Ten minutes before half past five" is a distance from that; "ten to twenty" is none.
        return None
    if clock.grain is Unit.SECOND or clock.minute % 30 or not -60 < minutes < 60 or minutes != int(minutes):
        return None
    return replace(clock, shift=int(minutes * 60), grain=Unit.MINUTE, bare=False, pair=False, minutes=False)


@grammar.rule("minutes of clock", "<integer> minutes|minute|mins|min")
def counted(minutes: Integer) -> float | None:
    """Fifteen minutes."""
    return minutes.value if 0 < minutes.value < 60 else None


@grammar.rule("bare minutes of clock", "<integer>")
def rounded(minutes: Integer) -> float | None:
    """Twenty (past): a number alone must be round."""
    return minutes.value if 0 < minutes.value < 60 and minutes.value % 5 == 0 else None


@grammar.rule("bare minutes of clock", "five and twenty")
def five_and_twenty() -> float:
    """Five and twenty (past), as it was once said, and here and there still is."""
    return FIVE_AND_TWENTY


@grammar.rule("minutes of clock", "a? <fraction>")
def quarter(fraction: float) -> float | None:
    """A quarter, half, three quarters."""
    return fraction * 60 if fraction in {0.25, 0.5, 0.75} else None


@grammar.rule(
    "clock", "<minutes of clock> past <clock>", "<bare minutes of clock> past|after <clock>", weight=0.2
)
def past(minutes: float, clock: Clock) -> Clock | None:
    """A quarter past three, ten minutes past six pm, ten after three."""
    return moved(clock, minutes)


@grammar.rule("clock", "<minutes of clock> after <clock>", weight=0.2)
def after(minutes: float, clock: Clock) -> Clock | None:
    """A quarter after three, ten minutes after six pm."""
    found = moved(clock, minutes)
    return None if found is None else replace(found, apart=True)


@grammar.rule("clock", "<minutes of clock> to|till|of|til <clock>", weight=0.15)
def to(minutes: float, clock: Clock) -> Clock | None:
    """Ten minutes to eleven, a quarter to noon."""
    return moved(clock, -minutes)


@grammar.rule("clock", "a? <fraction> 2 <clock>", weight=0.4)
def typed_to(fraction: float, clock: Clock) -> Clock | None:
    """Quarter 2 nine, as it is typed; no other fraction is said so."""
    return moved(clock, -fraction * HOUR) if fraction == QUARTER else None


@grammar.rule("clock", "<minutes of clock> before <clock>", weight=0.15)
def before(minutes: float, clock: Clock) -> Clock | None:
    """Ten minutes before eleven."""
    found = moved(clock, -minutes)
    return None if found is None else replace(found, apart=True)


@grammar.rule("clock", "<bare minutes of clock> to|till|before|of|til <clock>", weight=0.15)
def bare_to(minutes: float, clock: Clock) -> Clock | None:
    """Ten to eleven; it may be a count of something too."""
    found = moved(clock, -minutes)
    return (
        replace(found, pair=clock.bare, hours=clock.bare and minutes <= NOON_HOUR)
        if found is not None
        else None
    )


@grammar.rule("spoken minutes", "<integer>")
def spoken(minutes: Integer) -> float | None:
    """Ten, twenty: minutes to an hour in words."""
    return rounded(minutes) if not minutes.digits and minutes.value < HALF_HOUR else None


@grammar.rule("said", "<spoken minutes> to|till <wall>", weight=0.8)
def spoken_to_hour_of_day(minutes: float, wall: Wall) -> Said | None:
    """Ten to ten tonight, twenty to eight tomorrow morning; but "five to nine tonight" may be four hours."""
    clock = wall.clock
    if clock is None or (wall.days is None and wall.part is None) or clock.hour > minutes:
        return None
    found = moved(clock, -minutes)
    hours = clock.bare and minutes <= NOON_HOUR
    return None if found is None else Said(replace(wall, clock=replace(found, hours=hours)), None, None)


@grammar.rule(
    "unfinished",
    "for a|another moment|while|bit|jiffy",
    "for a little while|bit",
    "for some time",
    "half past",
    "a? <fraction> past",
    "since then",
    "the eve of the|a|my|our",
    "at the very? end|start|beginning",
    "halfway|midway through",
    "closing|opening|boarding|quitting|departure|arrival time",
    "half way through",
    "<times> per",
    "for? half|twice|just|exactly as long as",
    "for? <times> as long as",
)
def of_no_hour(part: Part | int | None = None) -> bool:
    """For a while, half past: of what, or how long, is not said."""
    return True


@grammar.rule("clock", "half <clock>", weight=0.1)
def half_hour(clock: Clock) -> Clock | None:
    """Half three: half past three."""
    return moved(clock, 30) if clock.grain is Unit.HOUR and not clock.full_day else None
