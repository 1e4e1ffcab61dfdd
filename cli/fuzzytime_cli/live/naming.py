"""Names that stay: a plan counts its skills anew each time, a run must not."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter import Interpreted, Request

_MARK = "#"
"""No name that a person may give begins with it."""


def bare(request: Request) -> Request:
    """Give a request whose wishes all have names, by which their skills are known, and refer to none."""
    return replace(
        request,
        wishes=tuple(
            replace(wish, identifier=wish.identifier or f"{_MARK}{position}", after=())
            for position, wish in enumerate(request.wishes)
        ),
    )


def named(request: Request, skills: Sequence[Interpreted]) -> Request:
    """Give every wish the name that its first skill has in a plan: s1, s2, …, or its own.

    What "after" says is named by a plan's numbers; where they are others here, it is renamed.

    Parameters
    ----------
    request
        As it was given.
    skills
        What its `bare` form is understood as.
    """
    taken = {wish.identifier for wish in request.wishes}
    first: dict[str, str] = {}
    names: dict[str, str] = {}
    for number, interpreted in enumerate(skills, 1):
        mark, _, further = interpreted.identifier.partition(".")
        if not mark.startswith(_MARK):
            continue
        planned = f"s{number}"
        while planned in taken:
            planned += "'"
        own = first.setdefault(mark, planned)
        names[planned] = f"{own}.{further}" if further else own
    return replace(
        request,
        wishes=tuple(
            replace(
                wish,
                identifier=wish.identifier or first.get(f"{_MARK}{position}", ""),
                after=tuple(names.get(name, name) for name in wish.after),
            )
            for position, wish in enumerate(request.wishes)
        ),
    )
