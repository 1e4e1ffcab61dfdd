"""What is done with one thing is done in the order said: "peel the potatoes", then "boil the potatoes"."""

from collections.abc import Iterator, Sequence

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.steps import OWN_TIME, Step, is_anchored, is_asked
from fuzzytime.language import content_words
from fuzzytime.requirement import Constraint
from fuzzytime.skills import Precedence

LEAVES_OPEN = frozenset({Constraint.VAGUE, Constraint.BEFORE})
"""What a step may say of its time, and still be meant before what is said next of its thing."""


def of_things(skills: Sequence[Interpreted]) -> Iterator[Precedence]:
    """Give the order of what is done with the same thing, where no words say when.

    A time of its own says more than the order: "serve the soup at seven", "heat the soup".
    """
    latest: dict[frozenset[str], Step] = {}
    for position, one in enumerate(skills):
        thing = _thing_of(one)
        if not thing:
            continue
        step, before = Step(position, one), latest.get(thing)
        if before is not None and _leaves_open(before) and _is_open(step):
            yield before.precedence(step)
        latest[thing] = step


def _thing_of(one: Interpreted) -> frozenset[str]:
    """Give the words of what something is done with, once and by request; none where that is not so."""
    asked = one.operation is not None and one.operation.is_asked and is_asked(one)
    return content_words(one.operation.object) if asked and one.operation is not None else frozenset()


def _leaves_open(step: Step) -> bool:
    said = step.interpreted.requirements
    return all(part.constraint in LEAVES_OPEN and not is_anchored(part) for part in said)


def _is_open(step: Step) -> bool:
    said = step.interpreted.requirements
    return not any(part.constraint in OWN_TIME | LEAVES_OPEN or is_anchored(part) for part in said)
