"""What wishes say of each other: "after setting the table", "five minutes before you serve the soup".

A reference becomes a precedence with lags. Where the wish for a distance is exact and the other skill has a
time of its own, ψ of this one follows it, so that both are wished for at matching times.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter.binding.circles import Before
from fuzzytime.interpreter.binding.ties import Tie
from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement
from fuzzytime.rulebook import Rulebook
from fuzzytime.satisfaction import NEVER
from fuzzytime.skills import Precedence
from fuzzytime.spelling import suggestion


@dataclass(slots=True)
class Links:
    """The names of all wishes; and the skills that came of each instruction, by its position among all.

    ``done`` are the positions of instructions that tell of something that it is done already.
    """

    wishes: frozenset[str] = frozenset()
    instructions: list[range] = field(default_factory=list)
    done: set[int] = field(default_factory=set)

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
    skills: Sequence[Interpreted], links: Links, rulebook: Rulebook, now: datetime, agents: int
) -> tuple[list[Interpreted], tuple[Precedence, ...], list[Problem]]:
    """Turn references into precedences, and let ψ follow the skills that it is measured from; 0 is ``now``.

    Where there is one of the ``agents`` only, what is done during what keeps the hands comes behind it.

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
            meant = _turn_of(requirement.anchor, links.meant_by(requirement.anchor), linked, links)
            targets = [target for target in meant if target != position]
            if not targets:
                linked[position], problem = _without_target(linked[position], requirement, links)
                problems.append(problem)
                continue
            if requirement.anchor.assumed:
                problems.append(_assumed(interpreted, requirement, skills[targets[0]]))
            # Of a repetition, the first occurrence is meant where words name no other.
            pair = linked[targets[0]], linked[position]
            tie = Tie(*pair, requirement, requirement.anchor, rulebook, one_agent=agents == 1)
            linked[position] = tie.follower(now)
            wanted.append((position, tie.precedence(targets[0], position)))
    kept = _without_circles(linked, wanted, problems)
    for position, precedence in kept:
        if position == precedence.second:
            follows = (*linked[position].follows, skills[precedence.first].identifier)
            linked[position] = replace(linked[position], follows=follows)
    return linked, tuple(precedence for _, precedence in kept), problems


def _without_target(
    this: Interpreted, requirement: TimeRequirement, links: Links
) -> tuple[Interpreted, Problem]:
    """Say that something refers to what is not planned, and withhold what would wait for that.

    Nobody knows when that is over, so that "don't restart it until the vacuum is done" is no leave to begin:
    as where no signal tells a condition. What was said to be done already is waited for no longer, and what
    only goes on telling ("then") waits for nothing by name. What is to be done before it may begin at
    any time, as what is not planned has not begun; a distance before it is as little known as one behind.
    """
    anchor = requirement.anchor
    named = anchor is not None and (anchor.verb is not None or anchor.object is not None)
    exact = anchor is not None and anchor.exact
    waits = named and requirement.constraint is not Constraint.BEFORE
    text = requirement.text if anchor is None else anchor.text
    message, kind = f"refers to {text!r}, which is not planned", ProblemKind.UNRESOLVED
    if anchor is not None and anchor.target in links.done:
        message, kind = f"refers to {text!r}, which was done already", ProblemKind.NOTE
    elif waits or exact:
        skill = replace(this.skill, satisfaction=NEVER)
        waits = this.waits or not this.reason
        this = replace(this, skill=skill, reason=this.reason or message, waits=waits)
    else:
        message += ": taken as not held up by it"
    return this, problem_of(this.wish, kind, message, requirement.span, this.identifier)


def _assumed(this: Interpreted, requirement: TimeRequirement, target: Interpreted) -> Problem:
    """Say of a state that nothing tells of what it is taken to wait for."""
    message = f"nothing tells {requirement.text!r}: taken as once this is done: {target.skill.name}"
    return problem_of(this.wish, ProblemKind.NOTE, message, requirement.span, this.identifier)


def _turn_of(anchor: Anchor, meant: range, skills: Sequence[Interpreted], links: Links) -> range:
    """Give the turn of what is repeated that is meant, where it is one of them."""
    if anchor.turn is not None:
        return meant[anchor.turn : anchor.turn + 1]
    return _over_with(anchor, meant, skills, links)


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
            others = [first for first in by_identifier[name] if first != position]
            found += [(position, Precedence(first, position)) for first in others]
            if not others:
                message = f"{name} cannot come after itself: this order is not kept"
                problems.append(
                    problem_of(
                        interpreted.wish, ProblemKind.UNRESOLVED, message, identifier=interpreted.identifier
                    )
                )
    return found


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
