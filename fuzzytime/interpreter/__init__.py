"""Language and rulebook joined: from what a person asks for to fuzzy skills, and on to a plan.

A request goes through three steps; each module is one of them, or one thing that words may ask for on the
way.

Understanding (``interpreter``)
    Values: ``request``, ``interpretation``.
    Wishes in turn, each made into skills: ``gathering``, ``making``, ``how_long``, ``remarks``,
    ``notes``, ``identifiers``.
    When they are done: ``offered``, ``joining``, ``bounding``.
    What was said ``in_other_words``; what happens, ``told_anew``; ``turns`` of what is repeated.
    Who, and how far ahead: ``asked``, ``horizon``.

What binds skills
    References and order: ``binding``.

Planning (``planner``)
    What happens by itself, and what has begun: ``happening``, ``started``.
    How far one of those that are planned may move: ``leeway``.
"""

from fuzzytime.interpreter.interpretation import (
    IN_THE_PLAN,
    Interpretation,
    Interpreted,
    Problem,
    ProblemKind,
)
from fuzzytime.interpreter.interpreter import Interpreter
from fuzzytime.interpreter.leeway import Leeway, Limit
from fuzzytime.interpreter.planner import Plan, plan, scheduled, task_of, understood
from fuzzytime.interpreter.request import (
    MAX_HORIZON,
    WITHOUT_END,
    DirectWish,
    Moved,
    Request,
    SpokenWish,
    Started,
    Wish,
)

__all__ = [
    "IN_THE_PLAN",
    "MAX_HORIZON",
    "WITHOUT_END",
    "DirectWish",
    "Interpretation",
    "Interpreted",
    "Interpreter",
    "Leeway",
    "Limit",
    "Moved",
    "Plan",
    "Problem",
    "ProblemKind",
    "Request",
    "SpokenWish",
    "Started",
    "Wish",
    "plan",
    "scheduled",
    "task_of",
    "understood",
]
