"""The first and the last thing of a day: "first thing tomorrow", "last thing on friday"."""

from collections.abc import Callable
from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, FIRST_THING, Half, Part
from fuzzytime.requirement import Unit

grammar = Grammar()


def _first_of(part: Part) -> Part:
    """Give the first of a part of the day: of one that has not begun."""
    return replace(part.share(0.0, 0.5), name=FIRST_THING)


def _last_of(part: Part) -> Part:
    """Give the last of a day: from a part of it on."""
    return replace(part, end=DAY_SECONDS, late=None)


@grammar.rule("wall", "<first thing>", weight=0.1)
def first_thing(morning: Part) -> Wall:
    """First thing, without a day: of the next that begins."""
    return Wall(part=_first_of(morning))


@grammar.rule("wall", "<last thing>", weight=0.1)
def last_thing(evening: Part) -> Wall:
    """Last thing, without a day: this evening."""
    return Wall(Relative(0), _last_of(evening))


@grammar.rule(
    "wall",
    "<last thing> ,? <days>|<date>",
    "<last thing> <weak date>",
    "<days>|<date>|<weak date> ,? <last thing>",
    weight=0.6,
)
def last_thing_on(first: Part | Calendar, second: Calendar | Part) -> Wall | None:
    """Last thing on friday."""
    return _on_a_day(first, second, _last_of)


@grammar.rule("wall", "<first thing> in? the? <part>", "in? the? <part> <first thing>", weight=0.3)
def first_thing_in(first: Part, second: Part) -> Wall | None:
    """First thing in the morning: of the next morning that begins."""
    morning = first if first.half is second.half is Half.AM else None
    return None if morning is None or second.is_point else Wall(part=_first_of(second))


@grammar.rule("wall", "<wall> <first thing>", weight=0.6)
def first_in_part(wall: Wall, _thing: Part) -> Wall | None:
    """Monday morning first thing."""
    return _share_of(wall, 0, 0.5)


@grammar.rule("wall", "<wall> <last thing>", weight=0.6)
def last_in_part(wall: Wall, _thing: Part) -> Wall | None:
    """Friday night last thing."""
    return _share_of(wall, 0.5, 1)


def _on_a_day(first: Part | Calendar, second: Calendar | Part, share: Callable[[Part], Part]) -> Wall | None:
    """Give a share of a part of a day that is said before it or behind it; None for a week or a month."""
    part, days = (first, second) if isinstance(first, Part) else (second, first)
    if not isinstance(part, Part) or isinstance(days, Part) or days.grain is not Unit.DAY:
        return None
    return Wall(days, share(part))


def _share_of(wall: Wall, low: float, high: float) -> Wall | None:
    if wall.part is None or wall.clock is not None or wall.days is None:
        return None
    return replace(wall, part=wall.part.share(low, high))
