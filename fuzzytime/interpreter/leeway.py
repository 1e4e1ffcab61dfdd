"""How early or late something may start before others satisfy less: its leeway around where it is planned."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from fuzzytime.interpreter.interpreter import Interpreter
from fuzzytime.interpreter.planner import Plan, plan
from fuzzytime.interpreter.request import Request, Started
from fuzzytime.language import content_words
from fuzzytime.satisfaction import EVERYWHERE
from fuzzytime.scheduling import THRESHOLD, Limits, Solver

LOSS = 0.01
"""A satisfaction that falls by less is as before."""

MINUTE = 60.0
"""To how many seconds a limit is looked for, and the clock times at which it lies."""


@dataclass(frozen=True, slots=True)
class Limit:
    """The last start on one side at which nobody loses, in seconds: infinite where there is none.

    ``losing`` has the identifiers of those that would lose beyond it, or whose time that is; none where only
    its own words end it, or a busy time.
    """

    start: float
    losing: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Leeway:
    """Tries other starts of a skill of a plan; all else may make room, as long as it satisfies as before.

    Parameters
    ----------
    made, position
        The plan, and the skill: it has a time.
    request
        What was planned.
    interpreter, solver, threshold, limits
        As in `plan`.
    """

    made: Plan
    position: int
    request: Request
    interpreter: Interpreter
    solver: Solver | None = None
    threshold: float = THRESHOLD
    limits: Limits = field(default_factory=Limits)

    @property
    def start(self) -> float:
        """When the skill is planned to start."""
        return self.made.schedule.start_times[self.position]

    def latest(self) -> Limit:
        """Give how late it may start; what it was to start at counts for nothing, and its deadline does.

        Infinite where nothing that is planned waits for it.
        """
        skill, taken = self.made.skills[self.position].skill, list(self._taken())
        own = (skill.satisfaction.best if skill.preferred is None else EVERYWHERE).high
        if math.isfinite(own):
            # "Before four" is as late as that leaves room, whatever stands before.
            ahead = (begin - skill.duration for _, begin, _ in taken)
            return self._last_of(sorted([own, *(time for time in ahead if self.start < time < own)])[::-1])
        behind = max((end for _, _, end in taken), default=self.start) + skill.duration
        tried = sorted(begin for _, begin, _ in taken if self.start < begin)
        return self._limit([*tried, behind], math.inf)

    def earliest(self) -> Limit:
        """Give how early it may start: now at the earliest, or where its own words begin."""
        skill, taken = self.made.skills[self.position].skill, list(self._taken())
        own = max(0.0, skill.satisfaction.best.low if skill.preferred is None else 0.0)
        tried = sorted((begin for _, begin, _ in taken if own < begin < self.start), reverse=True)
        return self._limit([*tried, min(own, self.start)], min(own, self.start))

    def _last_of(self, tried: Iterable[float]) -> Limit:
        """Give the first of some starts at which nobody loses, with those that lose at the one before it."""
        losing: tuple[str, ...] = ()
        for time in tried:
            found = self._losing(time)
            if found is None:
                return Limit(time, losing)
            losing = found
        return Limit(self.start, losing)

    def _taken(self) -> Iterable[tuple[str, float, float]]:
        """Give from when to when time is taken, and by which of the others, if by any."""
        schedule = self.made.schedule
        for place, (one, planned) in enumerate(zip(self.made.skills, schedule.skills, strict=True)):
            # What happens keeps nobody's hands, and yet who speaks.
            end = planned.done if one.stated else planned.end
            if place != self.position and not schedule.rejected[place] and planned.start < end:
                yield one.identifier, planned.start, end
        yield from (("", busy.start, busy.end) for busy in self.made.request.busy)

    def _limit(self, tried: Iterable[float], over: float) -> Limit:
        """Go through starts on one side until somebody loses; ``over`` is the limit where nobody does."""
        kept = self.start
        for time in tried:
            losing = self._losing(time)
            if losing is not None:
                return self._between(kept, time, losing)
            kept = time
        return Limit(over)

    def _between(self, kept: float, lost: float, losing: tuple[str, ...]) -> Limit:
        """Narrow down where somebody begins to lose, to a minute of the clock."""
        now = self.request.now
        past = MINUTE * now.minute + now.second + now.microsecond / 1e6
        while abs(lost - kept) > MINUTE:
            middle = MINUTE * round(((kept + lost) / 2 + past) / MINUTE) - past
            if not min(kept, lost) < middle < max(kept, lost):
                break
            found = self._losing(middle)
            if found is None:
                kept = middle
            else:
                lost, losing = middle, found
        return Limit(kept, losing)

    def _losing(self, start: float) -> tuple[str, ...] | None:
        """Give those that lose where the skill starts then, or have that time; None where nobody does."""
        mine = self.made.skills[self.position]
        end, done = start + mine.keeps_hands, mine.skill.done_at(start)
        meeting = [
            name
            for name, begin, over in self._taken()
            if begin < end and start < over and not self._makes_room(name)
        ]
        if meeting:
            return tuple(filter(None, meeting))
        began = Started(identifier=mine.identifier, start=start, end=start + mine.skill.duration, done=done)
        then = plan(
            replace(self.request, started=(*self.request.started, began)),
            self.interpreter,
            solver=self.solver,
            threshold=self.threshold,
            limits=self.limits,
            previous=self.made,
        )
        new = {one.identifier: place for place, one in enumerate(then.skills)}
        lost = [
            one.identifier
            for place, one in enumerate(self.made.skills)
            if one.identifier in new and self._loses(place, then, new[one.identifier], done)
        ]
        return tuple(lost) or None

    def _loses(self, place: int, then: Plan, new: int, done: float) -> bool:
        """Whether one of the plan satisfies less in another, or is done with what is not done by then."""
        now = self.made.schedule
        if then.schedule.satisfactions[new] < now.satisfactions[place] - LOSS:
            return True
        # The beef is served at seven, and so roasted by then.
        mine, other = (self.made.skills[n].operation for n in (self.position, place))
        thing = content_words(None if mine is None else mine.object)
        same = bool(thing) and other is not None and content_words(other.object) == thing
        waits = same and now.start_times[place] >= now.skills[self.position].done
        return waits and then.schedule.start_times[new] < done

    def _makes_room(self, name: str) -> bool:
        """Whether a schedule may move what has that time: work that others ask for."""
        found = next((one for one in self.made.skills if one.identifier == name), None)
        return found is not None and not found.stated
