"""Times counted from what was begun, one or a list of them: "at 20 minutes", "at 0, 6 and 24 hours"."""

from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.english.from_now.counted import in_duration
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.expressions import Duration, Edge, Offset, Said
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.distances import INTO
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()

MINUTES = 60

Marks = tuple[Integer | Duration, ...]


@grammar.rule("said", "at|@ <duration>", weight=-0.5)
@grammar.rule("said", "at the <duration> mark|point", weight=0.5)
def at_mark(duration: Duration) -> Said | None:
    """(check it) at 20 minutes: counted from what was begun; but "at a moment's notice"."""
    return _into(duration) if _is_mark(duration) else None


@grammar.rule("said", "at|@? t + <duration>", "at|@ t = <duration>", weight=0.6)
def from_zero(duration: Duration) -> Said:
    """T+5s, at T=120s: counted from when all of it is begun."""
    return in_duration(duration)


@grammar.rule("said", "at|@? t + <hh:mm>|<hh:mm:ss>", "at|@ t = <hh:mm>|<hh:mm:ss>", weight=0.6)
def from_zero_typed(numbers: Typed) -> Said | None:
    """T+0:30, T+1:02:30: hours and minutes that have gone by, no clock time."""
    hours, minutes, seconds = (*(numbers[at] for at in range(len(numbers.parts))), 0)[:3]
    if minutes >= MINUTES or seconds >= MINUTES:
        return None
    return from_zero(Duration(((hours * MINUTES + minutes + seconds / MINUTES, Unit.MINUTE),)))


@grammar.rule("mark", "<integer>")
def mark(number: Integer) -> Marks:
    """10 (of the unit that follows)."""
    return (number,)


@grammar.rule("mark", "<integer> <unit>", weight=0.1)
def mark_with_unit(number: Integer, unit: UnitWord) -> Marks:
    """10 minutes."""
    return (Duration(((number.value * unit.count, unit.unit),)),)


@grammar.rule("marks", "<mark>")
@grammar.rule("marks", "<marks> ,|and <mark>")
def marks(first: Marks, more: Marks = ()) -> Marks:
    """10, 20 (and 30 minutes)."""
    return (*first, *more)


@grammar.rule("since", "at|@|after", "at|@ t|time =|of?")
def since() -> Edge:
    """At (t = 0, 15 and 30 minutes): since what was begun."""
    return Edge.START


@grammar.rule("said", "<since> <marks> and <duration>", "<since> <marks> , and <duration>", weight=0.4)
def at_marks(_since: Edge, numbers: Marks, last: Duration) -> Said | None:
    """(check it) at 10, 20 and 30 minutes: each counted from what was begun."""
    return _listed([_into(duration) for duration in _in_unit(numbers, last)])


@grammar.rule("said", "in <marks> and <duration>", "in <marks> , and <duration>", weight=0.4)
def in_marks(numbers: Marks, last: Duration) -> Said | None:
    """(call me) in 10, 20 and 30 minutes: each counted from now."""
    return _listed([in_duration(duration) for duration in _in_unit(numbers, last)])


def _into(duration: Duration) -> Said:
    """Give what is so long into what was begun."""
    return Said(Offset(duration), None, INTO)


def _in_unit(numbers: Marks, last: Duration) -> list[Duration]:
    """Give numbers as lengths in the unit of the last; none where they are no growing list."""
    if not _is_mark(last) or len(last.terms) > 1:
        return []
    unit = last.terms[0][1]
    lengths = [
        Duration(((number.value, unit),)) if isinstance(number, Integer) else number for number in numbers
    ]
    lengths.append(last)
    return lengths if all(one.seconds < other.seconds for one, other in pairwise(lengths)) else []


def _is_mark(duration: Duration) -> bool:
    """Whether a length may be how long something has gone on."""
    sure = not (duration.hedges or duration.indefinite or duration.bare_end or duration.until)
    return sure and all(unit in SUB_DAY and amount == int(amount) for amount, unit in duration.terms)


def _listed(times: list[Said]) -> Said | None:
    return replace(times[0], listed=tuple(times[1:])) if times else None
