"""What binds skills, as they are numbered once some of them are left out."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from fuzzytime.skills import Precedence


def renumbered(precedences: Iterable[Precedence], moved: Mapping[int, int]) -> tuple[Precedence, ...]:
    """Give the precedences between skills that are kept, of which ``moved`` tells the new positions."""
    return tuple(
        replace(entry, first=moved[entry.first], second=moved[entry.second])
        for entry in precedences
        if entry.first in moved and entry.second in moved
    )
