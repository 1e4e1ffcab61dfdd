"""What repeats beside a part of each day: "an hour after sunset each evening"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.expressions import Duration, Repeat, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock, Part
from fuzzytime.requirement import Unit

grammar = Grammar()


@grammar.rule("beside part", "<duration> before <part>|<meal>")
def before_part(duration: Duration, part: Part) -> Wall | None:
    """Ten minutes before lunch."""
    return _away(duration, part.start - duration.seconds)


@grammar.rule("beside part", "<duration> after <part>|<meal>")
def after_part(duration: Duration, part: Part) -> Wall | None:
    """An hour after sunset."""
    return _away(duration, part.end + duration.seconds)


def _away(duration: Duration, seconds: float) -> Wall | None:
    """Give a time of day so far from a part of it."""
    if duration.hedges or any(unit not in SUB_DAY for _, unit in duration.terms):
        return None
    moment = int(seconds) % DAY_SECONDS
    hour, rest = divmod(moment, 3600)
    minute, second = divmod(rest, 60)
    return Wall(clock=Clock(hour, minute, second, Unit.MINUTE, full_day=True))


@grammar.rule("repeat", "<beside part> ,? <repeat>", "<repeat> ,? <beside part>", weight=0.6)
def repeated_beside(first: Wall | Repeat, second: Repeat | Wall) -> Repeat | None:
    """An hour after sunset each evening."""
    repeat, wall = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat) or not isinstance(wall, Wall):
        return None
    return narrowed_repeat(repeat, wall)
