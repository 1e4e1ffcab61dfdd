"""Times of day that depend on the one now: "on the hour", "a quarter past", "this time tomorrow"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import HourMark, Said, SameTime
from fuzzytime.requirement import Constraint

grammar = Grammar()


@grammar.rule(
    "same",
    "this|same time on? <days>|<date>",
    "at? the? same time on? <days>|<date>",
    "<days> at? this|the same? time",
    "<days>|<date> ,? same time",
    weight=0.3,
)
def same_time(days: Calendar) -> SameTime:
    """This time tomorrow."""
    return SameTime(days)


@grammar.rule("same", "the? top|start|beginning|end of the hour", "on the hour", weight=0.2)
def on_the_hour() -> HourMark:
    """On the hour."""
    return HourMark(0)


@grammar.rule("said", "by|before the half hour", weight=0.4)
def by_the_half_hour() -> Said:
    """By the half hour; but what is paid by the hour is so each hour."""
    return Said(HourMark(30), Constraint.BEFORE, "by")


@grammar.rule("same", "the? bottom|middle of the hour", weight=0.2)
@grammar.rule("same", "on|at the half hour", weight=0.3)
def on_the_half_hour() -> HourMark:
    """On the half hour, at the bottom of the hour."""
    return HourMark(30)


@grammar.rule("same", "<minutes of clock>|<bare minutes of clock> past|after the hour", weight=0.4)
def past_the_hour(minutes: float) -> HourMark:
    """(at) a quarter past the hour."""
    return HourMark(int(minutes))


@grammar.rule("same", "<minutes of clock>|<bare minutes of clock> to|before the hour", weight=0.4)
def to_the_hour(minutes: float) -> HourMark:
    """(at) ten to the hour."""
    return HourMark(60 - int(minutes))


@grammar.rule("same", "<minutes of clock>|<bare minutes of clock> past", weight=0.6)
def past_no_hour(minutes: float) -> HourMark:
    """(at) a quarter past: of the hour that was said before, or of the next."""
    return HourMark(int(minutes), open=True)


@grammar.rule("same", "<minutes of clock>|<bare minutes of clock> to", weight=0.1)
def to_no_hour(minutes: float) -> HourMark:
    """(at) ten to: of the hour that was said before, or of the next."""
    return HourMark(60 - int(minutes), open=True)


@grammar.rule("said", "at half", weight=0.1)
def half_of_no_hour() -> Said:
    """(at six, and) at half: past the hour that was said before."""
    return Said(HourMark(30, open=True), None, "at")
