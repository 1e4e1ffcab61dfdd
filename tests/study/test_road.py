"""The whole road: people mean something, and the plan follows."""

import json
from pathlib import Path
from typing import Any

import pytest

from terminal.running import Ran, ran

STRICT = "fuzzytime: 1\n"
LENIENT = "fuzzytime: 1\nwidth: {base: 451.6 s, growth: 0.13624}\n"


def planned(folder: Path, truth: str) -> dict[str, Any]:
    folder.mkdir()
    (folder / "truth.yaml").write_text(truth, encoding="utf-8")
    road = [
        "study simulate --participants 8 --db {0}/answers.sqlite --truth {0}/truth.yaml",
        "study analyse {0}/answers.sqlite --permutations 9",
        "study calibrate {0}/answers.sqlite -o {0}/mine.yaml",
        "rules check {0}/mine.yaml",
        "plan --now 2026-03-04T09:00 --format json --rules {0}/mine.yaml",
    ]
    said = [
        ("-i", f"{what} in ten minutes") for what in ("Fry the steak", "Make the salad", "Wash the apples")
    ]
    done = Ran("", "", 0)
    for words in road:
        more = sum(said, ()) if words.startswith("plan") else ()
        done = ran(*words.format(folder).split(), *more, folder=folder)
        assert done.code == 0, done.err
    document = json.loads(done.out)
    assert isinstance(document, dict)
    return document


@pytest.mark.model
def test_the_plan_changes_as_the_truth_does(tmp_path: Path) -> None:
    strict, lenient = (
        planned(tmp_path / name, truth) for name, truth in (("strict", STRICT), ("lenient", LENIENT))
    )
    assert lenient["satisfaction"]["product"] > 2 * strict["satisfaction"]["product"]
    # Half-bases of 112.9 s + 0.03406 · 600 s, and of 451.6 s + 0.13624 · 600 s.
    for plan, half_base in ((strict, 133.3), (lenient, 533.3)):
        for skill in plan["skills"]:
            corners = skill["satisfaction_function"]["parameters"]
            assert corners["fall_end"] - 600 == pytest.approx(half_base, rel=0.1)
