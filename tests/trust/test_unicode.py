"""Text in any form: composed or not, full-width, right to left, emoji, and bytes that are no text."""

import json
import unicodedata
from pathlib import Path
from typing import Literal

import pytest

from fuzzytime_cli.exits import Exit
from terminal.running import Ran, ran
from terminal.talking import Talk

NOW = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")
NO_TEXT = "Call \udcff mum in ten minutes"
"""What the shell's bytes become where they are no UTF-8."""


def planned(text: str, folder: Path) -> dict[str, object]:
    done = ran("plan", "-i", text, "--format", "json", *NOW, folder=folder)
    assert (done.code, done.err) == (Exit.FINE, "")
    (skill,) = json.loads(done.out)["skills"]
    assert isinstance(skill, dict)
    return skill


@pytest.mark.parametrize("form", ["NFC", "NFD", "NFKC", "NFKD"])
def test_the_form_of_accents_changes_no_time(
    form: Literal["NFC", "NFD", "NFKC", "NFKD"], tmp_path: Path
) -> None:
    typed = unicodedata.normalize(form, "Warm the crème brûlée in ten minutes")
    skill = planned(typed, tmp_path)
    assert skill["instruction"] == typed
    assert skill["start_s"] == 600
    assert unicodedata.normalize("NFC", str(skill["name"])) == "warm the crème brûlée"


@pytest.mark.parametrize(
    "typed",
    [
        "Boil the eggs in １０ minutes",
        "Boil the eggs in ١٠ minutes",
        "Boil\u00a0the\u00a0eggs in\u200910\u202fminutes",
        "Feed the 🐈‍⬛ in ten minutes",
        "Warm שקשוקה in ten minutes",
        "Warm \u202ethe soup\u202c in ten minutes",
        NO_TEXT,
        "Call \ud83d mum in ten minutes",
    ],
    ids=ascii,
)
def test_a_time_is_understood_beside_and_in_any_letters(typed: str, tmp_path: Path) -> None:
    skill = planned(typed, tmp_path)
    assert (skill["instruction"], skill["start_s"]) == (typed, 600)


@pytest.mark.parametrize("kind", ["table", "csv", "ics", "html", "svg", "jsonl"])
def test_what_is_no_text_is_written_as_an_escape(kind: str, tmp_path: Path) -> None:
    done = ran("plan", "-i", NO_TEXT, "--format", kind, *NOW, folder=tmp_path)
    assert (done.code, done.err) == (Exit.FINE, "")
    assert kind == "table" or "udcff" in done.out


COMMANDS = [
    ("plan", "-"),
    ("parse",),
    ("run", "-", "--simulate"),
    ("run", "-i", "Stir the soup now", "--simulate"),
]


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_bytes_that_are_no_text_have_a_place(command: tuple[str, ...], tmp_path: Path) -> None:
    done = ran(*command, *NOW, folder=tmp_path, stdin=b"Stir the soup soon\nCall \xff mum\n")
    assert "UTF-8" in done.out + done.err
    assert "should not happen" not in done.err
    assert done.code in {Exit.FINE, Exit.BAD_DATA}


@pytest.mark.parametrize("name", ["lines.txt", "task.yaml"])
def test_a_file_that_is_no_text_is_refused_with_line_and_column(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(b"instructions:\n  - Call \xff mum\n")
    done = ran("plan", str(path), folder=tmp_path)
    assert done.code == Exit.BAD_DATA
    assert f"{path}:2:10: text must be UTF-8, got byte 0xff" in done.err


def test_a_conversation_keeps_what_is_no_text_as_it_came(tmp_path: Path) -> None:
    talk = Talk(tmp_path / "sessions.sqlite")
    talk.say(NO_TEXT)
    assert talk.entries == [NO_TEXT]
    assert "Call \\udcff mum" in talk.say(":list")
    assert "undone: Call \\udcff mum" in talk.say(":undo")
    again: Ran = ran("repl", "caf\udce9", *NOW, folder=tmp_path, stdin=b"Call \xff mum soon\n:list\n")
    assert again.code == Exit.FINE
    assert "should not happen" not in again.err
