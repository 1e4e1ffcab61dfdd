"""What is said with a new time in it: in "by five, no, six" it is bound as before."""

from dataclasses import replace

from fuzzytime.language.grammar.lexicon import longest_match
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.meaning.expressions import Duration, HourMark, Offset, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.beside import in_hour_of
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.language.meaning.units import Quantity
from fuzzytime.requirement import MOMENTS


def replaced(old: Said, new: object) -> Said | None:
    """Give what was said with a new time in it: bound as before, where the new words do not bind anew."""
    if isinstance(new, Said) and isinstance(new.time, HourMark) and isinstance(old.time, Wall):
        # "At five, or rather half past"
        whole = in_hour_of(new.time, old.time)
        new = (
            new if whole is None else replace(new, time=whole, preposition=new.preposition or old.preposition)
        )
    if isinstance(new, Said):
        return _said_anew(old, new)
    if isinstance(new, Wall) and isinstance(old.time, Wall):
        clock = new.clock
        if clock is not None and old.time.clock is not None:
            return replace(
                old,
                time=replace(old.time, clock=_in_half(clock, old.time.clock), part=new.part or old.time.part),
            )
        return replace(old, time=new)
    if isinstance(new, Duration):
        if isinstance(old.time, Repeat) and isinstance(old.time.every, Duration):
            return replace(old, time=replace(old.time, every=new))
        return replace(old, time=new) if isinstance(old.time, Duration) else None
    if isinstance(new, Clock):
        return replaced(old, Wall(clock=new)) if old.wall.clock is not None else None
    if isinstance(new, Quantity) and not new.indefinite:
        return _counted(old, new)
    return None


def _said_anew(old: Said, new: Said) -> Said | None:
    """Give what is said instead: "within ten minutes, no, within twenty", "by five pm, no, six pm"."""
    bare = isinstance(new.time, Duration) or (isinstance(new.time, Wall) and new.time.bare)
    counted = isinstance(old.time, (Duration, Offset)) and isinstance(new.time, Wall) and new.time.clock
    if bare and counted:
        return _counted(old, Quantity(counted.hour))
    if new.preposition is None and bare:
        return replaced(old, new.time)
    if isinstance(new.time, Wall) and new.time == Wall(clock=new.time.clock):
        # "On monday at nine, no, at six"
        placed = replaced(old, new.time)
        new = new if placed is None else replace(new, time=placed.time)
    alike = type(old.time) is type(new.time) and new.constraint in MOMENTS and _is_alike(old, new)
    return replace(old, time=new.time, hedges=new.hedges) if alike and not new.preposition else new


def _is_alike(old: Said, new: Said) -> bool:
    """Whether both are of the clock, a day or a part of it; not "after lunch, actually next week"."""
    first, second = old.wall, new.wall
    if first.clock is not None or second.clock is not None:
        return first.clock is not None and second.clock is not None
    days = first.days is not None and second.days is not None
    return days or (first.part is not None and second.part is not None) or first == second


def near_old(old: Said, new: Said, scanned: Scanned) -> Said:
    """Give a new hour of a named day in the half nearer to the old one: "tomorrow at five, no, six".

    What is done at usual hours is so then: "wake me tomorrow at five, no, six".
    """
    lexicon, words = scanned.lexicon, scanned.words
    first, second = old.wall.clock, new.wall.clock
    if old.wall.days is None or first is None or second is None or not isinstance(new.time, Wall):
        return new
    if old.wall.part is not None or new.time.part is not None:
        return new
    usual = any(longest_match(words, place, lexicon.usual_hours) for place in range(len(words)))
    if usual or not first.is_open or not second.is_open:
        return new
    hour = first.first_from(lexicon.policy.ahead_from)
    halves = (replace(second, half=half) for half in (Half.AM, Half.PM))
    nearest = min(halves, key=lambda clock: abs(clock.candidates()[0] - hour))
    return replace(new, time=replace(new.time, clock=nearest))


def _counted(old: Said, new: Quantity) -> Said | None:
    """Give another number of the same unit."""
    time = old.time.every if isinstance(old.time, Repeat) else old.time
    time = time.duration if isinstance(time, Offset) else time
    if not isinstance(time, Duration) or len(time.terms) != 1:
        return None
    duration = replace(time, terms=((new.value, time.terms[0][1]),), until=None)
    return replaced(old, duration)


def _in_half(clock: Clock, old: Clock) -> Clock:
    return (
        replace(clock, half=old.half, bare=False)
        if clock.is_open and old.half is not None
        else replace(clock, bare=False)
    )
