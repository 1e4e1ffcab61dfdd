"""Every command in the documents, and in the transcripts kept for tests, does what it is shown to do."""

import doctest
import importlib.util
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.main import get_command

from console import ROOT, Example, blocks_of, compared, examples_of, fits, written_for
from fuzzytime_cli.app import app
from meanings import SHOWN, Row, rows_of

DOCUMENTS = sorted([ROOT / "README.md", *ROOT.glob("docs/**/*.md"), *ROOT.glob("tests/transcripts/*.md")])
EXAMPLES = [example for path in DOCUMENTS if path.exists() for example in examples_of(path)]
ROWS = [row for path in DOCUMENTS for row in rows_of(path)]


@pytest.mark.parametrize("example", EXAMPLES, ids=str)
def test_a_command_writes_what_its_document_shows(example: Example, tmp_path: Path) -> None:
    written = written_for(example, tmp_path)
    assert fits(example.expected, written), f"{example}\n{compared(written)}"


@pytest.mark.parametrize("row", ROWS, ids=str)
def test_what_is_said_means_what_its_table_shows(row: Row) -> None:
    assert row.shown == row.written


def test_the_documents_show_commands_and_meanings() -> None:
    assert {example.path.name for example in EXAMPLES} >= {"README.md"}
    assert {row.heading for row in ROWS} == set(SHOWN)


@pytest.mark.parametrize(
    "path", [path for path in DOCUMENTS if blocks_of(path, "pycon")], ids=lambda p: p.name
)
def test_a_session_of_python_goes_as_its_document_shows(path: Path) -> None:
    text = "\n".join(blocks_of(path, "pycon"))
    session = doctest.DocTestParser().get_doctest(text, {}, path.name, str(path), 0)
    runner = doctest.DocTestRunner()
    runner.run(session)
    assert runner.tries > 0
    assert runner.failures == 0


@pytest.mark.parametrize(
    "path", [path for path in DOCUMENTS if blocks_of(path, "python")], ids=lambda path: path.name
)
def test_the_python_of_a_document_runs(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for block in blocks_of(path, "python"):
        exec(compile(block, str(path), "exec"), {})  # noqa: S102 - that is the test
    assert capsys.readouterr().out


LINK = re.compile(r"\]\(([^)#\s:]+)(?:#[^)\s]*)?\)")


@pytest.mark.parametrize("path", [*DOCUMENTS, ROOT / "CONTRIBUTING.md"], ids=lambda path: path.name)
def test_a_link_leads_to_a_file_and_out_of_no_book(path: Path) -> None:
    prose = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    for link in LINK.findall(prose):
        target = (path.parent / link).resolve()
        assert target.exists(), link
        # The book is made of its own folder, and is not made where one leads out of it.
        assert ROOT / "docs" not in path.parents or ROOT / "docs" in target.parents, link


def test_the_reference_shows_every_command_and_its_options() -> None:
    def names(group: Any, path: str) -> Iterator[str]:  # noqa: ANN401 - Typer's groups have no public type
        for name in group.list_commands(None):
            command = group.get_command(None, name)
            yield from (
                names(command, f"{path} {name}") if hasattr(command, "list_commands") else [f"{path} {name}"]
            )

    shown = {
        example.command.removesuffix(" --help") for example in examples_of(ROOT / "docs" / "commands.md")
    }
    assert set(names(get_command(app), "fuzzytime")) <= shown


def test_the_files_of_a_language_are_where_the_book_says() -> None:
    text = (ROOT / "docs" / "language-extending.md").read_text("utf-8").partition("## Add a language")[2]
    rows = re.findall(r"^\| `([^`]+/[^`]*)` \|", text.partition("## ")[0], re.MULTILINE)
    assert len(rows) > 5
    assert all((ROOT / path).exists() for path in rows)


MODULE = re.compile(r"`([\w./-]+\.py)`")


@pytest.mark.parametrize("path", [*DOCUMENTS, ROOT / "CONTRIBUTING.md"], ids=lambda path: path.name)
def test_a_module_that_is_named_is_there(path: Path) -> None:
    prose = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    places = {
        f"/{module.relative_to(ROOT)}"
        for folder in ("fuzzytime", "cli", "tests", "benchmarks", "docs", "rules")
        for module in (ROOT / folder).rglob("*.py")
    }
    for name in MODULE.findall(prose):
        assert any(place.endswith(f"/{name}") for place in places), name


def test_the_groups_of_words_that_the_book_tells_of_are_in_the_tables() -> None:
    text = (ROOT / "docs" / "language-extending.md").read_text("utf-8")
    words = (ROOT / "rules" / "lexicon.yaml").read_text("utf-8")
    (row,) = re.findall(r"`(noun openers: \[[^`]+\])`", text)
    assert all(
        f"\n{section}:\n  source: " in words
        for section in ("doing", "closed_classes", "beside_times", "no_times")
    )
    assert f"\n  {row}" in words


def test_the_reference_of_the_json_is_that_of_its_schema() -> None:
    specification = importlib.util.spec_from_file_location("reference", ROOT / "docs" / "reference.py")
    assert specification is not None
    assert specification.loader is not None
    reference = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(reference)
    shown, fresh = reference.PAGE.read_text(encoding="utf-8"), reference.written()
    assert fresh.split("```")[0] == shown.split("```")[0]
    assert fresh.split("```")[2] == shown.split("```")[2]
