"""Working days, which pass over weekends: "in two working days", "within the next three business days"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Weekend
from fuzzytime.language.meaning.days.relations import Deictic, Relative, Which
from fuzzytime.language.meaning.days.workdays import Workday, Workdays
from fuzzytime.language.meaning.expressions import Edge, Range, Said, Wall
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

MOST = 1000
"""Working days that are counted at most."""

TODAY = Relative(0)


@grammar.rule("workdays", "<integer> -? working|business|work|office -? day|days")
def workdays(number: Integer) -> int | None:
    """Two working days."""
    return number.value if 0 < number.value <= MOST else None


@grammar.rule("few workdays", "<integer> -|to|or <integer> -? working|business|work|office -? day|days")
def few_workdays(fewest: Integer, most: Integer) -> tuple[int, int] | None:
    """Two to three working days."""
    return (fewest.value, most.value) if 0 < fewest.value < most.value <= MOST else None


@grammar.rule("workdays", "a|one|next working|business|work day", "the next working|business|work day")
def one_workday() -> int:
    """(in) a working day."""
    return 1


@grammar.rule("series", "working|business|work day")
@grammar.rule("series", "weekday|workday", weight=-0.2)
def workday() -> Calendar:
    """Working day, in "the last working day of the month", "the first weekday of may"."""
    return Workday()


@grammar.rule("days", "<workdays> from now|today|hence", "in <workdays> time?", weight=0.6)
def in_workdays(count: int) -> Calendar:
    """In two working days."""
    return Workdays(count, TODAY)


@grammar.rule("said", "in <few workdays> time?", "<few workdays> from now|today|hence", weight=1.5)
def in_few_workdays(counts: tuple[int, int]) -> Said:
    """In two to three working days: from the first of them to the end of the last."""
    first, last = (Wall(Workdays(count, TODAY)) for count in counts)
    return Said(Range(first, last), Constraint.BETWEEN, "in")


@grammar.rule("said", "<within> the? <deictic>? <few workdays>", weight=1.5)
def within_few_workdays(*said: Preposition | Which | tuple[int, int]) -> Said | None:
    """Within two to three working days: by the end of the last."""
    counts = next(part for part in said if isinstance(part, tuple))
    return within_workdays(*(part for part in said if not isinstance(part, tuple)), counts[1])


@grammar.rule("days", "the? next|following working|business|work day", "a|any weekday|workday", weight=0.6)
def next_workday() -> Calendar:
    """The next working day, any weekday."""
    return Workdays(1, TODAY)


@grammar.rule("days", "a|any weekday|workday <days>", "a|any weekday|workday in|of <days>", weight=0.8)
def weekday_of_week(days: Calendar) -> Calendar | None:
    """Any weekday next week: from its monday to its friday."""
    weekly = isinstance(days, Deictic) and days.of == Cycle(Unit.WEEK)
    return Deictic(days.which, Weekend(working=True)) if weekly and isinstance(days, Deictic) else None


@grammar.rule("days", "<workdays> after|from|following|since <days>|<date>|<day of month>", weight=0.6)
def workdays_after(count: int, anchor: Calendar) -> Calendar:
    """Three working days after easter."""
    return Workdays(count, anchor)


@grammar.rule("days", "<workdays> before <days>|<date>|<day of month>", weight=0.6)
@grammar.rule("days", "<workdays> prior to <days>|<date>|<day of month>", weight=0.6)
def workdays_before(count: int, anchor: Calendar) -> Calendar:
    """Two business days before friday."""
    return Workdays(-count, anchor)


@grammar.rule("said", "<within> the? <deictic>? <workdays>", "in the <deictic> <workdays>", weight=0.7)
def within_workdays(*said: Preposition | Which | int) -> Said | None:
    """Within three working days: by the end of the last."""
    count = next(part for part in said if isinstance(part, int))
    if any(part in {Which.LAST, Which.PAST} for part in said if isinstance(part, Which)):
        return None
    return Said(Wall(Workdays(count, TODAY)), Constraint.BEFORE, "within", (), Edge.LAST)


@grammar.rule("said", "over|during|for? the? <deictic> <workdays>", weight=0.6)
def coming_workdays(which: Which, count: int) -> Said | None:
    """Over the next four business days."""
    if which not in {Which.NEXT, Which.COMING}:
        return None
    return Said(Range(Wall(Relative(1)), Wall(Workdays(count, TODAY))), Constraint.BETWEEN, "during")


@grammar.rule("said", "over|during|for|in? the? <deictic> <workdays>", weight=0.6)
def past_workdays(which: Which, count: int) -> Said | None:
    """The last three working days: up to yesterday."""
    if which not in {Which.LAST, Which.PAST}:
        return None
    return Said(Range(Wall(Workdays(-count, TODAY)), Wall(Relative(-1))), Constraint.BETWEEN, "during")
