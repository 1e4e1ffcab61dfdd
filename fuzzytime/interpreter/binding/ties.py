"""One wish at a distance from another: the lags that bind them, and ψ that follows the other's."""

import math
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.context import Context
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.joining import both, either
from fuzzytime.requirement import Anchor, Constraint, Edge, Reference, TimeRequirement
from fuzzytime.rulebook import Rulebook
from fuzzytime.satisfaction import Either, Interval, SatisfactionFunction
from fuzzytime.skills import Precedence
from fuzzytime.times import seconds_between

JUST_BEFORE = "just before"
LATER = "later"
FAR = 86400.0
"""A time far enough from now for words beside it to have all their width."""


@dataclass(frozen=True, slots=True)
class Tie:
    """One skill bound to another by a requirement.

    With x the start of this skill minus the moment it is measured from, the words allow an interval of x.
    Where ``one_agent`` does everything, nothing that keeps the hands is done while they are kept.
    """

    target: Interpreted
    this: Interpreted
    requirement: TimeRequirement
    anchor: Anchor
    rulebook: Rulebook
    one_agent: bool = False

    @property
    def moment(self) -> float:
        """Seconds from the start of the target to the moment that is measured from."""
        skill = self.target.skill
        if self.anchor.share is not None:
            return self.anchor.share * skill.time_until_done
        if self._counts_from_start():
            return 0.0
        return {Edge.START: 0.0, Edge.FREE: skill.duration, Edge.END: skill.time_until_done}[self.anchor.edge]

    def _counts_from_start(self) -> bool:
        """Whether "half an hour later" counts from a time that was said, not from an end that nobody said.

        "Call mum at nine and dad half an hour later": at half past, as far as the call is over by then.
        """
        later = self.anchor.edge is Edge.END and self.requirement.preposition == LATER
        said = any(part.constraint is Constraint.AT and not part.anchor for part in self.target.requirements)
        over = self.anchor.lag >= self.target.skill.time_until_done
        return later and self.anchor.exact and said and over and self.target.duration.assumed

    @property
    def beside(self) -> SatisfactionFunction | None:
        """ψ beside the moment measured from: of this one's end right before it, or its start right after.

        None elsewhere. What is to be ready when something begins may be ready at that very moment.
        """
        if not self.anchor.exact or self.anchor.lag:
            return None
        if self.requirement.constraint is Constraint.AFTER and self.requirement.fuzziness:
            return self._reworded(at=FAR, preposition=None).shifted(-FAR)
        if self.requirement.constraint is not Constraint.BEFORE:
            return None
        if self.requirement.fuzziness:
            # A hedge on a distance is as wide as that is long, one beside a moment as wide as ever.
            far = FAR if self.requirement.reference is Reference.START else self.this.skill.time_until_done
            return self._reworded(at=far, preposition=None).shifted(-far)
        if self.requirement.reference is not Reference.FINISH:
            return None
        early = self._reworded(at=FAR, preposition=None, hedge=JUST_BEFORE)
        return early.shifted(-early.best.high)

    @property
    def lag(self) -> float:
        """Seconds from the moment that is measured from to the start that is wished for."""
        before = self.requirement.constraint is Constraint.BEFORE
        ends = self.requirement.reference is Reference.FINISH or (before and self.beside is not None)
        return self.anchor.lag - (self.this.skill.time_until_done if ends else 0.0)

    def allowed(self) -> Interval:
        """Give the interval of x."""
        if self.anchor.exact:
            leeway = self._leeway()
            low = self.lag + leeway.low
            if self.requirement.constraint is Constraint.AFTER and self.lag > 0:
                # Nothing is two minutes into what has not begun.
                low = max(low, 0.0)
            return Interval(low, self.lag + leeway.high)
        match self.requirement.constraint:
            case Constraint.BEFORE:
                return Interval(-math.inf, self.anchor.lag - self.this.skill.time_until_done)
            case Constraint.AFTER:
                return Interval(self.anchor.lag, math.inf)
            case Constraint.BETWEEN:  # within so long of it
                return Interval(0.0, self.anchor.lag)
            case _:  # while the other goes on
                over = max(0.0, self.target.skill.time_until_done - self.moment)
                return Interval(0.0, math.inf if self._is_behind else over)

    @property
    def _is_behind(self) -> bool:
        """Whether what is to go on meanwhile has to wait: "fry the onions, meanwhile peel the beans"."""
        target, open_ended = self.target, {Constraint.BEFORE, Constraint.AFTER, Constraint.BETWEEN}
        during = not self.anchor.exact and self.requirement.constraint not in open_ended
        kept = target.keeps_hands >= target.skill.time_until_done > 0 and not target.stated
        return during and self.one_agent and kept and self.this.skill.duration > 0

    def _leeway(self) -> Interval:
        """Give how far from the lag is acceptable: as far as "in" that time from now would be."""
        if (beside := self.beside) is not None:
            after = self.requirement.constraint is Constraint.AFTER
            return beside.support.intersection(Interval(0.0, math.inf)) if after else beside.support
        distance = abs(self.anchor.lag)
        inside = self._reworded(at=distance, preposition="in").acceptable()
        return Interval(min(0.0, inside.low - distance), max(0.0, inside.high - distance))

    def _reworded(self, *, at: float, preposition: str | None, hedge: str = "") -> SatisfactionFunction:
        """Give ψ of the same words, or of a hedge instead, for a time so many seconds from now."""
        said = replace(
            self.requirement,
            constraint=Constraint.AT,
            preposition=preposition,
            fuzziness=(hedge,) if hedge else self.requirement.fuzziness,
            reference=Reference.START,
            t_spec=at,
            earliest=at,
            latest=at,
            anchor=None,
        )
        return self.rulebook.resolve(said, Context.empty).satisfaction

    def precedence(self, target: int, this: int) -> Precedence:
        """Give the interval of x as lags from the one that comes first being done to the other's start."""
        x, wished = self.allowed(), self._wished()
        ahead = self.anchor.lag < 0 and self.anchor.edge is Edge.START
        comes_first = self.requirement.constraint is Constraint.BEFORE or ahead
        if comes_first:
            offset = self.moment + self.this.skill.time_until_done
            wished = None if wished is None else -wished - offset
            return Precedence(this, target, -x.high - offset, -x.low - offset, wished)
        offset = self.moment - self.target.skill.time_until_done
        wished = None if wished is None else wished + offset
        return Precedence(target, this, x.low + offset, x.high + offset, wished)

    def _wished(self) -> float | None:
        """Give the x that is wished for, None where only its sign is.

        What is done beside each of several ("before every feed") is done near that one.
        """
        if self._is_behind:
            return max(0.0, self.target.skill.time_until_done - self.moment)
        if not self.anchor.exact:
            x = self.allowed()
            ends = {Constraint.BEFORE: x.high, Constraint.AFTER: x.low}
            return ends.get(self.requirement.constraint) if self.anchor.each else None
        beside, x = self.beside, self.allowed()
        off = 0.0 if beside is None else min(0.0, beside.best.high) + max(0.0, beside.best.low)
        return min(max(x.low, self.lag + off), x.high)

    def follower(self, now: datetime) -> Interpreted:
        """Give this skill with what an exact distance says of its own time: its ψ, and the start named."""
        if not self.anchor.exact:
            return self._from_there(now)
        skill = replace(self.this.skill, satisfaction=self._satisfaction(), preferred=self._preferred())
        return replace(self.this, skill=skill)

    @property
    def expected(self) -> float:
        """Where the target is named, or could be at the earliest; infinite where it cannot be."""
        target = self.target.skill
        return target.preferred if target.preferred is not None else max(0.0, target.satisfaction.best.low)

    def _from_there(self, now: datetime) -> Interpreted:
        """Let "soon" and "at once" behind another count from when that is done: "then serve it soon"."""
        own = [part for part in self.this.requirements if part.anchor is None]
        given = seconds_between(now, self.this.wish.given)
        expected = self.target.skill.named or (self.expected,)
        later = [time + self.moment - given for time in expected]
        follows = self.requirement.constraint is Constraint.AFTER and all(0 < by < math.inf for by in later)
        if not (follows and own and all(map(_counts_from_now, own))):
            return self.this
        skill = self.this.skill
        moved = replace(skill, satisfaction=either([skill.satisfaction.shifted(by) for by in later]))
        named = [time + by for by in later for time in skill.named]
        return replace(self.this, skill=moved.starting_near(*named))

    def _preferred(self) -> float | None:
        """Give the start that was named, or that at the very distance from where the target's was."""
        target, named, wished = self.target.skill.named, self.this.skill.preferred, self._wished()
        if named is not None or wished is None or len(target) != 1:
            # Behind one of several times its place is known when that is chosen.
            return named
        return target[0] + self.moment + wished

    def _satisfaction(self) -> SatisfactionFunction:
        """Let ψ follow the target's, where that is timed."""
        if all(requirement.anchor is not None for requirement in self.target.requirements):
            return self.this.skill.satisfaction
        leeway = self.allowed()
        before = self.requirement.constraint is Constraint.BEFORE
        if before and (beside := self.beside) is not None and (named := self.target.skill.named):
            moved = either([beside.shifted(time + self.moment + self.lag) for time in named])
            return both(self.this.skill.satisfaction, moved)
        follows = self.target.skill.satisfaction.shifted(self.moment + self.lag)
        own = self.this.skill.satisfaction
        alone = len([r for r in self.this.requirements if r.anchor is None]) == 0
        wide = _wider(follows, leeway.length)
        return wide if alone else both(own, wide)


def _wider(function: SatisfactionFunction, leeway: float) -> SatisfactionFunction:
    """Give ψ with some seconds more between its ends; each of alternatives about its own time."""
    if isinstance(function, Either):
        return Either([_wider(one, leeway) for one in function.functions])
    length = function.support.length
    if function.best.empty or not math.isfinite(length):
        return function
    return function.widened(1 + leeway / max(length, 1.0), function.best.low)


def _counts_from_now(part: TimeRequirement) -> bool:
    """Whether words name no time but that of who speaks: "soon", "right away"."""
    return part.word is not None and not part.t_spec and part.constraint in {Constraint.AT, Constraint.VAGUE}
