"""What a list of steps leads to at a moment: dinner at eight is not made in the morning."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Lexicon, names_meal
from fuzzytime.skills import Precedence


def shortly_before(
    skills: Sequence[Interpreted], ends: Iterable[int], order: Sequence[Precedence], lexicon: Lexicon
) -> list[Interpreted]:
    """Let what leads to what is eaten at a moment be wished for as late as it is in time for that.

    ``ends`` are the positions of the steps that lists lead to. Where that was to begin by now, all is
    done as early as it can be, and so is what has a time of its own.
    """
    found = list(skills)
    for end in ends:
        named = skills[end].skill.preferred
        if named is None or not _is_eaten(skills[end], lexicon):
            continue
        latest = _latest(skills, end, named, order)
        if min(latest.values()) < 0:
            continue
        for place, start in latest.items():
            if skills[place].skill.preferred is None:
                skill = found[place].skill.starting_near(start)
                found[place] = replace(found[place], skill=skill)
    return found


def _latest(
    skills: Sequence[Interpreted], end: int, named: float, order: Sequence[Precedence]
) -> dict[int, float]:
    """Give the latest start of all that must be done before the end, where hands are free for all of it."""
    latest = {end: named}
    waiting = [end]
    while waiting:
        following = waiting.pop()
        for entry in order:
            if entry.second != following:
                continue
            first = skills[entry.first].skill
            # "Start by five"; what waits to be told of has no time at all.
            known = math.inf if first.satisfaction.support.empty else first.satisfaction.best.high
            own = known if first.preferred is None else first.preferred
            start = min(own, latest[following] - entry.minimum_lag - first.time_until_done)
            if start < latest.get(entry.first, named + 1.0):
                latest[entry.first] = start
                waiting.append(entry.first)
    return latest


def _is_eaten(end: Interpreted, lexicon: Lexicon) -> bool:
    operation = end.operation
    if operation is None:
        return False
    meal = operation.stated and names_meal(operation.object, lexicon)
    return meal or operation.lemma in lexicon.doing.eating
