"""The figures that the language is built for, on corpora given by path: they are not in this repository.

``FUZZYTIME_CORPORA`` names a folder with ``time_phrases.jsonl``, ``instructions.jsonl`` and ``grade.py``.
"""

import json
import os
import runpy
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest

from fuzzytime.language import Language, answer

CORPORA = os.environ.get("FUZZYTIME_CORPORA", "")
pytestmark = [
    pytest.mark.model,
    pytest.mark.skipif(not CORPORA, reason="FUZZYTIME_CORPORA does not name a folder of corpora"),
]

GOALS = {"core": 0.96, "near48": 0.92, "fuzzy": 0.92, "nontime": 1.0}


def cases(name: str) -> list[dict[str, Any]]:
    lines = (Path(CORPORA) / name).read_text("utf-8").splitlines()
    return [json.loads(line) for line in lines]


def answers(asked: list[dict[str, Any]]) -> list[dict[str, Any]]:
    nows = [datetime.fromisoformat(case.get("reference", "2026-03-04T09:00:00")[:19]) for case in asked]
    texts = [(case["text"], now) for case, now in zip(asked, nows, strict=True)]
    return [answer(reading) for reading in Language.shipped().read_independent(texts)]


@pytest.mark.parametrize("subset", GOALS)
def test_phrases_reach_their_goal(subset: str) -> None:
    grade = runpy.run_path(str(Path(CORPORA) / "grade.py"))
    timed = {"none", "duration"}
    asked = [
        case
        for case in cases("time_phrases.jsonl")
        if subset in case["tags"]
        and case["kind"] != "set"
        and (case["kind"] in timed or grade["moment"](case["start"]) or grade["moment"](case["end"]))
    ]
    verdicts = [grade["phrase_is_right"](c, a) for c, a in zip(asked, answers(asked), strict=True)]
    assert sum(verdicts) / len(verdicts) >= GOALS[subset]


def test_instructions_reach_their_goal() -> None:
    grade = runpy.run_path(str(Path(CORPORA) / "grade.py"))
    asked = [c for c in cases("instructions.jsonl") if not c["verb_or_action"].startswith("action:")]
    verdicts = [all(grade["instruction_is_right"](c, a)) for c, a in zip(asked, answers(asked), strict=True)]
    assert sum(verdicts) / len(verdicts) >= 0.92
