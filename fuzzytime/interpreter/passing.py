"""What is done again and again while something else keeps the hands longer than until its next time.

"Stir the mix for an hour. Check the ewe every 20 minutes": nobody puts the stirring off until all checks are
over, and nobody leaves them out. They are done in passing, beside it.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.rulebook import Rulebook

FAIR = 0.5
"""Satisfaction with which an occurrence may still give way to something else."""


def in_passing(
    skills: Sequence[Interpreted], rulebook: Rulebook, agents: int
) -> tuple[list[Interpreted], tuple[Problem, ...]]:
    """Let what is repeated need no free hands where none of its agents has any, and say so once of each."""
    often = Counter(one.wish.identifier for one in skills if _interval(one) is not None)
    found: list[Interpreted] = []
    problems: dict[str, Problem] = {}
    for one in skills:
        longer = None if often[one.wish.identifier] < 2 else _longer(one, skills, rulebook, agents)
        if longer is None:
            found.append(one)
            continue
        skill = replace(one.skill, duration=0.0, elapsed=one.skill.time_until_done, in_passing=True)
        found.append(replace(one, skill=skill))
        message = (
            f"{one.skill.name} is done in passing: {longer.skill.name} takes longer than the time between"
        )
        problems.setdefault(
            one.wish.identifier, problem_of(one.wish, ProblemKind.NOTE, message, None, one.wish.identifier)
        )
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


def _interval(one: Interpreted) -> float | None:
    """Give the seconds between the occurrences that a skill is one of; None where it is none."""
    told = (part.recurrence.interval for part in one.requirements if part.recurrence is not None)
    return next((interval for interval in told if interval is not None), None)
