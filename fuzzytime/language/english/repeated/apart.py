"""What is done so many times, at most, so long apart, or each so long: "twice, an hour apart"."""

from dataclasses import replace

from fuzzytime.language.english.repeated.bounded_repetitions import from_first_time, to_last_time
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.expressions import Duration, Offset, Repeat, Said
from fuzzytime.language.meaning.joined.distances import UPPER, said_length
from fuzzytime.language.meaning.joined.first_times import beginning, first_time
from fuzzytime.requirement import Constraint, Unit

SIDES = 2
"""Of what is turned once."""

grammar = Grammar()


@grammar.rule("each", "for? <duration> each time|go?", "each|every one|time? for <duration>")
@grammar.rule("apart", "<duration> apart", "each|every? <duration> apart", "<duration> in between")
def so_long(duration: Duration) -> Duration | None:
    """Two hours apart; five minutes each."""
    return duration if duration.seconds > 0 and duration.until is None else None


@grammar.rule("repeat", "<times> ,|-|( <apart> )?", "<times> <apart>", weight=0.6)
def times_apart(times: int, length: Duration) -> Repeat | None:
    """Twice, an hour apart: the first of them now."""
    return Repeat(length, times=times) if times > 1 else None


@grammar.rule("repeat", "<repeat> ,|-|( <apart> )?", "<repeat> <apart>", weight=0.6)
def so_often_apart(repeat: Repeat, length: Duration) -> Repeat | None:
    """Three times today, two hours apart; twice a day, twelve hours apart."""
    if repeat.shared and repeat.every is not None and repeat.every.seconds == length.seconds:
        return replace(repeat, shared=False)
    if repeat.times is None or repeat.every is not None:
        return None
    return replace(repeat, every=length, until=None)


@grammar.rule("total", "<times> altogether?", "<times> in all|total")
@grammar.rule("total", "<integer> altogether", "<integer> in all|total", "<integer> of them")
def in_all(number: Integer | int) -> int | None:
    """Five times, five in all."""
    times = number.value if isinstance(number, Integer) else number
    return times if 0 < times <= 1000 else None


@grammar.rule("said", "<hedge> <integer> in|within any? <duration>", weight=0.5)
def at_most_so_many(hedge: str, number: Integer, within: Duration) -> Said | None:
    """No more than eight in 24 hours."""
    if hedge not in UPPER or not 0 < number.value <= 1000 or within.seconds <= 0:
        return None
    often = Repeat(Duration(((within.seconds / number.value, Unit.SECOND),)))
    return Said(often, Constraint.EVERY, hedges=(hedge,))


@grammar.rule("repeat", "<repeat> ,|-|( <total> )?", "<repeat> for? <total>", weight=0.6)
def so_often_in_all(repeat: Repeat, times: int) -> Repeat | None:
    """Every five minutes, three times: the first of them in five minutes, or when it is said to begin."""
    if repeat.every is None or repeat != Repeat(repeat.every, starting=repeat.starting):
        return None
    return replace(repeat, times=times, starting=repeat.starting or Offset(repeat.every, 1))


@grammar.rule("repeat", "<said> ,|-|( one|1 <repeat> )?", weight=0.8)
def one_so_often(said: Said, repeat: Repeat) -> Repeat | None:
    """(Weld brackets) at nine, one every ten minutes, five in all."""
    first = first_time(said)
    unsaid = repeat.every is not None and repeat.starting == Offset(repeat.every, 1)
    return beginning(repeat, first) if first is not None and repeat.times and unsaid else None


@grammar.rule("said", "<times> ,|-|( <each> )?", "<times> <each>", weight=0.6)
def times_each(times: int, length: Duration) -> Said | None:
    """Three times, five minutes each: one right after the other."""
    return Said(Repeat(length, times=times), Constraint.EVERY, lasting=length) if times > 1 else None


@grammar.rule("said", "<each>", weight=0.3)
def each_alone(length: Duration) -> Said:
    """(Three walks a day,) twenty minutes each: how long every one takes."""
    return said_length(length, Constraint.FOR, "for")


@grammar.rule(
    "said",
    "for? <duration> each|per|a side",
    "for? <duration> on|for? each|either|both side|sides",
    weight=0.6,
)
def on_both_sides(length: Duration) -> Said | None:
    """(Sear it) two minutes a side: on one, and then on the other."""
    if length.until is not None:
        return None
    terms = tuple((SIDES * amount, unit) for amount, unit in length.terms)
    return each_alone(replace(length, terms=terms))


@grammar.rule("repeat", "<apart>", weight=0.2)
def apart_alone(length: Duration) -> Repeat:
    """(Two tablets) six hours apart: how many, what is done says."""
    return Repeat(length, apart=True)


@grammar.rule(
    "repeat",
    "the? first time|one|dose? <said> , <apart>",
    "the first time|one|dose? <said> <apart>",
    weight=0.6,
)
def first_and_apart(said: Said, length: Duration) -> Repeat | None:
    """(Two tablets,) the first at eight, six hours apart."""
    return from_first_time(apart_alone(length), said)


@grammar.rule(
    "repeat",
    "the? last time|one|dose? <said> , <apart>",
    "the last time|one|dose? <said> <apart>",
    weight=0.6,
)
def last_and_apart(said: Said, length: Duration) -> Repeat | None:
    """(Three alarms,) the last at seven, ten minutes apart."""
    return to_last_time(apart_alone(length), said)
