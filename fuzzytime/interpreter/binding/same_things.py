"""What is done with one thing is done in the order said: "peel the potatoes", then "boil the potatoes"."""

from collections.abc import Iterator, Sequence

from fuzzytime.interpreter.binding.steps import OWN_TIME, Step, is_anchored, is_asked
from fuzzytime.interpreter.bounding import is_due_on_day
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Lexicon, content_words, undoes
from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.skills import Precedence

LEAVES_OPEN = frozenset({Constraint.VAGUE, Constraint.BEFORE, Constraint.WHEN})
"""What a step may say of its time, and still be meant before what is said next of its thing."""

BESIDE_OR_BEHIND = frozenset({Constraint.AT, Constraint.AFTER})
"""What a step may say of another, and still be meant before what is said next: "meanwhile", "then"."""

LEADS = OWN_TIME | {Constraint.BEFORE}
"""What says of a step when it is, whatever was said before it."""


def of_things(skills: Sequence[Interpreted], lexicon: Lexicon) -> Iterator[Precedence]:
    """Give the order of what is done with the same thing, where no words say when.

    A time of its own says more than the order: "serve the soup at seven", "heat the soup". What is done once
    more by a deadline, or undoes it, is done shortly before that: "let the dog out at nine", "… again before
    bed"; "drop Mia at nursery", "pick Mia up by five".
    """
    worked_on: dict[str, list[tuple[frozenset[str], Step]]] = {}
    for position, one in enumerate(skills):
        thing = _thing_of(one)
        if not thing:
            continue
        step = Step(position, one)
        rarest = min((worked_on.setdefault(word, []) for word in thing), key=len)
        # "Pick the first tray", "inspect the tray"
        before = next((earlier for named, earlier in reversed(rarest) if thing <= named), None)
        if before is not None and _is_again(before, step, lexicon):
            yield before.precedence_until_due(step)
        elif before is not None and _leaves_open(before) and _is_open(step):
            yield before.precedence(step)
        for word in thing:
            worked_on[word].append((thing, step))


def _thing_of(one: Interpreted) -> frozenset[str]:
    """Give the words of what something is done with, once and by request; none where that is not so."""
    asked = one.operation is not None and one.operation.is_asked and is_asked(one)
    return content_words(one.operation.object) if asked and one.operation is not None else frozenset()


def _leaves_open(step: Step) -> bool:
    """Whether nothing names a time of a step: behind another it is still meant before what is said next."""
    return all(
        part.constraint in LEAVES_OPEN
        if part.anchor is None
        else part.constraint in BESIDE_OR_BEHIND and not part.anchor.exact
        for part in step.interpreted.requirements
    )


def _is_open(step: Step) -> bool:
    said = step.interpreted.requirements
    return not any(part.constraint in LEADS or is_anchored(part) for part in said)


def _is_again(before: Step, step: Step, lexicon: Lexicon) -> bool:
    """Whether the same is done once more, or undone, and only by when is said."""
    one, other = before.interpreted.operation, step.interpreted.operation
    if one is None or other is None:
        return False
    undone = undoes(other, one, lexicon)
    if not undone and (one.phrase, one.object) != (other.phrase, other.object):
        return False
    # "Friday", on a line of its own, says of no hour.
    said = [part for part in step.interpreted.requirements if part.grain is not Unit.DAY]
    due = all(_is_due(part, lexicon) for part in said)
    latest = step.interpreted.skill.satisfaction.best.high
    first = before.interpreted.skill.satisfaction.best.low
    return bool(said) and due and (undone or before.at_moment) and first < latest


def _is_due(part: TimeRequirement, lexicon: Lexicon) -> bool:
    """Whether a time says by when; on a day that a line above names, it says from when, too."""
    due = part.constraint is Constraint.BEFORE or is_due_on_day(part, lexicon)
    return part.anchor is None and due
