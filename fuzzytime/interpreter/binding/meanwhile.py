"""What is done while something else goes on: "degas the solvent for 20 minutes. Meanwhile weigh the salt"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction, Lexicon
from fuzzytime.requirement import TimeRequirement

MEANWHILE = "meanwhile"


def beside_what_lasts(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted], lexicon: Lexicon
) -> Instruction:
    """Let "meanwhile" mean what was said to go on: "rest the steaks for five minutes, then plate them".

    What is done in a moment is passed over for what the same wish asks for right before it. ``before`` are
    the positions of the skills of all instructions so far.
    """
    requirements = tuple(_meant(part, before, skills, lexicon) for part in instruction.requirements)
    return replace(instruction, requirements=requirements)


def going_on_by_itself(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted], lexicon: Lexicon
) -> list[int]:
    """Give the positions of what leaves hands free while an instruction is done "meanwhile".

    It was said how long it takes, and nobody else is called to do the other.
    """
    operation = instruction.operation
    if operation is None or operation.stated:
        return []
    targets = [_target(part, lexicon) for part in instruction.requirements]
    found = [place for target in targets if target is not None for place in _skills_of(target, before)]
    return [place for place in found if _lasts(skills[place]) and _is_of_same(skills[place], instruction)]


def _meant(
    part: TimeRequirement, before: Sequence[range], skills: Sequence[Interpreted], lexicon: Lexicon
) -> TimeRequirement:
    target = _target(part, lexicon)
    if target is None or part.anchor is None:
        return part
    here = [skills[place] for place in _skills_of(target, before)]
    inside = _inside(here)
    if inside is not None:
        # "Simmer it for an hour, stirring it every ten minutes. Meanwhile boil the rice"
        return replace(part, anchor=replace(part.anchor, target=inside))
    earlier = [skills[place] for place in _skills_of(target - 1, before)]
    passing = bool(here) and not any(map(_lasts, here)) and any(map(_lasts, earlier))
    if not passing or here[0].wish is not earlier[0].wish:
        return part
    return replace(part, anchor=replace(part.anchor, target=target - 1))


def _inside(turns: Sequence[Interpreted]) -> int | None:
    """Give the instruction inside of which something has its turns."""
    parts = (part for turn in turns[:1] for part in turn.requirements if part.recurrence is not None)
    return next((part.anchor.target for part in parts if part.anchor is not None), None)


def _target(part: TimeRequirement, lexicon: Lexicon) -> int | None:
    """Give what an instruction is done beside that "meanwhile" joins to it."""
    said = part.preposition == MEANWHILE or _is_meanwhile(part.text, lexicon)
    return part.anchor.target if said and part.anchor is not None else None


def _is_meanwhile(text: str, lexicon: Lexicon) -> bool:
    """Whether words say that something goes on with what was said before: "in the meantime"."""
    return lexicon.connectives.get(tuple(text.lower().split())) == MEANWHILE


def _skills_of(target: int, before: Sequence[range]) -> range:
    return before[target] if 0 <= target < len(before) else range(0)


def _lasts(made: Interpreted) -> bool:
    """Whether it was said how long something takes that is asked for."""
    return made.instruction is not None and made.instruction.duration is not None and not made.stated


def _is_of_same(made: Interpreted, instruction: Instruction) -> bool:
    """Whether nobody else is called for the one than for the other."""
    first, second = made.operation, instruction.operation
    return first is not None and second is not None and first.addressee == second.addressee
