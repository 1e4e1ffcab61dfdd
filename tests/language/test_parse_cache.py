"""Parses on disk: the same trees come back, whatever happens to the file; a full hit needs no model."""

import json
import sqlite3
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.language import shipped_lexicon
from fuzzytime.language.sentence.trees.model import ModelPackage
from fuzzytime.language.sentence.trees.parse_cache import ParseCache
from fuzzytime.language.sentence.trees.tree import Node, Tree
from language.trees import PLACE_THE_PAN

MODEL = ModelPackage("a_model", "1.0")
WORDS = shipped_lexicon()


def one_word(text: str) -> Tree:
    """Give a tree of one word."""
    return Tree(text, (Node(text, 0, len(text), "NN", text, "ROOT", 0),), WORDS)


def test_a_kept_tree_is_known(tmp_path: Path) -> None:
    cache = ParseCache(tmp_path / "deep" / "parses.sqlite")
    cache.keep([PLACE_THE_PAN], MODEL)
    assert cache.known([PLACE_THE_PAN.text, "another"], MODEL, WORDS) == {PLACE_THE_PAN.text: PLACE_THE_PAN}


def test_another_model_knows_nothing_of_it(tmp_path: Path) -> None:
    cache = ParseCache(tmp_path / "parses.sqlite")
    cache.keep([PLACE_THE_PAN], MODEL)
    assert cache.known([PLACE_THE_PAN.text], ModelPackage("a_model", "1.1"), WORDS) == {}


@given(st.text(min_size=1))
def test_any_text_can_be_kept(tmp_path_factory: pytest.TempPathFactory, text: str) -> None:
    cache = ParseCache(tmp_path_factory.mktemp("cache") / "parses.sqlite")
    cache.keep([one_word(text)], MODEL)
    assert cache.known([text], MODEL, WORDS) == {text: one_word(text)}


@pytest.mark.parametrize("damage", [b"", b"no database", b"SQLite format 3\x00" + b"\xff" * 4096])
def test_a_damaged_file_is_as_an_empty_one(tmp_path: Path, damage: bytes) -> None:
    cache = ParseCache(tmp_path / "parses.sqlite")
    cache.path.write_bytes(damage)
    assert cache.known(["text"], MODEL, WORDS) == {}
    cache.keep([PLACE_THE_PAN], MODEL)
    cache.keep([PLACE_THE_PAN], MODEL)
    # Where the first could not be kept, a new file took the damaged one's place.
    assert cache.known([PLACE_THE_PAN.text], MODEL, WORDS) == {PLACE_THE_PAN.text: PLACE_THE_PAN}


@pytest.mark.parametrize(
    "row", ["", "[", "{}", "[[0]]", "[[0, 99, 1, 1, 1, 0]]", '[[0,1,"NN","p","ROOT",7]]']
)
def test_a_row_that_does_not_fit_its_text_is_not_used(tmp_path: Path, row: str) -> None:
    cache = ParseCache(tmp_path / "parses.sqlite")
    cache.keep([PLACE_THE_PAN], MODEL)
    with sqlite3.connect(cache.path) as connection:
        connection.execute("UPDATE parses SET tree = ?", (row,))
    connection.close()
    known = cache.known([PLACE_THE_PAN.text], MODEL, WORDS)
    assert known == {} or known[PLACE_THE_PAN.text].nodes == ()


def test_a_folder_that_cannot_be_written_costs_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    cache = ParseCache(tmp_path / "file" / "parses.sqlite")
    cache.keep([PLACE_THE_PAN], MODEL)
    assert cache.known([PLACE_THE_PAN.text], MODEL, WORDS) == {}


def test_many_writers_lose_nothing(tmp_path: Path) -> None:
    cache = ParseCache(tmp_path / "parses.sqlite")
    trees = [one_word(f"word{i}") for i in range(40)]
    cache.keep(trees[:1], MODEL)
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda tree: cache.keep([tree], MODEL), trees))
    assert len(cache.known([tree.text for tree in trees], MODEL, WORDS)) == 40


SCRIPT = """
import json, sys
from datetime import datetime
from pathlib import Path
from fuzzytime.language import Language, answer
reading = Language.shipped(cache=Path(sys.argv[1])).read(sys.argv[2], now=datetime(2026, 3, 4, 9))
loaded = [module for module in ("spacy", "numpy", "scipy") if module in sys.modules]
print(json.dumps({"answer": answer(reading), "modules": loaded}))
"""


@pytest.mark.model
def test_a_text_read_before_needs_no_model(tmp_path: Path) -> None:
    def run(text: str) -> dict[str, object]:
        command = [sys.executable, "-c", SCRIPT, str(tmp_path), text]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return dict(json.loads(done.stdout))

    text = "First chop the onions in about ten minutes, then fry them until they are brown"
    first, second = run(text), run(text)
    assert first["answer"] == second["answer"]
    assert "spacy" in str(first["modules"])
    assert second["modules"] == []


@pytest.mark.model
def test_a_time_alone_needs_no_model(tmp_path: Path) -> None:
    command = [sys.executable, "-c", SCRIPT, str(tmp_path), "in about ten minutes"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["modules"] == []
