"""How long it has been: "until ten minutes have passed", "once an hour is up"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.expressions import Duration, Said
from fuzzytime.language.meaning.joined.distances import said_length
from fuzzytime.requirement import Constraint

grammar = Grammar()


@grammar.rule(
    "elapsed",
    "<duration> have|has|had passed|elapsed",
    "<duration> have|has|had gone by|past?",
    "<duration> is|are up|over",
    "<duration> pass|passes|elapse|elapses",
    weight=0.2,
)
def elapsed(duration: Duration) -> Duration | None:
    """Ten minutes have passed."""
    return None if duration.until is not None or duration.bare_end else duration


@grammar.rule("said", "until|till it's|its been <duration>", "until|till it has been <duration>", weight=0.6)
@grammar.rule("said", "until|till <elapsed>", "or until|till <elapsed>", weight=0.4)
def until_elapsed(length: Duration) -> Said:
    """(stir) until ten minutes have passed: so long."""
    return said_length(length, Constraint.FOR, "for")


@grammar.rule("said", "or once|when|after? <elapsed>", weight=0.4)
def or_elapsed(length: Duration) -> Said:
    """(until it browns) or ten minutes have passed: so long; "when it rings or …" is then, at the latest."""
    return until_elapsed(length)


@grammar.rule("said", "once|when|after <elapsed>", "as soon as <elapsed>", weight=0.4)
def once_elapsed(length: Duration) -> Said:
    """(stir) once ten minutes have passed: in ten minutes."""
    return said_length(length, Constraint.AT, "in")


@grammar.rule("said", "before <elapsed>", weight=0.6)
def before_elapsed(length: Duration) -> Said:
    """Before an hour is up: within it."""
    return said_length(length, Constraint.BEFORE, "before")
