"""Instructions a line, with ``#`` comments."""

import re
from datetime import datetime

from fuzzytime.errors import DocumentError, Mistake
from fuzzytime.interpreter import SpokenWish
from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.inputs.source import Source

MAX_INSTRUCTIONS = 2_000
"""More than a person can have said; a plan of them would take minutes and help nobody."""

COMMAND = re.compile(r":[a-z][a-z-]*(?=\s|$)")
"""What begins a line for the conversation: ``:rate 1 4``."""


def wishes_of(source: Source, now: datetime) -> tuple[SpokenWish, ...]:
    """Give the instructions of a text, with their lines.

    Raises
    ------
    NoInputError
        If there are only comments.
    DocumentError
        If there are more than `MAX_INSTRUCTIONS`, or a line is a command of the conversation.
    """
    wishes: list[SpokenWish] = []
    mistakes: list[Mistake] = []
    for number, line in enumerate(source.text.split("\n"), 1):
        words = line.strip()
        if not words or words.startswith("#"):
            continue
        if len(wishes) == MAX_INSTRUCTIONS:
            rule = (
                f"a plan must hold at most {MAX_INSTRUCTIONS:,} instructions (for several files, see: batch)"
            )
            raise DocumentError((Mistake(source.name, number, 1, "", rule, line),))
        command = COMMAND.match(words)
        if command is not None:
            rule = f"{command.group()!r} is a command of the conversation (see: fuzzytime repl)"
            mistakes.append(Mistake(source.name, number, line.index(":") + 1, "", rule, line))
        wishes.append(SpokenWish(text=words, given=now, line=number))
    if mistakes:
        raise DocumentError(tuple(mistakes))
    if not wishes:
        raise NoInputError(
            f"{source.name}: the input must hold at least one instruction, and all are comments"
        )
    return tuple(wishes)
