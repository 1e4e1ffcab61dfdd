"""Which edges of what is named count: before lunch is before it begins, the end of june its last day."""

from dataclasses import dataclass, replace
from datetime import timedelta

from fuzzytime.language.meaning.expressions import Edge, Ending, Range, Rest, Said, Time, Wall, wall_of
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.instants import Instants
from fuzzytime.language.meaning.joined.distances import is_farther
from fuzzytime.requirement import Constraint, Unit

LAST = frozenset({Edge.LAST, Edge.DUE})
"""Edges that are the last moment of what is named."""


@dataclass(frozen=True, slots=True)
class Edges:
    """What was said, as one stands at a moment, and the zone in which its times are."""

    said: Said
    moment: Moment
    zone: str | None

    def bounds(self, time: Time, found: Instants) -> tuple[float, float]:
        """Give the seconds of the edges that count: of an interval that a bound names, the one it means."""
        start, end = found.start, found.end
        if self.said.beside:
            start = end = end if self.said.edge is Edge.END else start
        elif self.said.constraint is Constraint.BEFORE and start != end:
            if self._counts_from_start(time) and not self.has_begun(time, found):
                end = start
            if self.said.edge in LAST and isinstance(time, Wall) and time.part is None and end != start:
                end -= timedelta(seconds=1)
        elif self.said.constraint is Constraint.AFTER and start != end and self.said.edge is Edge.END:
            start = end
        elif is_farther(self.said):
            start, end = end, start
        if isinstance(time, Ending) and self.said.constraint is Constraint.BEFORE:
            # "By the start of next week"
            begins = time.edge is Edge.START
            end = start if begins else found.end + timedelta(seconds=1) if found.is_point else found.end
        return self.moment.seconds(start, self.zone), self.moment.seconds(end, self.zone)

    def begin_of(self, within: Wall, end: float) -> float:
        """Give the seconds to when that begins in which a deadline lies.

        It is the part of the day, or the week; of a day, or where that part is later, the hours at which
        people do things, or some before the deadline.
        """
        grounding = self.moment.grounding(self.zone)
        day = grounding.instants(replace(within, part=None)).start
        part = self.moment.seconds(grounding.instants(within).start, self.zone)
        period = within.days is not None and within.days.grain is not Unit.DAY
        if (period or within.part is not None) and part < end:
            return part
        opens = self.moment.policy.begin_before(end - self.moment.seconds(day, self.zone))
        return min(end, self.moment.seconds(day + timedelta(seconds=opens), self.zone))

    def has_begun(self, time: Time, found: Instants) -> bool:
        """Whether a deadline is at the start of a stretch that is running: "before dinner", said at dinner.

        Then what is meant is as soon as can be, and in that stretch: nobody asks for the past.
        """
        part = isinstance(time, Wall) and time.part is not None and time.clock is None
        if not part or self.said.constraint is not Constraint.BEFORE or not self._counts_from_start(time):
            return False
        return self.moment.seconds(found.start, self.zone) <= 0 < self.moment.seconds(found.end, self.zone)

    def _counts_from_start(self, time: Time) -> bool:
        if self.said.edge is Edge.END:
            return False
        if self.said.edge is Edge.START:
            return not isinstance(time, (Ending, Range, Rest))
        part = wall_of(time).part
        # A meal is something that begins: "no later than lunch".
        return part is not None and (self.said.edge is Edge.DUE or part.meal)
