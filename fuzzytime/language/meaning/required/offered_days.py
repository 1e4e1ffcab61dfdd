"""Parts of the days of a longer period: "one evening this week" is any of those to come."""

from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.instants import midnight
from fuzzytime.requirement import Constraint

MOST = 7
"""Days of which each is one that is meant; of a longer period nobody goes through them."""


def on_each_day_offered(said: Said, moment: Moment) -> tuple[Said, ...]:
    """Give a part of the days of a period on each of those to come, as times of which one is enough.

    Anything else is given as it is, and so is what has no day to come.
    """
    time = said.time
    if not isinstance(time, Wall) or time.days is None or time.part is None or time.clock is not None:
        return (said,)
    if moment.now is None or said.constraint not in {None, Constraint.BETWEEN}:
        return (said,)
    here = moment.grounding(time.zone)
    period = next(here.days(time.days))
    count = (period.end - period.first).days
    days = [period.first + timedelta(days=place) for place in range(min(count, MOST + 1))]
    ends = ((day, midnight(day) + timedelta(seconds=time.part.end)) for day in days)
    ahead = [(day - here.now.date()).days for day, end in ends if end > here.now]
    if not ahead or not 1 < count <= MOST:
        return (said,)
    each = (replace(time, days=Relative(away)) for away in ahead)
    offered = tuple(replace(said, time=one, alternative=place > 0) for place, one in enumerate(each))
    return (replace(offered[0], alternative=said.alternative), *offered[1:])
