"""Times that take what they lack from what was said before: "… turning it after 30", "ten minutes after"."""

from dataclasses import replace

from fuzzytime.language.english.from_now.counted import so_far_in
from fuzzytime.language.english.from_now.how_long import for_another
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.expressions import Duration, Repeat, Said, TimeWord
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.distances import EARLIER, HALFWAY, LAST, LEFT, far_off, said_offset
from fuzzytime.language.meaning.times_of_day import DAY_HOURS
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

LONGEST_TYPED = 6
"""Hours that "in 1:30" may be from now, at most."""


@grammar.rule("said", "in|at? <hh:mm> from now", weight=0.6)
@grammar.rule("said", "in <hh:mm>", weight=0.3)
def in_hours_and_minutes(numbers: Typed) -> Said | None:
    """In 1:30, 1:30 from now: in an hour and a half."""
    hours, minutes = numbers[0], numbers[1]
    if hours > LONGEST_TYPED or minutes >= 60 or not hours + minutes:
        return None
    return Said(Duration(((hours, Unit.HOUR), (minutes, Unit.MINUTE))), Constraint.AT, "in")


def _minutes(number: Integer) -> Duration:
    """Give so many minutes, which may be of another unit that was said before."""
    return Duration(((number.value, Unit.MINUTE),), bare_end=True, unsaid=True)


@grammar.rule("said", "every|each <integer>", weight=0.1)
def every_number(number: Integer) -> Said | None:
    """(bake for forty minutes, turning) every 10: of the unit that was said before."""
    return Said(Repeat(_minutes(number))) if number.value > 0 else None


@grammar.rule("said", "after <integer>", weight=-0.5)
def after_number(number: Integer) -> Said | None:
    """(bake for forty minutes, turning it) after 30, which is no hour: of the unit that was said before."""
    return Said(_minutes(number), Constraint.AFTER, "after") if number.value > DAY_HOURS else None


@grammar.rule("said", "for <integer>", weight=-0.5)
def for_number(number: Integer) -> Said | None:
    """(simmer) for 40, which is no hour: so many minutes, or of the unit that was said before."""
    return for_more(number) if number.value > DAY_HOURS else None


@grammar.rule("said", "<integer>", weight=-0.9)
def number_left(number: Integer) -> Said | None:
    """(let it rest) 40, which is no hour: so many minutes."""
    return Said(_minutes(number), Constraint.FOR) if number.value > DAY_HOURS else None


@grammar.rule("said", "for <integer> more|longer", "for another <integer>", weight=-0.4)
def for_more(number: Integer) -> Said | None:
    """(blend) for 10 more: of the unit that was said before."""
    return Said(_minutes(number), Constraint.FOR, "for")


@grammar.rule("said", "halfway|midway", "halfway|midway through", "half way through?")
def halfway() -> Said:
    """(bake for forty minutes, turning) halfway: of what was said to last."""
    return Said(TimeWord(HALFWAY, Constraint.FOR))


@grammar.rule(
    "said",
    "when|once there is|are <duration> left|remaining",
    "when|once there is|are <duration> to go",
    "when|once there's|theres <duration> left|remaining",
    "when|once there's|theres <duration> to go",
    "with|has|have|got <duration> left|remaining",
    "with|has|have|got <duration> to go",
    weight=0.3,
)
def left_of_it(duration: Duration) -> Said:
    """(add the peas) when there are ten minutes left: of what goes on; (when it) has ten minutes left."""
    return said_offset(duration, LEFT, -1)


@grammar.rule("last of it", "the? last|final <duration>")
def last_of_it(duration: Duration) -> Duration | None:
    """The last ten minutes (of what goes on)."""
    return duration if all(unit in SUB_DAY for _, unit in duration.terms) else None


@grammar.rule("last of it", "the? last|final <unit>")
def last_one_of_it(unit: UnitWord) -> Duration | None:
    """The last hour (of what goes on)."""
    return last_of_it(Duration(((unit.count, unit.unit),))) if len(unit.form) > 1 else None


@grammar.rule("said", "during|in <last of it>", weight=0.5)
def in_the_last_of_it(duration: Duration) -> Said:
    """In the last hour: once so much of it is left."""
    return replace(left_of_it(duration), preposition=LAST)


@grammar.rule("said", "for|throughout <last of it>", weight=0.5)
def for_the_last_of_it(duration: Duration) -> Said:
    """For the last ten minutes: from then on, and that long."""
    return replace(in_the_last_of_it(duration), lasting=replace(duration, hedges=()))


@grammar.rule("said", "<duration> after", weight=0.05)
def after_it(duration: Duration) -> Said | None:
    """(call me) ten minutes after: counted from what was said before; but "the day after"."""
    return so_far_in(duration)


@grammar.rule("said", "<duration> before|early", weight=0.05)
def before_it(duration: Duration) -> Said | None:
    """(be there) ten minutes before: counted from what was said before; but "the night before"."""
    return said_offset(duration, "earlier", -1)


@grammar.rule("so far off", "<hedge>? <duration> before|early|earlier|beforehand")
def so_long_before(hedge: str | None, duration: Duration) -> Said:
    """(before you go,) at least ten minutes before: counted from what was just named."""
    told = said_offset(duration, EARLIER, -1)
    return replace(told, hedges=(*((hedge,) if hedge else ()), *told.hedges))


@grammar.rule("so far off", "<hedge>? <duration> after|later|afterwards|afterward")
def so_long_after(hedge: str | None, duration: Duration) -> Said:
    """(after lunch,) at least an hour after."""
    told = so_far_in(duration)
    return replace(told, hedges=(*((hedge,) if hedge else ()), *told.hedges))


@grammar.rule(
    "bounded so far off",
    "at? the? very? latest ,? <so far off>",
    "<so far off> at? the? very? latest",
    "<preposition_before> <so far off>",
    weight=0.7,
)
def so_far_off_at_the_latest(first: Preposition | Said, second: Said | None = None) -> Said | None:
    """(before you go,) at the latest ten minutes before, no later than an hour before."""
    return _bounded(Constraint.BEFORE, first, second)


@grammar.rule(
    "bounded so far off",
    "at? the? very? earliest ,? <so far off>",
    "<so far off> at? the? very? earliest",
    "<preposition_after> <so far off>",
    weight=0.7,
)
def so_far_off_at_the_earliest(first: Preposition | Said, second: Said | None = None) -> Said | None:
    """(after the match,) at the earliest an hour after, no earlier than an hour after."""
    return _bounded(Constraint.AFTER, first, second)


def _bounded(side: Constraint, first: Preposition | Said, second: Said | None) -> Said | None:
    told = first if isinstance(first, Said) else second
    sure = isinstance(first, Said) or first.name in {"no later than", "not before"}
    return replace(told, constraint=side) if told is not None and sure else None


@grammar.rule("bounded so far off", "<so far off>", weight=0.5)
def hedged_so_far_off(told: Said) -> Said | None:
    """(before they come,) at least an hour before."""
    return told if told.hedges else None


@grammar.rule("said", "<bounded so far off>")
def so_far_off_alone(told: Said) -> Said:
    """(before they come,) no later than an hour before."""
    return told


@grammar.rule("said", "<said> ,|-|( <bounded so far off> )?", weight=0.3)
def and_so_far_off(named: Said, distance: Said) -> Said | None:
    """Before noon, at the latest ten minutes before."""
    return far_off(named, distance)


@grammar.rule("said", "after", weight=-0.5)
def after_all_that() -> Said:
    """(fluff it) after: when that is done which was said before."""
    return Said(TimeWord("afterwards", Constraint.VAGUE))


@grammar.rule("said", "before", weight=-0.5)
def before_all_that() -> Said:
    """(wash it) before: ahead of that which was said before."""
    return Said(TimeWord("beforehand", Constraint.VAGUE))


@grammar.rule("said", "by|before|until|till then", weight=0.3)
def before_then() -> Said:
    """By then: before that which was said before."""
    return Said(TimeWord("beforehand", Constraint.VAGUE), None, "before")


@grammar.rule("said", "from then on|onwards|onward", weight=0.6)
def from_then_on() -> Said:
    """From then on: after that which was said before."""
    return Said(TimeWord("afterwards", Constraint.VAGUE), None, "after")


@grammar.rule("said", "another <integer>", "<integer> more", weight=0.1)
def another_alone(number: Integer) -> Said:
    """(Bake it for twenty minutes, then) another ten: minutes, too."""
    return for_another(number)
