"""From when to when a part of the day is: "tonight", "in the morning"."""

from dataclasses import replace
from datetime import date, datetime, time, timedelta

from fuzzytime.language.meaning.instants import Instants, midnight
from fuzzytime.language.meaning.times_of_day import FIRST_THING, NOON, WHOLE_DAY, Part
from fuzzytime.requirement import Unit

EARLY = time(4)
"""From here on, who speaks is up early, not late."""


def part_on(day: date, part: Part, waking: time | None = None) -> Instants:
    """Give a part of a day; the first part of a whole one begins when people are ``waking``."""
    start, end = (midnight(day) + timedelta(seconds=seconds) for seconds in (part.start, part.end))
    first = None if waking is None else datetime.combine(day, waking)
    if first is not None and part.name == WHOLE_DAY and not part.start and first < end:
        # "First thing tomorrow"; but "order pizza first thing tomorrow"
        start = first
    return Instants(start, end, Unit.HOUR)


def part_within(part: Part, first: datetime, last: datetime) -> Instants | None:
    """Give the part of the day that some hours have a share of: the night of a night shift."""
    found = (part_on(day, part) for day in (first.date(), last.date()))
    return next((one for one in found if one.start < last and first < one.end), None)


def part_alone(part: Part, now: datetime, since: datetime | None, waking: time, *, follows: bool) -> Instants:
    """Give the part of the day that is not over yet: "tonight, then in the morning".

    ``since`` is the time that was said before, and ``follows`` whether this comes after it. The first thing
    of a day that has begun is sooner, where people are ``waking`` before that.
    """
    begun = now
    if since is not None and since > now:
        # "Leave it overnight, and in the morning bake it"
        night_before = part.end <= NOON and since <= part_on(since.date(), part).end
        next_day = since.date() > now.date() and night_before
        begun = since if follows or next_day else now
    here = part_on(begun.date(), part)
    # "First thing in the morning", said in the morning, is tomorrow.
    over = here.start if part.name == FIRST_THING else here.end
    if part.name == FIRST_THING and begun == now < over and now.time() >= EARLY:
        # Said at half past six by who is up then
        return replace(here, start=min(over, max(now, datetime.combine(now.date(), waking))))
    return here if over > begun else part_on(begun.date() + timedelta(days=1), part)
