"""Lines of text, or of JSON, to lines of JSON: what `fuzzytime parse` answers."""

import json
from collections.abc import Iterable, Iterator
from datetime import datetime
from itertools import islice
from typing import Any

from fuzzytime.errors import FuzzytimeError, InstructionError
from fuzzytime.language import Language, answer
from fuzzytime.times import parse_instant

BATCH = 256
"""Lines read together: the model is faster on many, and memory stays bounded."""


def answers(lines: Iterable[str], language: Language, now: datetime, *, objects: bool) -> Iterator[str]:
    """Give one JSON line for each line, in order; a line that cannot be read gets an ``error``.

    Parameters
    ----------
    lines
        Texts; where ``objects`` is set, also ``{"text": …, "now": …}``.
    language
        What reads them.
    now
        The moment of texts that say none.
    objects
        Whether a line that starts with a brace is a JSON object.
    """
    stream = iter(lines)
    while batch := list(islice(stream, BATCH)):
        questions = [_question(line, now, objects=objects) for line in batch]
        good = [(text, when) for text, when, error in questions if not error]
        replies = iter(_replies(good, language))
        for text, when, error in questions:
            reply = _failed(text, when, error) if error else next(replies)
            yield json.dumps(reply, ensure_ascii=False, allow_nan=False)


def _question(line: str, now: datetime, *, objects: bool) -> tuple[str, datetime, str]:
    """Read a line as text, moment and error."""
    if not (objects and line.lstrip().startswith("{")):
        return line.strip("\r\n"), now, ""
    try:
        asked = json.loads(line)
    except (ValueError, RecursionError) as error:
        return line.strip("\r\n"), now, f"a line must be a JSON object or plain text: {error}"
    text, said = asked.get("text"), asked.get("now")
    if not isinstance(text, str) or not (said is None or isinstance(said, str)):
        return line.strip("\r\n"), now, 'an object must have a "text", and may have a "now", both texts'
    try:
        return text, parse_instant(said, now.tzinfo) if said else now, ""
    except FuzzytimeError as error:
        return text, now, str(error)


def _replies(asked: list[tuple[str, datetime]], language: Language) -> list[dict[str, Any]]:
    """Read texts together; where one of them is refused, one by one."""
    try:
        return [answer(reading) for reading in language.read_independent(asked)]
    except InstructionError:
        return [_alone(text, when, language) for text, when in asked]


def _alone(text: str, when: datetime, language: Language) -> dict[str, Any]:
    try:
        return answer(language.read(text, now=when))
    except InstructionError as error:
        return _failed(text, when, error.message)


def _failed(text: str, when: datetime, error: str) -> dict[str, Any]:
    return {
        "text": text,
        "now": when.isoformat(),
        "operation": None,
        "requirements": [],
        "duration_s": None,
        "repeats": None,
        "instructions": 0,
        "error": error,
    }
