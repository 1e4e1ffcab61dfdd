"""Hedges between commas: "in, say, ten minutes", "by, let's say, noon", "an hour, roughly, ago"."""

from dataclasses import replace

from fuzzytime.language.english.at_times.goals import (
    after_goal,
    before_goal,
    hedged_days_after,
    hedged_days_before,
)
from fuzzytime.language.english.at_times.prepositions import beside
from fuzzytime.language.english.bounded.bounds import deadline, release
from fuzzytime.language.english.from_now.counted import after_duration, from_now, in_duration
from fuzzytime.language.english.from_now.counted import ago as ago_duration
from fuzzytime.language.english.from_now.counted import within as within_duration
from fuzzytime.language.english.from_now.how_long import for_duration
from fuzzytime.language.english.intervals.ranges import between
from fuzzytime.language.english.repeated.bounded_repetitions import roughly_repeated
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import Duration, Goal, Repeat, Said

grammar = Grammar()


@grammar.rule("hedge aside", ", <hedge> ,")
def hedge_aside(hedge: str) -> str:
    """What stands between the commas of "at, say, six"."""
    return hedge


@grammar.rule("said", "in <hedge aside> <duration>", weight=0.6)
def in_about(hedge: str, duration: Duration) -> Said:
    """In, say, ten minutes."""
    return in_duration(duration.hedged(hedge))


@grammar.rule("said", "for <hedge aside> <duration>", weight=0.6)
def for_about(hedge: str, duration: Duration) -> Said:
    """For, let's say, ten minutes."""
    return for_duration(duration.hedged(hedge))


@grammar.rule("said", "after <hedge aside> <duration>", weight=0.6)
def after_about(hedge: str, duration: Duration) -> Said | None:
    """After, say, ten minutes."""
    return after_duration(duration.hedged(hedge))


@grammar.rule("said", "<within> <hedge aside> <duration>", weight=0.6)
def within_about(preposition: Preposition, hedge: str, duration: Duration) -> Said:
    """Within, say, an hour."""
    return within_duration(preposition, duration.hedged(hedge))


@grammar.rule("said", "<preposition_at> <hedge aside> the? <goal>", weight=0.4)
def at_about(preposition: Preposition, hedge: str, goal: Goal) -> Said | None:
    """At, say, six."""
    return beside(preposition, replace(goal, hedges=(hedge, *goal.hedges)))


@grammar.rule("said", "<preposition_before> <hedge aside> the? <goal>", weight=0.4)
def by_about(preposition: Preposition, hedge: str, goal: Goal) -> Said | None:
    """By, let's say, noon."""
    return deadline(preposition, replace(goal, hedges=(hedge, *goal.hedges)))


@grammar.rule("said", "<preposition_after> <hedge aside> the? <goal>", weight=0.4)
def from_about(preposition: Preposition, hedge: str, goal: Goal) -> Said | None:
    """From, say, nine."""
    return release(preposition, replace(goal, hedges=(hedge, *goal.hedges)))


@grammar.rule("said", "between <hedge aside> the? <goal> and|to|- the? <goal>", weight=1.2)
def between_about(hedge: str, first: Goal, last: Goal) -> Said | None:
    """Between, say, three and four."""
    return between(replace(first, hedges=(hedge, *first.hedges)), last)


@grammar.rule("said", "between the? <goal> and <hedge aside> the? <goal>", weight=1.2)
def between_and_about(first: Goal, hedge: str, last: Goal) -> Said | None:
    """Between three and, say, four."""
    return between(first, replace(last, hedges=(hedge, *last.hedges)))


@grammar.rule("said", "<duration> <hedge aside> <forward>", weight=0.4)
def about_from_now(duration: Duration, hedge: str, preposition: Preposition) -> Said:
    """Ten minutes, roughly, from now."""
    return from_now(duration.hedged(hedge), preposition)


@grammar.rule("said", "<duration> <hedge aside> <back>", weight=0.4)
def about_ago(duration: Duration, hedge: str, preposition: Preposition) -> Said:
    """An hour, give or take, ago."""
    return ago_duration(duration.hedged(hedge), preposition)


@grammar.rule("goal", "<duration> <hedge aside> before <goal>", weight=0.4)
def about_before(duration: Duration, hedge: str, goal: Goal) -> Goal | None:
    """Ten minutes, more or less, before noon."""
    return before_goal(duration.hedged(hedge), goal)


@grammar.rule("goal", "<duration> <hedge aside> after|past|from <goal>", weight=0.4)
def about_after(duration: Duration, hedge: str, goal: Goal) -> Goal | None:
    """Two hours, roughly, after lunch."""
    return after_goal(duration.hedged(hedge), goal)


@grammar.rule("goal", "<duration> <hedge aside> before <days>|<date>", weight=0.6)
def about_days_before(duration: Duration, hedge: str, days: Calendar) -> Goal | None:
    """A week, give or take, before easter."""
    return hedged_days_before(duration.hedged(hedge), days)


@grammar.rule("goal", "<duration> <hedge aside> after|from <days>|<date>", weight=0.6)
def about_days_after(duration: Duration, hedge: str, days: Calendar) -> Goal | None:
    """Ten days, roughly, from tomorrow."""
    return hedged_days_after(duration.hedged(hedge), days)


@grammar.rule(
    "said", "<repeat> ,? <hedge> <preposition_at> <goal>", "<repeat> <hedge aside> <preposition_at> <goal>"
)
def repeated_ideally(repeat: Repeat, hedge: str, preposition: Preposition, goal: Goal) -> Said | None:
    """Every friday, ideally at five."""
    return roughly_repeated(preposition, replace(goal, hedges=(hedge, *goal.hedges)), repeat)
