"""Where a value stands in JSON text, sought only once something is wrong with it: reading stays quick."""

import json
import re
from collections.abc import Sequence

_SPACE = re.compile(r"[ \t\n\r]*")


def place_of(text: str, path: Sequence[str | int]) -> tuple[int, int]:
    r"""Give line and column, from 1, of the value to which a path of keys and positions leads.

    A path that leads nowhere ends where it still led.

    Parameters
    ----------
    text : str
        Valid JSON.
    path : sequence of str and int
        Keys of objects, and positions in lists.

    >>> place_of('{"curves":\n  {"soon": [0, 2]}}', ("curves", "soon", 1))
    (2, 16)
    """
    at = _after_space(text, 0)
    for step in path:
        inside = _inside(text, at, step)
        if inside is None:
            break
        at = inside
    return text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at)


def _inside(text: str, at: int, step: str | int) -> int | None:
    """Give where a member of the object, or an item of the list, at a place begins."""
    opening, position = text[at], 0
    if opening not in "{[":
        return None
    decoder = json.JSONDecoder(strict=False)
    at = _after_space(text, at + 1)
    while text[at] not in "}]":
        name: str | int = position
        if opening == "{":
            name, at = decoder.raw_decode(text, at)
            at = _after_space(text, _after_space(text, at) + 1)
        if name == step:
            return at
        at = _after_space(text, decoder.raw_decode(text, at)[1])
        at = _after_space(text, at + 1) if text[at] == "," else at
        position += 1
    return None


def _after_space(text: str, at: int) -> int:
    found = _SPACE.match(text, at)
    return found.end() if found is not None else at


def path_text(path: Sequence[str | int]) -> str:
    """Write a path as messages do.

    >>> path_text(("participants", 0, "curves", "soon"))
    'participants[0].curves.soon'
    """
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).removeprefix(".")
