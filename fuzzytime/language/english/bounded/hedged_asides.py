"""Hedges between commas: "in, say, ten minutes", "by, let's say, noon", "an hour, roughly, ago"."""

from dataclasses import replace

from fuzzytime.language.english.amounts import durations
from fuzzytime.language.english.at_times import goals
from fuzzytime.language.english.at_times.prepositions import beside
from fuzzytime.language.english.bounded.bounds import deadline, release
from fuzzytime.language.english.from_now import counted, how_long
from fuzzytime.language.english.intervals.ranges import between
from fuzzytime.language.english.repeated.bounded_repetitions import roughly_repeated
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.expressions import Duration, Goal, Repeat, Said

grammar = Grammar()


@grammar.rule("goal aside", ", <hedge> , the? <goal>")
def goal_aside(hedge: str, goal: Goal) -> Goal:
    """(at), say, six."""
    return replace(goal, hedges=(hedge, *goal.hedges))


@grammar.rule("duration and aside", "<duration> , <hedge> ,")
def duration_and_aside(duration: Duration, hedge: str) -> Duration:
    """Ten minutes, roughly, (from now)."""
    return duration.hedged(hedge)


# They hedge and bind as they do without commas.
grammar.rule("duration aside", ", <hedge> , <duration>")(durations.hedged)
grammar.rule("said", "in <duration aside>", weight=0.6)(counted.in_duration)
grammar.rule("said", "for <duration aside>", weight=0.6)(how_long.for_duration)
grammar.rule("said", "after <duration aside>", weight=0.6)(counted.after_duration)
grammar.rule("said", "<within> <duration aside>", weight=0.6)(counted.within)
grammar.rule("said", "<preposition_at> <goal aside>", weight=0.4)(beside)
grammar.rule("said", "<preposition_before> <goal aside>", weight=0.4)(deadline)
grammar.rule("said", "<preposition_after> <goal aside>", weight=0.4)(release)
grammar.rule(
    "said", "between <goal aside> and|to|- the? <goal>", "between the? <goal> and <goal aside>", weight=1.2
)(between)
grammar.rule("said", "<duration and aside> <forward>", weight=0.4)(counted.from_now)
grammar.rule("said", "<duration and aside> <back>", weight=0.4)(counted.ago)
grammar.rule("goal", "<duration and aside> before <goal>", weight=0.4)(goals.before_goal)
grammar.rule("goal", "<duration and aside> after|past|from <goal>", weight=0.4)(goals.after_goal)
grammar.rule("goal", "<duration and aside> before <days>|<date>", weight=0.6)(goals.hedged_days_before)
grammar.rule("goal", "<duration and aside> after|from <days>|<date>", weight=0.6)(goals.hedged_days_after)


@grammar.rule(
    "said", "<repeat> ,? <hedge> <preposition_at> <goal>", "<repeat> , <hedge> , <preposition_at> <goal>"
)
def repeated_ideally(repeat: Repeat, hedge: str, preposition: Preposition, goal: Goal) -> Said | None:
    """Every friday, ideally at five."""
    return roughly_repeated(preposition, replace(goal, hedges=(hedge, *goal.hedges)), repeat)
