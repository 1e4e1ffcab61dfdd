"""Customs are taken from a flag, the environment, the settings and the places where they always count."""

from pathlib import Path

import pytest

from console import ROOT
from fuzzytime_cli.settings import PROJECT_CUSTOMS
from terminal.running import ran

CUSTOMS = ROOT / "examples" / "tables" / "customs.yaml"
CALVES = ("-i", "Feed the calves this evening", "--now", "2026-03-04T09:00")


@pytest.mark.parametrize("command", ["parse", "plan", "explain", "rules show"])
def test_every_command_that_reads_words_takes_customs(command: str, tmp_path: Path) -> None:
    texts = CALVES if command in {"parse", "plan"} else CALVES[1:]
    asked = (*command.split(), *texts)
    own, shipped = (ran(*asked, *more, folder=tmp_path) for more in (("--customs", str(CUSTOMS)), ()))
    assert (own.code, shipped.code) == (0, 0)
    assert own.out != shipped.out
    assert "16:" in own.out


def test_customs_of_the_environment_and_the_settings_count(tmp_path: Path) -> None:
    assert "T16:00" in ran("parse", *CALVES, folder=tmp_path, FUZZYTIME_CUSTOMS=str(CUSTOMS)).out
    settings = tmp_path / "settings.yaml"
    settings.write_text(f"customs: {CUSTOMS}\n", encoding="utf-8")
    assert "T16:00" in ran("parse", *CALVES, folder=tmp_path, FUZZYTIME_CONFIG=str(settings)).out
    (tmp_path / "customs.yaml").write_text(CUSTOMS.read_text("utf-8").replace("16:00", "17:00"), "utf-8")
    settings.write_text("", encoding="utf-8")
    assert "T17:00" in ran("parse", *CALVES, folder=tmp_path, FUZZYTIME_CONFIG=str(settings)).out


def test_rules_check_checks_customs_and_rules_together(tmp_path: Path) -> None:
    bad = tmp_path / "customs.yaml"
    bad.write_text("fuzzytime: 1\nlanguage: en\nparts: {evening: {form: 1}}\n", encoding="utf-8")
    done = ran("rules", "check", str(bad), "tests/data/mistakes.yaml", folder=tmp_path)
    assert done.code == 78
    assert f"{bad}:3:19: parts.evening.form: unknown key 'form'" in done.err
    assert "mistakes.yaml:" in done.err
    assert ran("rules", "check", str(CUSTOMS), folder=tmp_path).code == 0


def test_what_is_no_file_of_customs_is_said(tmp_path: Path) -> None:
    rules = ran("parse", *CALVES, "--customs", "examples/tables/first.yaml", folder=tmp_path)
    assert (rules.code, "--rules takes it" in rules.err) == (78, True)
    missing = ran("parse", *CALVES, "--customs", "none.yaml", folder=tmp_path)
    assert (missing.code, missing.err) == (66, "fuzzytime: none.yaml: there is no such file of customs\n")
    swapped = ran("plan", *CALVES, "--rules", str(CUSTOMS), folder=tmp_path)
    assert (swapped.code, "--customs takes it" in swapped.err) == (78, True)


def test_a_batch_answers_anew_when_customs_change(tmp_path: Path) -> None:
    task, customs, out = (tmp_path / name for name in ("task.txt", "own.yaml", "answers.jsonl"))
    task.write_text("Feed the calves this evening\n", encoding="utf-8")
    asked = ("batch", str(task), "--jobs", "1", "--now", "2026-03-04T09:00", "--customs", str(customs))
    said = []
    for begin in ("16:00", "17:00"):
        customs.write_text(CUSTOMS.read_text("utf-8").replace("16:00", begin), "utf-8")
        assert ran(*asked, "-o", str(out), folder=tmp_path).code == 0
        said.append(out.read_text(encoding="utf-8"))
    assert said[0] != said[1]
    (tmp_path / PROJECT_CUSTOMS).write_text("fuzzytime: 1\nlanguage: en\n", encoding="utf-8")
    folder = ran(
        "batch", str(tmp_path), "--jobs", "1", "--now", "2026-03-04T09:00", "-o", "-", folder=tmp_path
    )
    assert PROJECT_CUSTOMS not in folder.out
