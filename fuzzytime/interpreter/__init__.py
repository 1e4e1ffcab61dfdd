"""Language and rulebook joined: from what a person asks for to fuzzy skills, and on to a plan."""

from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.interpreter import Interpreter
from fuzzytime.interpreter.planner import Plan, plan, scheduled, task_of, understood
from fuzzytime.interpreter.request import MAX_HORIZON, DirectWish, Moved, Request, SpokenWish, Started, Wish

__all__ = [
    "MAX_HORIZON",
    "DirectWish",
    "Interpretation",
    "Interpreted",
    "Interpreter",
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
