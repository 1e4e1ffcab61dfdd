"""What wishes say of each other: "after setting the table", "five minutes before you serve the soup".

A reference becomes a precedence with lags. Where the wish for a distance is exact and the other skill has a
time of its own, ψ of this one follows it, so that both are wished for at matching times.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime

from fuzzytime.context import Context
from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter.circles import Before
from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.joining import both
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.requirement import Anchor, Constraint, Edge, Reference, TimeRequirement
from fuzzytime.rulebook import Rulebook
from fuzzytime.satisfaction import Interval, SatisfactionFunction
from fuzzytime.skills import Precedence
from fuzzytime.spelling import suggestion
from fuzzytime.times import seconds_between

JUST_BEFORE = "just before"
FAR = 86400.0
"""A time far enough from now for words beside it to have all their width."""


@dataclass(slots=True)
class Links:
    """The names of all wishes; and the skills that came of each instruction, by its position among all."""

    wishes: frozenset[str] = frozenset()
    instructions: list[range] = field(default_factory=list)

    def skills_of(self, target: int) -> range:
        """Give the positions of the skills of an instruction; none where it was not planned."""
        return self.instructions[target] if 0 <= target < len(self.instructions) else range(0)

    def meant_by(self, anchor: Anchor) -> range:
        """Give the positions of the skills that an anchor with a target means.

        What only goes on telling ("then", "meanwhile", "after that") goes on from what was last planned:
        "simmer it, stirring occasionally, then serve it".
        """
        target = -1 if anchor.target is None else anchor.target
        named = anchor.verb is not None or anchor.object is not None
        goes_on = not named and not anchor.exact and anchor.share is None
        found = self.skills_of(target)
        while not found and target > 0 and goes_on:
            target -= 1
            found = self.skills_of(target)
        return found


def link(
    skills: Sequence[Interpreted], links: Links, rulebook: Rulebook, now: datetime
) -> tuple[list[Interpreted], tuple[Precedence, ...], list[Problem]]:
    """Turn references into precedences, and let ψ follow the skills that it is measured from; 0 is ``now``.

    Returns
    -------
    skills, precedences, problems
        The skills with their ψ adapted; what binds them; the references that lead nowhere.

    Raises
    ------
    FuzzytimeError
        If ``after`` names an identifier that there is none of.
    """
    linked = list(skills)
    problems: list[Problem] = []
    wanted = _said_by_identifier(skills, links.wishes, problems)
    for position, interpreted in enumerate(skills):
        for requirement in interpreted.requirements:
            if requirement.anchor is None or requirement.anchor.target is None:
                continue
            meant = _over_with(requirement.anchor, links.meant_by(requirement.anchor), linked, links)
            targets = [target for target in meant if target != position]
            if not targets:
                message = f"refers to {requirement.anchor.text!r}, which is not planned"
                problems.append(
                    problem_of(
                        interpreted.wish,
                        ProblemKind.UNRESOLVED,
                        message,
                        requirement.span,
                        interpreted.identifier,
                    )
                )
                continue
            if requirement.anchor.assumed:
                problems.append(_assumed(interpreted, requirement, skills[targets[0]]))
            # Of a repetition, the first occurrence is meant.
            tie = _Tie(linked[targets[0]], linked[position], requirement, requirement.anchor, rulebook)
            linked[position] = tie.follower(now)
            wanted.append((position, tie.precedence(targets[0], position)))
    kept = _without_circles(linked, wanted, problems)
    for position, precedence in kept:
        if position == precedence.second:
            follows = (*linked[position].follows, skills[precedence.first].identifier)
            linked[position] = replace(linked[position], follows=follows)
    return linked, tuple(precedence for _, precedence in kept), problems


def _assumed(this: Interpreted, requirement: TimeRequirement, target: Interpreted) -> Problem:
    """Say of a state that nothing tells of what it is taken to wait for."""
    message = f"nothing tells {requirement.text!r}: taken as once this is done: {target.skill.name}"
    return problem_of(this.wish, ProblemKind.NOTE, message, requirement.span, this.identifier)


def _over_with(anchor: Anchor, meant: range, skills: Sequence[Interpreted], links: Links) -> range:
    """Give what is over where what is repeated is, if that counts: its last turn, or what it is inside of."""
    if len(meant) < 2 or anchor.edge is Edge.START or anchor.exact:
        return meant
    repeated = [part for part in skills[meant[0]].requirements if part.recurrence is not None]
    if any(one.recurrence and one.recurrence.interval and not one.recurrence.endless for one in repeated):
        # "Fold it four times, half an hour apart, then shape it"
        return meant[-1:]
    inside = next((part.anchor.target for part in repeated if part.anchor is not None), None)
    return meant if inside is None else links.skills_of(inside)


def _said_by_identifier(
    skills: Sequence[Interpreted], wishes: frozenset[str], problems: list[Problem]
) -> list[tuple[int, Precedence]]:
    by_identifier: dict[str, list[int]] = {}
    for position, interpreted in enumerate(skills):
        for name in {interpreted.identifier, interpreted.wish.identifier}:
            by_identifier.setdefault(name, []).append(position)
    found = []
    for position, interpreted in enumerate(skills):
        for name in interpreted.wish.after:
            if name in wishes - by_identifier.keys():
                message = f"must come after {name}, which is not planned"
                wish, identifier = interpreted.wish, interpreted.identifier
                problems.append(problem_of(wish, ProblemKind.UNRESOLVED, message, identifier=identifier))
                continue
            if name not in by_identifier:
                where = f"line {interpreted.wish.line}: " if interpreted.wish.line is not None else ""
                meant = suggestion(name, by_identifier)
                raise FuzzytimeError(f"{where}'after' must name the id of a skill, got {name!r}{meant}")
            found += [
                (position, Precedence(first, position)) for first in by_identifier[name] if first != position
            ]
    return found


@dataclass(frozen=True, slots=True)
class _Tie:
    """One skill bound to another by a requirement.

    With x the start of this skill minus the moment it is measured from, the words allow an interval of x.
    """

    target: Interpreted
    this: Interpreted
    requirement: TimeRequirement
    anchor: Anchor
    rulebook: Rulebook

    @property
    def moment(self) -> float:
        """Seconds from the start of the target to the moment that is measured from."""
        skill = self.target.skill
        if self.anchor.share is not None:
            return self.anchor.share * skill.time_until_done
        return {Edge.START: 0.0, Edge.FREE: skill.duration, Edge.END: skill.time_until_done}[self.anchor.edge]

    @property
    def beside(self) -> SatisfactionFunction | None:
        """ψ of when this one is over, from the moment that it is to be right before; None elsewhere.

        What is to be ready when something begins may be ready at that very moment.
        """
        if not self.anchor.exact or self.anchor.lag or self.requirement.constraint is not Constraint.BEFORE:
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
        ends = self.requirement.reference is Reference.FINISH or self.beside is not None
        return self.anchor.lag - (self.this.skill.time_until_done if ends else 0.0)

    def allowed(self) -> Interval:
        """Give the interval of x."""
        if self.anchor.exact:
            leeway = self._leeway()
            return Interval(self.lag + leeway.low, self.lag + leeway.high)
        match self.requirement.constraint:
            case Constraint.BEFORE:
                return Interval(-math.inf, self.anchor.lag - self.this.skill.time_until_done)
            case Constraint.AFTER:
                return Interval(self.anchor.lag, math.inf)
            case Constraint.BETWEEN:  # within so long of it
                return Interval(0.0, self.anchor.lag)
            case _:  # while the other goes on
                return Interval(0.0, max(0.0, self.target.skill.time_until_done - self.moment))

    def _leeway(self) -> Interval:
        """Give how far from the lag is acceptable: as far as "in" that time from now would be."""
        if (beside := self.beside) is not None:
            return beside.support
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
        """Give the x that is wished for, None where only its sign is."""
        if not self.anchor.exact:
            return None
        beside, x = self.beside, self.allowed()
        return min(max(x.low, self.lag + (0.0 if beside is None else min(0.0, beside.best.high))), x.high)

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
        later = self.expected + self.moment - seconds_between(now, self.this.wish.given)
        follows = self.requirement.constraint is Constraint.AFTER and 0 < later < math.inf
        if not (follows and own and all(map(_counts_from_now, own))):
            return self.this
        skill = self.this.skill
        named = None if skill.preferred is None else skill.preferred + later
        moved = replace(skill, satisfaction=skill.satisfaction.shifted(later), preferred=named)
        return replace(self.this, skill=moved)

    def _preferred(self) -> float | None:
        """Give the start that was named, or that at the very distance from where the target's was."""
        target, named, wished = self.target.skill.preferred, self.this.skill.preferred, self._wished()
        return (
            named if named is not None or target is None or wished is None else target + self.moment + wished
        )

    def _satisfaction(self) -> SatisfactionFunction:
        """Let ψ follow the target's, where that is timed."""
        if all(requirement.anchor is not None for requirement in self.target.requirements):
            return self.this.skill.satisfaction
        leeway = self.allowed()
        if (beside := self.beside) is not None and self.target.skill.preferred is not None:
            moved = beside.shifted(self.target.skill.preferred + self.moment + self.lag)
            return both(self.this.skill.satisfaction, moved)
        follows = self.target.skill.satisfaction.shifted(self.moment + self.lag)
        own = self.this.skill.satisfaction
        alone = len([r for r in self.this.requirements if r.anchor is None]) == 0
        factor = (
            1 + leeway.length / max(follows.support.length, 1.0)
            if math.isfinite(follows.support.length)
            else 1.0
        )
        wide = follows.widened(factor, follows.best.low) if not follows.best.empty else follows
        return wide if alone else both(own, wide)


def _counts_from_now(part: TimeRequirement) -> bool:
    """Whether words name no time but that of who speaks: "soon", "right away"."""
    return part.word is not None and not part.t_spec and part.constraint in {Constraint.AT, Constraint.VAGUE}


def _without_circles(
    skills: Sequence[Interpreted], wanted: list[tuple[int, Precedence]], problems: list[Problem]
) -> list[tuple[int, Precedence]]:
    """Keep the precedences that form no circle, in order; say which do not hold."""
    before = Before()
    kept: list[tuple[int, Precedence]] = []
    for position, precedence in wanted:
        if before.add(precedence.first, precedence.second):
            kept.append((position, precedence))
        else:
            first, second = (
                f"{skills[place].skill.name!r} ({skills[place].identifier})"
                for place in (precedence.first, precedence.second)
            )
            message = (
                f"{first} cannot come before {second}, which must come before it: this order is not kept"
            )
            wish, identifier = skills[position].wish, skills[position].identifier
            problems.append(problem_of(wish, ProblemKind.UNRESOLVED, message, identifier=identifier))
    return kept
