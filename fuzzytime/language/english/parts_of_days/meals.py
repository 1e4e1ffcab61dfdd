"""Meals by which it is said when: "with breakfast", "before breakfast, lunch and dinner"."""

from dataclasses import replace

from fuzzytime.language.english.at_times.goals import after_goal, before_goal
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Duration, Edge, Goal, Said, Wall
from fuzzytime.language.meaning.times_of_day import Clock, Half, Part
from fuzzytime.requirement import Constraint

grammar = Grammar()

Meals = tuple[Part, ...]


@grammar.rule("said", "with|alongside <meal>", "with the|my|our|your|his|her|their <meal>", weight=0.2)
def with_meal(meal: Part) -> Said | None:
    """With breakfast: then, and no part of it."""
    return None if meal.place else Said(Wall(part=meal), None, "at")


@grammar.rule("wall", "for|at|over <meal> <day_part>", weight=0.45)
def meal_tonight(meal: Part, found: tuple[Relative, Part]) -> Wall | None:
    """For dinner tonight: when that is, on this day."""
    days, part = found
    late = {Half.PM, Half.EVENING, Half.NIGHT}
    return Wall(days, meal) if not meal.place and {meal.half, part.half} <= late else None


@grammar.rule("goal", "<duration> after|following the? <meal> on? <days>|<date>", weight=0.5)
def after_meal_on_day(duration: Duration, meal: Part, days: Calendar) -> Goal | None:
    """Two hours after lunch tomorrow."""
    return None if meal.place else after_goal(duration, Goal(Wall(days, meal)))


@grammar.rule("goal", "<duration> before the? <meal> on? <days>|<date>", weight=0.5)
def before_meal_on_day(duration: Duration, meal: Part, days: Calendar) -> Goal | None:
    """An hour before dinner on friday."""
    return None if meal.place else before_goal(duration, Goal(Wall(days, meal)))


@grammar.rule("goal", "<duration> before the? <meal> at|@ <clock>", weight=1.4)
def so_long_before_meal_at(duration: Duration, meal: Part, clock: Clock) -> Goal | None:
    """An hour before dinner at seven, ten minutes before school at nine."""
    return before_goal(duration, Goal(Wall(part=meal, clock=clock)))


@grammar.rule("goal", "<duration> after|following the? <meal> at|@ <clock>", weight=1.4)
def so_long_after_meal_at(duration: Duration, meal: Part, clock: Clock) -> Goal | None:
    """Two hours after lunch at one."""
    return None if meal.place else after_goal(duration, Goal(Wall(part=meal, clock=clock)))


@grammar.rule("several meals", "<meal> ,|and <meal>")
@grammar.rule("several meals", "<several meals> ,|and <meal>", "<several meals> , and <meal>")
def several_meals(first: Part | Meals, last: Part) -> Meals | None:
    """Breakfast, lunch and dinner; but "school and work" are places."""
    meals = (first, last) if isinstance(first, Part) else (*first, last)
    apart = len({meal.name for meal in meals}) == len(meals)
    return meals if apart and not any(meal.place for meal in meals) else None


@grammar.rule("said", "with|alongside|at|during|over <several meals>", weight=0.6)
def at_meals(meals: Meals) -> Said:
    """With breakfast and dinner: at each of them."""
    return _at_each(meals, Said(Wall(), None, "at"))


@grammar.rule("said", "<preposition_before>|<preposition_after> <several meals>", weight=0.6)
def beside_meals(preposition: Preposition, meals: Meals) -> Said | None:
    """Before breakfast, lunch and dinner: before each of them."""
    if preposition.name not in {"before", "after"}:
        return None
    return _at_each(meals, Said(Wall(), preposition.constraint, preposition.name, edge=preposition.edge))


@grammar.rule("said", "<preposition_before>|<preposition_after> the? <meal> at|@ <clock>", weight=1.2)
def beside_meal_at(preposition: Preposition, meal: Part, clock: Clock) -> Said | None:
    """Before lunch at one, until tea at five, after dinner at seven: when it is."""
    before = preposition.constraint is Constraint.BEFORE
    # "After lunch at three", "before school at seven" says when to do it.
    then = any(meal.start <= seconds < meal.end + before for seconds in clock.candidates())
    is_then = then or (before and not meal.place)
    time = Wall(part=meal, clock=clock)
    return Said(time, preposition.constraint, preposition.name, edge=preposition.edge) if is_then else None


@grammar.rule(
    "said",
    "after|once|when <meal> is|'s over|done|finished",
    "as soon as <meal> is|'s over|done|finished",
    weight=0.8,
)
def after_meal(meal: Part) -> Said | None:
    """After dinner is over."""
    return None if meal.place else Said(Wall(part=meal), Constraint.AFTER, "after", edge=Edge.END)


def _at_each(meals: Meals, said: Said) -> Said:
    """Give what is said of a time for each of several meals."""
    first, *further = (replace(said, time=Wall(part=meal)) for meal in meals)
    return replace(first, listed=tuple(further))
