"""Starts that are wished for at a distance from another skill, wherever that is: "ten minutes later"."""

from collections.abc import Mapping, Sequence

from fuzzytime.satisfaction import Floats
from fuzzytime.skills import FuzzySkill, FuzzyTask


def wished_distances(task: FuzzyTask, positions: Sequence[int]) -> Mapping[int, tuple[int, float]]:
    """Give for each skill that follows another that other, and how many seconds after it to start.

    A skill whose start was named follows none; of two of which neither was, the later follows the earlier.
    Skills are meant by their place among ``positions``, which are those in the task.
    """
    place = {position: index for index, position in enumerate(positions)}
    found: dict[int, tuple[int, float]] = {}
    for entry in task.precedences:
        if entry.wished_lag is None or entry.first not in place or entry.second not in place:
            continue
        first, second = task.skills[entry.first], task.skills[entry.second]
        distance = first.time_until_done + entry.wished_lag
        one, other = place[entry.first], place[entry.second]
        named = (first.preferred is not None, second.preferred is not None)
        if named == (True, False) or (named == (False, False) and distance >= 0):
            found.setdefault(other, (one, distance))
        elif named != (True, True):
            found.setdefault(one, (other, -distance))
    return found


def at_distances(
    skills: Sequence[FuzzySkill], distances: Mapping[int, tuple[int, float]], starts: Floats
) -> tuple[FuzzySkill, ...]:
    """Let the start that each wishes for be at its distance from the start that the other has."""
    wished = {place: float(starts[other]) + distance for place, (other, distance) in distances.items()}
    return tuple(
        skill.starting_near(wished[place]) if place in wished else skill for place, skill in enumerate(skills)
    )
