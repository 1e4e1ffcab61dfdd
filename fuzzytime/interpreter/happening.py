"""What happens by itself, where it was said to, and what keeps who speaks from all else."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.joining import both
from fuzzytime.interpreter.remarks import problem_of, too_late
from fuzzytime.interpreter.request import Request, Started
from fuzzytime.requirement import Constraint
from fuzzytime.satisfaction import NEVER, Rectangle
from fuzzytime.skills import Busy, Precedence
from fuzzytime.times import instant_after

SURE = 0.999
"""The satisfaction from which on a start is as said."""


def happening(interpretation: Interpretation, started: Sequence[Started] = ()) -> Interpretation:
    """Keep what happens where it was said to: it gives way to nobody's work.

    What is tied to such a moment has its own time by that; what was to come before it and has not
    ``started`` when it happens is said to be late, and may come as soon as it can.
    """
    skills = list(map(_where_it_happens, interpretation.skills))
    fixed = {place: one.skill.satisfaction.best.low for place, one in enumerate(skills) if _is_fixed(one)}
    begun = {one.identifier for one in started}
    problems: list[Problem] = []
    kept = []
    for entries in (interpretation.precedences, interpretation.order):
        left = []
        for entry in _without_cancelled(entries, skills):
            # "Before Anna gets up", who has slept since before now
            until = fixed.get(entry.second, math.inf) - min(entry.minimum_lag, 0.0)
            if until > 0 or entry.first in fixed:
                left.append(entry)
            elif skills[entry.first].identifier not in begun and not _is_lost(skills[entry.first]):
                problems.append(too_late(skills[entry.first], skills[entry.second]))
        kept.append(_tied(left, skills, fixed))
    return replace(
        interpretation,
        skills=tuple(skills),
        precedences=tuple(kept[0]),
        order=tuple(kept[1]),
        problems=(*interpretation.problems, *problems),
    )


def _is_lost(one: Interpreted) -> bool:
    return one.skill.satisfaction.support.empty


def _is_fixed(one: Interpreted) -> bool:
    """Whether it happens at a moment that is known."""
    support = one.skill.satisfaction.support
    return one.skill.happens and support.low == support.high


def _without_cancelled(entries: Sequence[Precedence], skills: list[Interpreted]) -> list[Precedence]:
    """Let what was to come beside what will not happen have no time; give the entries left."""
    left: list[Precedence] = []
    for entry in entries:
        gone = [place for place in (entry.first, entry.second) if skills[place].cancelled]
        if not gone:
            left.append(entry)
        for place in {entry.first, entry.second}.difference(gone) if gone else ():
            skills[place] = without_time(skills[place], skills[gone[0]])
    return left


def without_time(one: Interpreted, cancelled: Interpreted) -> Interpreted:
    """Give what was to come beside something that will not happen: at no time."""
    reason = f"its time is told by {cancelled.skill.name!r}, which will not happen"
    skill = replace(one.skill, satisfaction=NEVER, preferred=None)
    return replace(one, skill=skill, reason=reason, waits=False)


def _tied(
    entries: Sequence[Precedence], skills: list[Interpreted], fixed: Mapping[int, float]
) -> list[Precedence]:
    """Put what must come before or after what has its moment where that allows; give the entries left."""
    left = []
    for entry in entries:
        if (entry.first in fixed) is (entry.second in fixed):
            left.append(entry)
            continue
        if entry.first in fixed:
            place, event = entry.second, entry.first
            done = fixed[event] + skills[event].skill.time_until_done
            window = Rectangle(done + entry.minimum_lag, done + entry.maximum_lag)
        else:
            place, event = entry.first, entry.second
            start = fixed[event] - skills[place].skill.time_until_done
            window = Rectangle(start - entry.maximum_lag, start - entry.minimum_lag)
        skills[place] = _inside(skills[place], window, skills[event])
    return left


def _inside(one: Interpreted, window: Rectangle, event: Interpreted) -> Interpreted:
    """Give a skill that starts in a window, because of what happens."""
    function = both(one.skill.satisfaction, window)
    reason = one.reason
    if not reason and function.support.empty and not one.skill.satisfaction.support.empty:
        reason = f"its time does not go together with {event.skill.name!r}"
    skill, tied_to = replace(one.skill, satisfaction=function), (*one.tied_to, event.identifier)
    return replace(one, skill=skill, reason=reason, tied_to=tied_to)


def _where_it_happens(one: Interpreted) -> Interpreted:
    if one.skill.duration or not one.stated:
        return one
    one = replace(one, skill=replace(one.skill, happens=True))
    time = one.skill.preferred
    if time is None or not all(part.anchor is None for part in one.requirements):
        return one
    if any(part.constraint is Constraint.BETWEEN for part in one.requirements):
        # "Lunch" alone is near the middle of its hours, and not there whatever comes.
        return one
    if time < 0 or float(one.skill.satisfaction(time)) < SURE:
        return one
    return replace(one, skill=replace(one.skill, satisfaction=Rectangle(time, time)))


def attended(interpretation: Interpretation, request: Request) -> tuple[tuple[Interpreted, Busy], ...]:
    """Give when who speaks is taken: "I have a meeting from two to four" is no wish, and gives way to none.

    Of several agents the first speaks, unless the wish says which. What is told to be over takes nobody.
    """
    found = []
    done = {one.identifier: one.done for one in request.started}
    for interpreted in interpretation.skills:
        operation, start = interpreted.operation, interpreted.skill.preferred
        if operation is not None and operation.attended and start is not None:
            end = done.get(interpreted.identifier, start + interpreted.skill.time_until_done)
            speaker = interpreted.wish.agent or (1 if request.agents > 1 else None)
            if max(start, 0.0) < end:
                found.append((interpreted, Busy(max(start, 0.0), end, interpreted.skill.name, speaker)))
    return tuple(found)


def clashes(appointments: Sequence[tuple[Interpreted, Busy]], request: Request) -> list[Problem]:
    """Say of appointments that overlap: nobody can be at both, and a plan gives way to each of them."""
    told: dict[tuple[str, str], Problem] = {}
    for position, (one, mine) in enumerate(appointments):
        for other in (*request.busy, *(taken for _, taken in appointments[:position])):
            same = mine.agent == other.agent or None in {mine.agent, other.agent}
            pair = (mine.what, other.what)
            if same and mine.start < other.end and other.start < mine.end and pair not in told:
                names = " and ".join(_span(taken, request) for taken in (other, mine))
                message = f"{names} overlap"
                told[pair] = problem_of(one.wish, ProblemKind.NOTE, message, identifier=one.identifier)
    return list(told.values())


def _span(taken: Busy, request: Request) -> str:
    start, end = (instant_after(request.now, time) for time in (taken.start, taken.end))
    return f"{taken.what or 'an appointment'} ({start:%H:%M} to {end:%H:%M})"
