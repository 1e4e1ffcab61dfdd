"""What is done so many times, so long apart, or each so long: "twice, an hour apart"."""

from dataclasses import replace

from fuzzytime.language.english.repeated.bounded_repetitions import from_first_time, to_last_time
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.expressions import Duration, Offset, Repeat, Said
from fuzzytime.requirement import Constraint

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


@grammar.rule("repeat", "<repeat> <times>", "<repeat> , <times>", "<repeat> for <times>", weight=0.6)
@grammar.rule("repeat", "<repeat> ( <times> )", weight=0.6)
def so_often_in_all(repeat: Repeat, times: int) -> Repeat | None:
    """Every five minutes, three times: the first of them in five minutes."""
    if repeat.every is None or repeat != Repeat(repeat.every):
        return None
    return replace(repeat, times=times, starting=Offset(repeat.every, 1))


@grammar.rule("said", "<times> ,|-|( <each> )?", "<times> <each>", weight=0.6)
def times_each(times: int, length: Duration) -> Said | None:
    """Three times, five minutes each: one right after the other."""
    return Said(Repeat(length, times=times), Constraint.EVERY, lasting=length) if times > 1 else None


@grammar.rule("said", "<each>", weight=0.3)
def each_alone(length: Duration) -> Said:
    """(Three walks a day,) twenty minutes each: how long every one takes."""
    return Said(replace(length, hedges=()), Constraint.FOR, "for", length.hedges)


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
