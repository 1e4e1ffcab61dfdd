"""Procedures: what one sentence names step by step, to be done in that order."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from fuzzytime.interpreter.binding.steps import Step, is_asked
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction, Lexicon, Reading

THEN = "then"
SHORTEST = 3
"""Steps of a sentence at least that are done in the order said."""


def procedures(
    reading: Reading,
    made: Sequence[tuple[Instruction, range]],
    skills: Sequence[Interpreted],
    lexicon: Lexicon,
) -> Iterator[list[Step]]:
    """Give the steps that a sentence names one after the other, where they are a procedure."""
    steps: list[Step] = []
    last: Instruction | None = None
    for place, (instruction, places) in enumerate(made):
        step = Step(places[-1], skills[places[-1]], place) if places else None
        asked = step is not None and ((len(places) == 1 and is_asked(step.interpreted)) or step.last_of_turns)
        joint = "" if last is None else reading.text[last.span[1] : instruction.span[0]]
        if not asked or not _goes_on_by(joint, lexicon):
            yield from _procedure(steps)
            steps = []
        steps += [step] if asked and step is not None else []
        last = instruction
    yield from _procedure(steps)


def _goes_on_by(joint: str, lexicon: Lexicon) -> bool:
    """Whether what stands between two steps lets the second go on where the first ends."""
    words = tuple(joint.lower().replace(",", " ").replace(";", " ").split())
    added = lexicon.closed.additions.issuperset(words)
    return added or lexicon.connectives.get(words) == THEN or lexicon.connectives.get(words[1:]) == THEN


def _procedure(steps: list[Step]) -> Iterator[list[Step]]:
    """Give steps that are a procedure: more than two, whose own times follow each other.

    "Call mum at six, wash the car, buy milk" are chores, each with a thing of its own, and wait for no other.
    """
    timed = [place for place, step in enumerate(steps) if step.timed]
    begins = [min((low for low, _ in steps[place].times if low is not None), default=0.0) for place in timed]
    ascending = all(one <= other for one, other in pairwise(begins)) and 2 * len(timed) <= len(steps) + 1
    if len(steps) >= SHORTEST and ascending and any(map(_goes_on, steps[1:])):
        yield steps


def _goes_on(step: Step) -> bool:
    """Whether a step names nothing of its own, or how long it goes on: "circle for ten minutes", "land"."""
    operation = step.interpreted.operation
    alone = operation is None or operation.object is None or operation.again
    return alone or not step.interpreted.duration.assumed
