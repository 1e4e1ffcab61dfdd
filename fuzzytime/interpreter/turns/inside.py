"""What is done again and again while something goes on: "print the bracket", "check it every 30 minutes"."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.interpreter.in_other_words.retold import turn
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction, Lexicon, shares_thing
from fuzzytime.requirement import Constraint, Edge, Recurrence, TimeRequirement

TWICE = 2
"""How many times an interval must fit into what goes on, for a repetition to be about that."""


@dataclass(frozen=True, slots=True)
class GoingOn:
    """An instruction by its position among all, and how long it goes on, in seconds."""

    target: int
    length: float
    name: str

    def times(
        self, repeated: TimeRequirement, recurrence: Recurrence, _: float
    ) -> Iterator[tuple[TimeRequirement]]:
        """Give a repetition's times in it, each at its distance from the start."""
        interval = recurrence.interval or self.length
        if recurrence.closing is not None:
            # "For the last hour": from where that begins.
            begins = self.length - recurrence.closing
            turns = math.ceil(recurrence.closing / interval)
            lags = [begins + count * interval for count in range(turns) if begins + count * interval >= 0]
        elif not recurrence.endless and not recurrence.all_day:
            # "Every ten minutes for the first hour"
            lags = [start for start, _ in recurrence.windows(self.length) if start < self.length]
        else:
            lags = [count * interval for count in range(1, math.ceil(self.length / interval))]
        for lag in lags:
            yield (turn(repeated, self.target, Edge.START, lag),)


def going_on(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted], lexicon: Lexicon
) -> GoingOn | None:
    """Give what goes on while an instruction is repeated; None where it is repeated without that.

    It is what words name ("every ten minutes during the incubation"), or the latest that is about the same
    thing and goes on long enough. ``before`` are the positions of the skills of all instructions so far.
    """
    repeated = next((part for part in instruction.requirements if part.recurrence is not None), None)
    if repeated is not None and repeated.recurrence is not None and repeated.recurrence.closing is not None:
        return _said_of(instruction, repeated, before, skills)
    if repeated is not None and repeated.anchor is not None and repeated.anchor.edge is Edge.START:
        return _said_of(instruction, repeated, before, skills)
    if repeated is None or repeated.recurrence is None:
        return None
    if not (repeated.recurrence.endless or repeated.recurrence.all_day):
        return None
    interval = repeated.recurrence.interval
    if interval is None:
        return None
    named = _named(instruction)
    order = range(len(before) - 1, -1, -1) if named is None else [named]
    for target in order:
        made = [skills[place] for place in before[target]] if 0 <= target < len(before) else []
        # What words name may be told to last for one turn alone.
        least = interval + 1.0 if named is not None else TWICE * interval
        if len(made) == 1 and _goes_on(made[0], least):
            one = made[0]
            begins = _begins_behind(repeated.recurrence, interval, one)
            if begins and (named is not None or _is_about(instruction, one, lexicon)):
                return GoingOn(target, one.skill.time_until_done, one.skill.name)
    return None


def _begins_behind(recurrence: Recurrence, interval: float, one: Interpreted) -> bool:
    """Whether a repetition has no begin of its own: the first is so long from now, or from a skill's time.

    Neither has one that only the skill's own day bounds.
    """
    if recurrence.all_day:
        day, best = recurrence.occurrences(math.inf), one.skill.satisfaction.best
        return bool(day) and day[0] <= best.low <= best.high <= day[-1] + interval
    starts = [0.0, *(part.t_spec for part in one.requirements if part.t_spec is not None)]
    firsts = (interval + start for start in starts)
    return any(recurrence.windows(first)[:1] == ((first, first),) for first in firsts)


def _said_of(
    instruction: Instruction,
    repeated: TimeRequirement,
    before: Sequence[range],
    skills: Sequence[Interpreted],
) -> GoingOn | None:
    """Give what a repetition counts in: "baste it every 20 minutes for the last hour", "… the first hour"."""
    target = _named(instruction)
    target = repeated.anchor.target if target is None and repeated.anchor is not None else target
    made = [] if target is None or target >= len(before) else [skills[place] for place in before[target]]
    if target is None or len(made) != 1:
        return None
    return GoingOn(target, made[0].skill.time_until_done, made[0].skill.name)


def _named(instruction: Instruction) -> int | None:
    anchors = (p.anchor for p in instruction.requirements if p.constraint is Constraint.AT and p.anchor)
    return next((anchor.target for anchor in anchors if anchor.target is not None), None)


def _goes_on(one: Interpreted, least: float) -> bool:
    """Whether a skill lasts long enough, by itself or because somebody says so."""
    itself = one.skill.time_until_done > one.skill.duration or not one.duration.assumed
    return itself and one.skill.time_until_done >= least


def _is_about(instruction: Instruction, one: Interpreted, lexicon: Lexicon) -> bool:
    operation, other = instruction.operation, one.operation
    if operation is None or other is None:
        return False
    if operation.object is None and operation.verb != operation.lemma:
        # "Mash for an hour, stirring every ten minutes"
        return True
    # "Check on it"
    named = not lexicon.closed.it_or_them.isdisjoint((operation.place or "").lower().split())
    return named or shares_thing(operation, other)
