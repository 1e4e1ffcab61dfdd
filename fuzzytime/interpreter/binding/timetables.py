"""Lines whose times go up are a timetable: one without a time comes behind the line above it.

"9:45 mash in", "recirculate for ten minutes", "11:00 sparge". A list of things to do, whose times come as
they may, says nothing of the kind.
"""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence

from fuzzytime.interpreter.binding.steps import OWN_TIME, Step, is_anchored
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import shares_thing
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.skills import Precedence

FEWEST = 3
"""Lines with times that show an order, at least."""

FEW_ODD = 5
"""Of so many lines with times, one may be out of their order: "van to the garage friday 8:30"."""

TIMED = 3
"""One line of so many has a time, at least."""

BY_THE_CLOCK = frozenset({Unit.SECOND, Unit.MINUTE, Unit.HOUR})
"""How finely a time is said that shows where its line stands; a day does not."""


def of_timetables(skills: Sequence[Interpreted], prepared: Iterable[Precedence] = ()) -> Iterator[Precedence]:
    """Give the order of a file's lines, if their times show one: what says no time follows what is above it.

    By when something is done is no time of its own where times stand as in a table ("9:45", not "at 9:45").
    What is ``prepared`` for what stands above it follows nothing.
    """
    free = {entry.first for entry in prepared if entry.second < entry.first}
    listed = [place for place, one in enumerate(skills) if one.wish.line is not None and place not in free]
    moments = {place: part for place in listed if (part := _moment_of(skills[place])) is not None}
    run = _rising({place: _began(part) for place, part in moments.items()})
    timed, lines = ({skills[place].wish.line for place in places} for places in (run, listed))
    odd = len(moments) - len(run)
    if len(timed) < FEWEST or TIMED * len(timed) < len(lines) or FEW_ODD * odd > len(moments):
        return
    tabular = 2 * sum(moments[place].preposition is None for place in run) > len(run)
    above: list[Step] = []
    over = 0.0
    coming = [*reversed(run)]
    for place in listed:
        step = Step(place, skills[place])
        if coming and place == coming[-1]:
            coming.pop()
            above.append(step)
            over = _began(moments[place]) + step.interpreted.keeps_hands
        elif _stands_open(step.interpreted, over if tabular else None):
            due = _began(moments[coming[-1]]) if coming else None
            yield from (_behind(one, moments.get(one.position), step, due) for one in above)
            above = [step]
        elif above and _begins_here(step.interpreted, over, _began(moments[coming[-1]]) if coming else None):
            # "Pick up the car any time after two", then "get some milk on the way"
            above.append(step)


def _begins_here(one: Interpreted, over: float, due: float | None) -> bool:
    """Whether something is from a time on that lies between those of the lines above and below."""
    said = [part for part in one.requirements if _says_when(part)]
    from_then = all(part.constraint is Constraint.AFTER and not is_anchored(part) for part in said)
    begins = max((_began(part) for part in said if part.grain in BY_THE_CLOCK), default=-1.0)
    return from_then and not one.repeats and over <= begins and (due is None or begins < due)


def _behind(above: Step, at: TimeRequirement | None, step: Step, due: float | None) -> Precedence:
    """Let a line follow one above, once hands are free of that, or it is done with the same thing.

    What goes on by itself is over by when the next line with a time is ``due``: "8:15 film", "9:45 teeth".
    """
    skill, operation = above.interpreted.skill, above.interpreted.operation
    following = step.interpreted.operation
    left = 0.0
    if above.interpreted.stated:
        left = 0.0 if at is None or due is None else max(0.0, _began(at) + skill.time_until_done - due)
    elif operation is None or following is None or not shares_thing(operation, following):
        left = skill.time_until_done - above.interpreted.keeps_hands
    return Precedence(above.position, step.position, -left)


def _stands_open(one: Interpreted, over: float | None) -> bool:
    """Whether nothing says when something is but a day above.

    In a table, where it is known when the line above is ``over``, by when may be said if that is later.
    """
    if one.operation is None or one.repeats:
        return False
    said = [part for part in one.requirements if _says_when(part)]
    due = all(part.constraint is Constraint.BEFORE and part.anchor is None for part in said)
    return not said or (over is not None and due and over <= one.skill.satisfaction.best.high)


def _began(moment: TimeRequirement) -> float:
    """Give when a moment is, in seconds."""
    return moment.earliest or 0.0


def _moment_of(one: Interpreted) -> TimeRequirement | None:
    """Give what says when something is by the clock; None for what is so only by a day, or again."""
    own = (part for part in one.requirements if _says_when(part) and not is_anchored(part))
    said = (part for part in own if part.constraint in OWN_TIME and part.grain in BY_THE_CLOCK)
    return None if one.repeats else next((part for part in said if part.earliest is not None), None)


def _says_when(part: TimeRequirement) -> bool:
    """Whether it is of words of the line, and not of a day above, and more than how long it takes."""
    return part.span[0] < part.span[1] and part.constraint is not Constraint.FOR


def _rising(moments: Mapping[int, float]) -> tuple[int, ...]:
    """Give the places of the longest run of moments that go up; of several, the one that ends first."""
    ends: list[float] = []
    runs: list[tuple[int, ...]] = []
    for place, moment in moments.items():
        length = bisect_right(ends, moment)
        run = (*(runs[length - 1] if length else ()), place)
        ends[length : length + 1], runs[length : length + 1] = [moment], [run]
    return runs[-1] if runs else ()
