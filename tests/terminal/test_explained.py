"""An instruction explained: what holds for the whole text is told once, and what is nowhere needs no room."""

from pathlib import Path

import pytest

from terminal.running import ran

pytestmark = pytest.mark.model

AXIS = 9
"""The column of a chart's axis."""

TWO = "stir the soup soon, and serve it around half past seven pm"


def explained(text: str, folder: Path) -> list[str]:
    return ran("explain", text, "--now", "2026-03-04T17:00", folder=folder).out.splitlines()


def rows_of_charts(lines: list[str]) -> int:
    return sum(line[AXIS : AXIS + 1] == "│" for line in lines)


def test_the_tree_of_a_text_with_two_skills_is_shown_once(tmp_path: Path) -> None:
    lines = explained(TWO, tmp_path)
    assert lines.count("tree") == lines.count("words that say when") == 1
    assert lines.count("time") == lines.count("why then") == 2


def test_each_skill_behind_the_first_has_its_name(tmp_path: Path) -> None:
    heads = [line for line in explained(TWO, tmp_path) if line.startswith("s1")]
    assert heads == [f"s1: {TWO}", "s1.2: serve the soup"]


def test_a_satisfaction_that_is_0_everywhere_takes_one_row(tmp_path: Path) -> None:
    nowhere, everywhere = (
        explained(text, tmp_path) for text in ("stir it when the pan is hot", "stir it soon")
    )
    assert rows_of_charts(nowhere) == 2
    assert rows_of_charts(everywhere) == 8


def test_what_could_be_meant_otherwise_stands_behind_the_time(tmp_path: Path) -> None:
    lines = explained("call mum at ten", tmp_path)
    assert lines.index("time") < lines.index("in doubt") < lines.index("rows and rules")
    assert any("'at ten' is taken as 10:00" in line for line in lines[lines.index("in doubt") :])
