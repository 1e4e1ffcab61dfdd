"""What is done again and again while something else keeps the hands longer than until its next time.

"Stir the mix for an hour. Check the ewe every 20 minutes": nobody puts the stirring off until all checks are
over, and nobody leaves them out. They are done in passing, beside it. So is what takes a moment and lies
inside of something else: "knead the dough for ten minutes. Add the salt two minutes into the kneading".
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.binding.references import Links
from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.requirement import Constraint, Edge, TimeRequirement
from fuzzytime.rulebook import Rulebook

FAIR = 0.5
"""Satisfaction with which an occurrence may still give way to something else."""


def in_passing(
    skills: Sequence[Interpreted], rulebook: Rulebook, agents: int, links: Links
) -> tuple[list[Interpreted], tuple[Problem, ...]]:
    """Let what is repeated need no free hands where none of its agents has any, and say so once of each.

    So it is with what is said to be done inside of something else that keeps all hands.
    """
    often = Counter(one.wish.identifier for one in skills if _interval(one) is not None)
    found: list[Interpreted] = []
    problems: dict[str, Problem] = {}
    for one in skills:
        longer = None if often[one.wish.identifier] < 2 else _longer(one, skills, rulebook, agents)
        around = _around(one, skills, rulebook, links) if longer is None and agents == 1 else None
        if longer is not None:
            identifier, why = one.wish.identifier, f"{longer.skill.name} takes longer than the time between"
        elif around is not None:
            identifier, why = one.identifier, f"{around.skill.name} goes on"
        else:
            found.append(one)
            continue
        skill = replace(one.skill, duration=0.0, elapsed=one.skill.time_until_done, in_passing=True)
        found.append(replace(one, skill=skill))
        message = f"{one.skill.name} is done in passing: {why}"
        problems.setdefault(identifier, problem_of(one.wish, ProblemKind.NOTE, message, None, identifier))
    return found, tuple(problems.values())


def _longer(
    one: Interpreted, skills: Sequence[Interpreted], rulebook: Rulebook, agents: int
) -> Interpreted | None:
    """Give what keeps hands for longer than the time between two occurrences, if it leaves none free."""
    interval, hands_on = _interval(one), one.skill.duration
    if interval is None or not hands_on or not rulebook.in_passing(hands_on, interval):
        return None
    around = one.skill.satisfaction.acceptable(FAIR)
    # One may be as early, and the next as late, as satisfies fairly.
    between = interval - hands_on + around.high - around.low
    longer = [other for other in skills if _interval(other) is None and other.skill.duration > between]
    bound = [other for other in longer if other.skill.agent is not None]
    own = [other for other in bound if other.skill.agent == one.skill.agent]
    kept = len({other.skill.agent for other in bound}) + len(longer) - len(bound)
    return (own or longer)[0] if own or kept >= agents else None


def _around(
    one: Interpreted, skills: Sequence[Interpreted], rulebook: Rulebook, links: Links
) -> Interpreted | None:
    """Give what keeps the hands while something short is to be done inside of it, by what is said of that."""
    for part in one.requirements:
        if part.anchor is None or part.anchor.target is None or not one.skill.duration:
            continue
        other = next((skills[place] for place in links.skills_of(part.anchor.target)), None)
        inside = other is not None and other is not one and _is_inside(part, other)
        if inside and other is not None and rulebook.in_passing(one.skill.duration, other.keeps_hands):
            return other
    return None


def _is_inside(part: TimeRequirement, other: Interpreted) -> bool:
    """Whether a time is inside of what keeps the hands then: "two minutes into the kneading"."""
    anchor, length, kept = part.anchor, other.skill.time_until_done, other.keeps_hands
    if anchor is None:
        return False
    if part.constraint is Constraint.AT:
        # "During the kneading"; but "meanwhile" names nothing.
        return kept >= length and (anchor.verb is not None or anchor.object is not None)
    if part.constraint not in {Constraint.AFTER, Constraint.BEFORE} or not anchor.exact:
        return False
    if anchor.share is not None:
        return anchor.share * length < kept
    return 0 < anchor.lag + (0 if anchor.edge is Edge.START else length) < min(kept, length)


def _interval(one: Interpreted) -> float | None:
    """Give the seconds between the occurrences that a skill is one of; None where it is none."""
    told = (part.recurrence.interval for part in one.requirements if part.recurrence is not None)
    return next((interval for interval in told if interval is not None), None)
