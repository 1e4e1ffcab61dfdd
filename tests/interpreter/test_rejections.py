"""Why skills are rejected: by their own words, or because what they must come after is."""

from datetime import datetime

import pytest

from fuzzytime.interpreter import Interpreter, ProblemKind, Request, SpokenWish, plan
from fuzzytime.language import Language
from fuzzytime.rulebook import Rulebook

pytestmark = pytest.mark.model


def test_what_comes_after_a_rejected_skill_says_so() -> None:
    interpreter = Interpreter(Language.shipped(), Rulebook.shipped())
    texts = [
        "Flip the pancakes when the pan is hot",
        "Serve the pancakes after you flip the pancakes",
        "Eat the pancakes after you serve the pancakes",
    ]
    now = datetime(2026, 3, 4, 9)  # noqa: DTZ001
    made = plan(
        Request(now=now, wishes=tuple(SpokenWish(text=text, given=now) for text in texts)), interpreter
    )
    reasons = [problem.message for problem in made.problems if problem.kind is ProblemKind.REJECTED]
    assert reasons == [
        "flip the pancakes: not enough readings of pan_temp",
        "serve the pancakes: must come after flip the pancakes, which is rejected",
        "eat the pancakes: must come after serve the pancakes, which is rejected",
    ]
