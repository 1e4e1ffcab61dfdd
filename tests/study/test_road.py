"""The whole road: people mean something, and the plan follows."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from fuzzytime_cli import app as terminal
from fuzzytime_cli.study import app

STRICT = "fuzzytime: 1\n"
LENIENT = "fuzzytime: 1\nwidth: {base: 451.6 s, growth: 0.13624}\n"


def planned(folder: Path, truth: str) -> dict[str, object]:
    (folder / "truth.yaml").write_text(truth, encoding="utf-8")
    database, table = folder / "answers.sqlite", folder / "mine.yaml"
    runner = CliRunner()
    for arguments in (
        ["simulate", "--participants", "8", "--db", database, "--truth", folder / "truth.yaml"],
        ["analyse", database, "--permutations", "9"],
        ["calibrate", database, "-o", table],
    ):
        assert runner.invoke(app, [str(argument) for argument in arguments]).exit_code == 0
    said = ["-i", "Place the steak in the pan in ten minutes", "-i", "Make the salad in ten minutes"]
    common = ["plan", "--now", "2026-03-04T09:00", "--format", "json", "--rules", str(table)]
    found = runner.invoke(terminal.app, [*common, *said, "-i", "Wash the apples in ten minutes"])
    assert found.exit_code == 0, found.output
    document = json.loads(found.stdout)
    assert isinstance(document, dict)
    return document


@pytest.mark.model
def test_the_plan_changes_as_the_truth_does(tmp_path: Path) -> None:
    plans = {}
    for name, truth in (("strict", STRICT), ("lenient", LENIENT)):
        (tmp_path / name).mkdir()
        plans[name] = planned(tmp_path / name, truth)
    satisfaction = {name: plan["satisfaction"]["product"] for name, plan in plans.items()}  # type: ignore[index]
    assert satisfaction["lenient"] > 2 * satisfaction["strict"]
    skills = {name: plan["skills"] for name, plan in plans.items()}
    for skill in skills["lenient"]:  # type: ignore[attr-defined]
        corners = skill["satisfaction_function"]["parameters"]
        # Half-bases of 451.6 s + 0.13624 · 600 s.
        assert corners["fall_end"] - 600 == pytest.approx(533.3, rel=0.1)
    for skill in skills["strict"]:  # type: ignore[attr-defined]
        assert skill["satisfaction_function"]["parameters"]["fall_end"] - 600 == pytest.approx(133.3, rel=0.1)
