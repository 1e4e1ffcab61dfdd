"""What reading a text has to say, as problems of the wish that it came from."""

from fuzzytime.interpreter.interpretation import WITHIN, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.request import SpokenWish, Wish
from fuzzytime.language import Instruction, Reading, RemarkKind
from fuzzytime.language.instruction import overlap

_KINDS = {
    RemarkKind.NOT_UNDERSTOOD: ProblemKind.NOT_UNDERSTOOD,
    RemarkKind.UNRESOLVED: ProblemKind.UNRESOLVED,
    RemarkKind.POLICY: ProblemKind.NOTE,
    RemarkKind.CORRECTED: ProblemKind.NOTE,
    RemarkKind.TOLD: ProblemKind.NOTE,
}


def problem_of(
    wish: Wish, kind: ProblemKind, message: str, span: tuple[int, int] | None = None, identifier: str = ""
) -> Problem:
    """Make a problem of a wish."""
    text = wish.text if isinstance(wish, SpokenWish) else ""
    return Problem(kind=kind, message=message, line=wish.line, text=text, span=span, identifier=identifier)


def remarks_of(reading: Reading, wish: Wish) -> list[Problem]:
    """Give the remarks of a reading as problems, in the order of the words."""
    remarks = sorted(reading.remarks, key=lambda remark: remark.span)
    return [problem_of(wish, _KINDS[remark.kind], remark.message, remark.span) for remark in remarks]


def too_late(one: Interpreted, begun: Interpreted) -> Problem:
    """Say that one comes too late for another that has begun, before which it was to be done."""
    message = f"{one.skill.name}: was to be done before {begun.skill.name!r}, and has not been"
    return problem_of(one.wish, ProblemKind.UNRESOLVED, message, identifier=one.identifier)


def is_spoiled(instruction: Instruction, reading: Reading, problems: list[Problem]) -> bool:
    """Say whether an instruction holds words about time that were not understood: then it is not acted on.

    Words outside every instruction spoil all of the text's instructions.
    """
    for problem in problems:
        if problem.kind is not ProblemKind.NOT_UNDERSTOOD or problem.span is None:
            continue
        owners = [other for other in reading.instructions if overlap(other.span, problem.span)]
        if not owners or instruction in owners:
            return True
    return False


def is_told(instruction: Instruction, reading: Reading) -> bool:
    """Say whether an instruction only tells how things are: that is noted, and asks for nothing."""
    told = (remark.span for remark in reading.remarks if remark.kind is RemarkKind.TOLD)
    return instruction.operation is None and any(overlap(instruction.span, span) for span in told)


def notes_of(interpreted: Interpreted) -> list[Problem]:
    """Give what the rulebook noted about a skill, each sentence once."""
    if not interpreted.requirements:
        return []  # that any time satisfies is not news where no time was asked for
    noted = (note for resolution in interpreted.resolutions for note in resolution.notes)
    # What people expect is no news; who asks for an explanation reads it there.
    notes = dict.fromkeys(note for note in noted if note != WITHIN)
    wish, identifier = interpreted.wish, interpreted.identifier
    return [problem_of(wish, ProblemKind.NOTE, note, identifier=identifier) for note in notes]
