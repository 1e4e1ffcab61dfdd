"""Every command in the documents, and in the transcripts kept for tests, does what it is shown to do."""

from pathlib import Path

import pytest

from console import ROOT, Example, compared, examples_of, fits, written_by

DOCUMENTS = sorted([ROOT / "README.md", *ROOT.glob("docs/**/*.md"), *ROOT.glob("tests/transcripts/*.md")])
EXAMPLES = [example for path in DOCUMENTS if path.exists() for example in examples_of(path)]


@pytest.mark.parametrize("example", EXAMPLES, ids=str)
def test_a_command_writes_what_its_document_shows(example: Example, tmp_path: Path) -> None:
    written = written_by(example.command, tmp_path)
    assert fits(example.expected, written), f"{example}\n{compared(written)}"


def test_the_documents_show_commands() -> None:
    assert {example.path.name for example in EXAMPLES} >= {"README.md"}
