"""Lines said at once: instructions in a row are taken together, all else alone."""

from collections.abc import Sequence
from datetime import datetime

from fuzzytime.errors import InstructionError
from fuzzytime.language import Language, reported
from fuzzytime.language.about_wishes import about_wishes
from fuzzytime_cli.inputs.lines import is_ticked_off, said_in
from fuzzytime_cli.repl.commands.by_name import without_colon


def words_of(line: str, language: Language) -> str:
    """Give what was typed; a command that needs no colon as if it had it, and nothing for a comment."""
    words = said_in(line)
    return without_colon(words, language.lexicon) if words else ""


def parted(lines: Sequence[str], language: Language, now: datetime) -> list[list[str]]:
    """Part lines said at once: instructions in a row stand together, all else alone."""
    told = [line for line in lines if words_of(line, language) or is_ticked_off(line)]
    parts: list[list[str]] = []
    went_on = False
    words = [said_in(line) or line.strip() for line in told]
    for line, wish in zip(told, _are_wishes(words, language, now), strict=True):
        if wish and went_on:
            parts[-1].append(line)
        else:
            parts.append([line])
        went_on = wish
    return parts


def _are_wishes(lines: Sequence[str], language: Language, now: datetime) -> list[bool]:
    """Tell of each line whether it is neither a command nor about what was said before."""
    try:
        readings = language.read_independent([(line, now) for line in lines])
    except InstructionError:
        # Taken alone, each line says what is wrong with it.
        return [False] * len(lines)
    lexicon = language.lexicon
    return [
        words_of(line, language) == line
        and line[0] not in ":/"
        and about_wishes(line, now, lexicon) is None
        and not reported(reading, lexicon)
        for line, reading in zip(lines, readings, strict=True)
    ]
