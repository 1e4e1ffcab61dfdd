"""Where turns lie that two clock times of any day bound: "every hour from eleven at night to three"."""

from dataclasses import replace
from datetime import timedelta

from fuzzytime.language.meaning.expressions import Range, Time, Wall
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.grounded.range_instants import first_after
from fuzzytime.language.meaning.instants import Instants, halved, midnight


def hours_of_turns(first: Time | None, last: Time | None, moment: Moment) -> Instants | None:
    """Give the stretch that is on, or the next one; None where no two clock times of any day bound it.

    It is on if it ends where the last time alone would: "every hour from nine to five", said at noon.

    Raises
    ------
    UngroundedError
        If no clock is known.
    """
    if not isinstance(first, Wall) or not isinstance(last, Wall) or first.clock is None or last.clock is None:
        return None
    if first.days is not None or last.days is not None:
        return None
    zone = first.zone or last.zone
    here = moment.grounding(zone)
    ended = here.instants(last)
    over, ends = ended.start, last.clock if last.part is None else halved(last.clock, last.part.half)
    begins = first.clock if first.part is None else halved(first.clock, first.part.half)
    days = (midnight(over.date()) - timedelta(days=back) for back in (0, 1))
    begun = [day + timedelta(seconds=seconds) for day in days for seconds in begins.candidates()]
    on = [start for start in begun if start <= here.now < over == first_after(start, ends)]
    found = replace(ended, start=max(on), choices=()) if on else here.instants(Range(first, last))
    return replace(found, zone=zone)
