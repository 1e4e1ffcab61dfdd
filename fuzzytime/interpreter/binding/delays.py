"""What counts from the step before in a list: "after ten minutes turn it", "once the soup is ready"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.binding.steps import Step
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction, Lexicon, Reading
from fuzzytime.requirement import Anchor, Condition, Constraint, Edge, TimeRequirement

AFTER = "after"
UNTIL = "until"
FOR = "for"


def since_the_step_before(
    instruction: Instruction,
    reading: Reading,
    before: Sequence[range],
    skills: Sequence[Interpreted],
    lexicon: Lexicon,
) -> Instruction:
    """Let so long "after" count from what was asked for right before, from its begin if it lasts as long.

    Of two that share it, the second follows: "after ten minutes turn it and add salt". What no step names,
    as the dish that all is for, is ready when that is done. What a step goes on until is not what a step
    before it did: "bake it until risen". ``before`` are the positions of the skills of all instructions so
    far, ``reading`` is what the step stands in.
    """
    target = last_once(before, skills)
    if target is None or instruction.operation is None or instruction.operation.stated:
        return instruction
    turn = len(before[target]) - 1
    last = skills[before[target][turn]]
    shared = last.instruction.requirements if last.reading is reading and last.instruction else ()
    counted = {part.span for part in shared if _is_distance(part)}
    own = [
        part
        for part in instruction.requirements
        if not ((part.span in counted and _is_distance(part)) or _is_opening(part, reading, before, skills))
    ]
    requirements = tuple(_counted(part, target, turn, last, lexicon) for part in own)
    return replace(instruction, requirements=requirements)


def is_of_what_is_made(part: TimeRequirement, lexicon: Lexicon) -> bool:
    """Whether a time waits until what no instruction names is ready, or counts from that."""
    anchor, condition = part.anchor, part.condition
    if condition is not None:
        known = condition.target is not None or condition.about is not None
        return condition.word in lexicon.results and not known and not condition.negated
    words = "" if anchor is None or anchor.target is not None else anchor.text
    return words.split()[-1:] != [] and words.split()[-1] in lexicon.results


def last_once(before: Sequence[range], skills: Sequence[Interpreted]) -> int | None:
    """Give the latest instruction that asks for something that is over then, and not beside another.

    What is done again and again goes on inside of what is meant: "roast it for an hour, basting it".
    """
    once = (place for place in range(len(before) - 1, -1, -1) if is_over(before[place], skills))
    return next((place for place in once if not Step(0, skills[before[place][0]]).beside), None)


def is_over(places: range, skills: Sequence[Interpreted]) -> bool:
    """Whether what is asked for is done once, or so many times: "wash three times, a minute each"."""
    return len(places) == 1 or (bool(places) and Step(0, skills[places[-1]]).last_of_turns)


def _counted(
    part: TimeRequirement, target: int, turn: int, last: Interpreted, lexicon: Lexicon
) -> TimeRequirement:
    if is_of_what_is_made(part, lexicon):
        if part.anchor is not None:
            return replace(part, anchor=replace(part.anchor, target=target))
        return replace(part, condition=part.condition and replace(part.condition, about=target))
    if part.anchor is not None and _is_end_before(part, part.anchor, target, lexicon):
        return replace(part, constraint=Constraint.WHEN, condition=Condition(text=part.text), anchor=None)
    if not _is_distance(part) or part.anchor is not None or part.t_spec is None:
        return part
    distance = part.t_spec
    edge = Edge.START if distance <= last.skill.time_until_done else Edge.END
    anchor = Anchor(text=part.text, target=target, edge=edge, lag=distance, exact=True, turn=turn or None)
    return replace(
        part, constraint=Constraint.AFTER, anchor=anchor, t_spec=None, earliest=None, latest=None, grain=None
    )


def _is_distance(part: TimeRequirement) -> bool:
    return part.preposition == AFTER and part.unit is not None


def _is_opening(
    part: TimeRequirement, reading: Reading, before: Sequence[range], skills: Sequence[Interpreted]
) -> bool:
    """Whether it is at the beginning of the step itself: "for the first minute"; none above goes on."""
    opens = part.constraint is Constraint.BETWEEN and part.text.split()[:1] == [FOR]
    if not opens or part.anchor is None:
        return opens
    target = part.anchor.target
    known = before[target] if target is not None and target < len(before) else ()
    within = any(skills[place].reading is reading for place in known)
    return part.anchor.verb is None and not within


def _is_end_before(part: TimeRequirement, anchor: Anchor, last: int, lexicon: Lexicon) -> bool:
    """Whether a step goes on until something is so that a step before it brings about as well."""
    marker = tuple(part.text.removesuffix(anchor.text).lower().split())
    until = part.constraint is Constraint.BEFORE and lexicon.clauses.get(marker) == UNTIL
    return until and anchor.edge is Edge.START and anchor.target is not None and anchor.target <= last
