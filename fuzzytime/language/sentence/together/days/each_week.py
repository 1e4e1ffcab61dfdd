"""Days beside what is done on others: "every monday put the bins out and bring them in on tuesday"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.calendar import Cycle, is_weekday
from fuzzytime.language.meaning.days.relations import Away, Relative, days_onward
from fuzzytime.language.meaning.expressions import Phrase, Repeat, Wall
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.sketches.sketch import Sketch, text_between
from fuzzytime.requirement import MOMENTS, Constraint, Unit


def each_week(sketches: Sequence[Sketch], text: str) -> list[Sketch]:
    """Let a weekday be that of each week, where its sentence says before it that something is done weekly.

    That is said in front of the first order, which holds for all; behind it, it holds for what is done with
    the same thing. "The next day" is behind each day of a repetition, and in the next sentence, too, of what
    is done with the same thing.
    """
    found: list[Sketch] = []
    weekly: Phrase | None = None
    daily: Phrase | None = None
    in_front = False
    for sketch in sketches:
        ended = bool(found) and not ENDS.isdisjoint(text_between(found[-1], sketch, text))
        if ended:
            weekly = None
        told = sketch
        if daily is not None and sketch.asks and (not ended or _is_about_it(sketch)):
            told = _told_onward(sketch, daily)
        elif ended:
            daily = None
        if weekly is not None and sketch.asks and (in_front or _is_about_it(sketch)):
            told = _told_weekly(told, weekly)
        found.append(told)
        repeated = next((phrase for phrase in sketch.phrases if _is_on_days(phrase)), None)
        if sketch.operation is not None and sketch.asks:
            daily = repeated or daily
        own = next((phrase for phrase in sketch.phrases if _is_weekly(phrase)), None)
        if own is not None and sketch.operation is not None and sketch.asks:
            weekly, in_front = own, own.span[1] <= sketch.operation.span[0]
    return found


def _told_weekly(sketch: Sketch, weekly: Phrase) -> Sketch:
    """Give an order with its weekday in each week, which it is on instead of those of the first."""
    told = [_in_each_week(phrase, weekly) for phrase in sketch.phrases]
    if told == list(sketch.phrases):
        return sketch
    return replace(sketch, phrases=tuple(told)).keeping(lambda phrase: phrase.span != weekly.span)


def _told_onward(sketch: Sketch, daily: Phrase) -> Sketch:
    """Give an order on the day behind another in its place behind each day of a repetition."""
    return replace(sketch, phrases=tuple(_behind_each_day(phrase, daily) for phrase in sketch.phrases))


def _behind_each_day(phrase: Phrase, daily: Phrase) -> Phrase:
    """Give "the next day" as the one behind each day of a repetition, from its first on."""
    time, repeat = phrase.said.time, daily.said.time
    onward = days_onward(phrase.said.wall.days)
    if not isinstance(time, Wall) or not isinstance(repeat, Repeat) or not onward or onward < 0:
        return phrase
    starting = repeat.starting
    walls: tuple[Wall, ...]
    if all(wall.days == Cycle(Unit.DAY) for wall in repeat.walls):
        walls = (replace(time, days=Cycle(Unit.DAY)),)
        starting = starting or Wall(Relative(onward))
    else:
        days = dict.fromkeys(wall.days for wall in repeat.walls if wall.days is not None)
        walls = tuple(replace(time, days=Away(onward, Unit.DAY, day)) for day in days)
        starting = starting or (repeat.walls[0] if len(repeat.walls) == 1 else None)
    again = replace(repeat, walls=walls, starting=starting)
    return replace(phrase, said=replace(phrase.said, time=again, constraint=Constraint.EVERY))


def _is_on_days(phrase: Phrase) -> bool:
    """Whether it is a repetition on days, and nothing but days tells how often."""
    time = phrase.said.time
    if not isinstance(time, Repeat) or not time.walls or time.at is not None or time.within is not None:
        return False
    units = {wall.days.grain for wall in time.walls if wall.days is not None}
    return units == {Unit.DAY} and time.times is None and not time.shared


def _is_weekly(phrase: Phrase) -> bool:
    """Whether it is a repetition by weeks: on weekdays, or once in each."""
    time = phrase.said.time
    days = [wall.days for wall in time.walls] if isinstance(time, Repeat) else []
    return bool(days) and (days == [Cycle(Unit.WEEK)] or all(map(is_weekday, days)))


def _in_each_week(phrase: Phrase, weekly: Phrase) -> Phrase:
    """Give a weekday as that of each week, from the first day on that is said of it."""
    said, time = phrase.said, phrase.said.time
    alone = is_weekday(said.wall.days) and said.constraint in MOMENTS
    if not isinstance(time, Wall) or not alone or said.denied or not isinstance(weekly.said.time, Repeat):
        return phrase
    (days, *further), skip = weekly.said.time.walls, weekly.said.time.skip
    # Of every other monday, the tuesday behind it: not that before the first.
    first = None if further or not is_weekday(days.days) else Wall(days.days)
    repeat = Repeat(walls=(time,), skip=1 if further else skip, starting=first)
    return replace(phrase, said=replace(said, time=repeat, constraint=Constraint.EVERY))


def _is_about_it(sketch: Sketch) -> bool:
    """Whether something is done with what was said before."""
    operation = sketch.operation
    thing = "" if operation is None else (operation.object or "").lower()
    return thing in sketch.lexicon.closed.all_anaphors
