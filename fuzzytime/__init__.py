"""fuzzytime: from what people say about time to the schedule that satisfies them most.

>>> import fuzzytime as ft
>>> interpreter = ft.Interpreter.shipped()
>>> steak = interpreter.skill("Place the steak in about ten minutes!")
>>> salad = interpreter.skill("Make the salad in about ten minutes!", duration=ft.minutes(6))
>>> schedule = ft.solve(ft.FuzzyTask((steak, salad)))
>>> schedule.certificate.status.value, round(schedule.satisfaction, 2)
('optimal', 1.0)

The names below are imported when they are first used, so that importing fuzzytime costs nothing.

The road from text to schedule
    ``language``, ``context`` and ``rulebook`` meet in the ``interpreter``; ``scheduling`` follows; a
    ``study`` makes the tables. What they hand on: ``requirement``, ``satisfaction``, ``skills``.
What they stand on
    ``times``, ``documents`` and ``resources``, ``english`` and ``spelling``, ``errors``.
"""

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fuzzytime.context import Context, Reading
    from fuzzytime.errors import DocumentError, FuzzytimeError, InstructionError, RefusedError
    from fuzzytime.interpreter import DirectWish, Interpreter, Plan, Request, SpokenWish, plan
    from fuzzytime.language import Language
    from fuzzytime.requirement import TimeRequirement
    from fuzzytime.rulebook import Actor, Profile, Rulebook
    from fuzzytime.satisfaction import (
        Bell,
        Floored,
        Interval,
        Rectangle,
        Sampled,
        SatisfactionFunction,
        Trapezoid,
        Triangle,
    )
    from fuzzytime.scheduling import Certificate, Limits, Schedule, Solver, Status, solve
    from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence, SpecificSkill
    from fuzzytime.times import hours, minutes, seconds

_HOMES = {
    "fuzzytime.context": ("Context", "Reading"),
    "fuzzytime.errors": ("DocumentError", "FuzzytimeError", "InstructionError", "RefusedError"),
    "fuzzytime.interpreter": ("DirectWish", "Interpreter", "Plan", "Request", "SpokenWish", "plan"),
    "fuzzytime.language": ("Language",),
    "fuzzytime.requirement": ("TimeRequirement",),
    "fuzzytime.rulebook": ("Actor", "Profile", "Rulebook"),
    "fuzzytime.satisfaction": (
        *("Bell", "Floored", "Interval", "Rectangle"),
        *("Sampled", "SatisfactionFunction", "Trapezoid", "Triangle"),
    ),
    "fuzzytime.scheduling": ("Certificate", "Limits", "Schedule", "Solver", "Status", "solve"),
    "fuzzytime.skills": ("Busy", "FuzzySkill", "FuzzyTask", "Precedence", "SpecificSkill"),
    "fuzzytime.times": ("hours", "minutes", "seconds"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__all__ = sorted(_HOME_OF)  # noqa: PLE0605 - a list of strings, whatever makes it


def __getattr__(name: str) -> Any:  # noqa: ANN401 - each name has its own type, above
    if name not in _HOME_OF:
        raise AttributeError(f"module 'fuzzytime' has no attribute {name!r}")
    return getattr(importlib.import_module(_HOME_OF[name]), name)


def __dir__() -> list[str]:
    return list(__all__)
