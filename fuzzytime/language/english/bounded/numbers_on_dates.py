"""Numbers that are clock times, as they stand between a bound and a date: "by six on the 28th"."""

from dataclasses import replace

from fuzzytime.language.english.at_times import goals, prepositions
from fuzzytime.language.english.bounded import bounds
from fuzzytime.language.english.intervals.ranges import range_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import Duration, Goal, Said, Wall
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.times_of_day import Clock

grammar = Grammar()


@grammar.rule("number on date", "<clock> on <day of month>")
def number_on_date(clock: Clock, days: Calendar) -> Goal | None:
    """Six on the 28th: alone it may be so many of anything; "from five to eight on the 12th" is a stretch."""
    if clock.shift or not (clock.bare or clock.pair):
        return None
    time = joined(Wall(clock=replace(clock, bare=False, pair=False)), Wall(days))
    return None if time is None else Goal(time)


@grammar.rule("number on date", "<hedge> <clock> on <day of month>")
def hedged_number_on_date(hedge: str, clock: Clock, days: Calendar) -> Goal | None:
    """About six on the 28th."""
    found = number_on_date(clock, days)
    return None if found is None else replace(found, hedges=(hedge,))


@grammar.rule(
    "said",
    "from <number on date> to|-|until|till|til|through the? <number on date>|<goal>",
    "between <number on date> and the? <number on date>|<goal>",
    weight=1.4,
)
def from_to(first: Goal, last: Goal) -> Said | None:
    """From nine on the second till six on the fourth, between ten on the 5th and noon on the 6th."""
    return range_of(first, last)


@grammar.rule("said", "<preposition_before> <number on date>", weight=0.8)
def deadline(preposition: Preposition, goal: Goal) -> Said | None:
    """By six on the 28th, until about nine on the twenty-first."""
    return None if preposition.name == "within" else bounds.deadline(preposition, goal)


@grammar.rule("said", "<preposition_after> <number on date>", weight=0.8)
def release(preposition: Preposition, goal: Goal) -> Said | None:
    """After six on the 28th, not before about ten on 5/1."""
    return bounds.release(preposition, goal)


@grammar.rule("said", "<preposition_at> <number on date>", weight=0.8)
def beside(preposition: Preposition, goal: Goal) -> Said | None:
    """Around twelve on the 12th; but "for six on the 28th" may be a party of six."""
    near = preposition.name in {"at", "around", "sometime"}
    return prepositions.beside(preposition, goal) if near else None


@grammar.rule("said", "<beside> <number on date>", weight=1.0)
def just_off(hedge: str, goal: Goal) -> Said | None:
    """Shortly before seven on 3/20."""
    return prepositions.just_off(hedge, goal)


@grammar.rule("goal", "<duration> before <number on date>", weight=0.8)
def before(duration: Duration, goal: Goal) -> Goal | None:
    """An hour before four on 3/5."""
    return goals.before_goal(duration, goal)


@grammar.rule("goal", "<duration> after <number on date>", weight=0.8)
def after(duration: Duration, goal: Goal) -> Goal | None:
    """Two hours after six on the 28th."""
    return goals.after_goal(duration, goal)


@grammar.rule("goal", "<hedge> <duration> before <number on date>", weight=1.0)
def at_most_before(hedge: str, duration: Duration, goal: Goal) -> Goal | None:
    """At most an hour before four on 3/5."""
    return goals.at_most_before(hedge, duration, goal)


@grammar.rule("goal", "<hedge> <duration> after <number on date>", weight=1.0)
def at_most_after(hedge: str, duration: Duration, goal: Goal) -> Goal | None:
    """At most two hours after six on the 28th."""
    return goals.at_most_after(hedge, duration, goal)
