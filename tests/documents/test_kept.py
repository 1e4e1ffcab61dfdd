"""What is made of documents and kept: the same comes back, and anew whenever it must."""

import os
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import pytest

from fuzzytime.documents import kept
from fuzzytime.documents.kept import MOST, Kept
from fuzzytime.language import Language, Lexicon, shipped_lexicon
from fuzzytime.rulebook import Profile, Rulebook


class Maker:
    """Makes a value of a file, and counts how often."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.times = 0

    def __call__(self) -> tuple[str, ...]:
        self.times += 1
        return tuple(self.file.read_text().split())


@pytest.fixture
def maker(tmp_path: Path) -> Maker:
    """Give a maker whose file is there."""
    file = tmp_path / "words.txt"
    file.write_text("soon later")
    return Maker(file)


def made_of(maker: Maker, folder: Path, name: str = "words") -> tuple[str, ...]:
    """Give what is kept of a maker's file."""
    return Kept(folder).made(name, [maker.file], maker)


def test_what_is_kept_is_made_once(maker: Maker, tmp_path: Path) -> None:
    assert [made_of(maker, tmp_path / "deep" / "cache") for _ in range(3)] == [("soon", "later")] * 3
    assert maker.times == 1


def test_other_contents_are_made_anew(maker: Maker, tmp_path: Path) -> None:
    made_of(maker, tmp_path)
    maker.file.write_text("now")
    assert made_of(maker, tmp_path) == ("now",)


def test_another_place_is_made_anew(maker: Maker, tmp_path: Path) -> None:
    """Explanations name the file."""
    made_of(maker, tmp_path)
    maker.file = maker.file.rename(tmp_path / "others.txt")
    assert made_of(maker, tmp_path) == ("soon", "later")
    assert maker.times == 2


def test_another_library_makes_anew(maker: Maker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made_of(maker, tmp_path)
    monkeypatch.setattr(kept, "_code_as_it_is", lambda: b"another")
    made_of(maker, tmp_path)
    assert maker.times == 2


def test_a_library_that_is_no_files_keeps_nothing(
    maker: Maker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kept, "_code_as_it_is", lambda: b"")
    assert made_of(maker, tmp_path / "cache") == ("soon", "later")
    assert not (tmp_path / "cache").exists()


def test_the_stamp_changes_with_a_module(tmp_path: Path) -> None:
    package = tmp_path / "package"
    (package / "inner").mkdir(parents=True)
    module = package / "inner" / "module.py"
    module.write_text("A = 1\n")
    before = list(kept._modules(package))
    module.write_text("A = 12\n")
    assert len(before) == 1
    assert list(kept._modules(package)) != before


@pytest.mark.parametrize(
    "damage",
    [
        b"",
        b"no JSON",
        b"\xff",
        b"{}",
        b"[]",
        b'{"kinds":[],"atoms":[],"made":[],"whole":0}',
        b'{"kinds":["tuple"],"atoms":[],"made":[[0,1]],"whole":0}',
        b'{"kinds":["os:system"],"atoms":["true"],"made":[[0,0]],"whole":1}',
        b'{"kinds":["fuzzytime.no_such:Name"],"atoms":[],"made":[[0]],"whole":0}',
    ],
)
def test_a_damaged_file_is_as_none(maker: Maker, tmp_path: Path, damage: bytes) -> None:
    folder = tmp_path / "cache"
    made_of(maker, folder)
    (file,) = folder.iterdir()
    file.write_bytes(damage)
    assert made_of(maker, folder) == ("soon", "later")
    assert made_of(maker, folder) == ("soon", "later")
    assert maker.times == 2


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="files have no owners here")
def test_what_others_may_write_is_not_read(maker: Maker, tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    made_of(maker, folder)
    (file,) = folder.iterdir()
    file.chmod(0o666)
    made_of(maker, folder)
    assert maker.times == 2
    made_of(maker, folder)
    assert maker.times == 2


def test_where_nothing_can_be_written_it_is_made(maker: Maker, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert made_of(maker, tmp_path / "file" / "cache") == ("soon", "later")


def test_what_cannot_be_written_is_made(maker: Maker, tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    made = Kept(folder).made("words", [maker.file], lambda: (maker(), lambda: None))
    assert made[0] == ("soon", "later")
    assert list(folder.iterdir()) == []


def test_a_file_that_is_not_there_is_an_error(maker: Maker, tmp_path: Path) -> None:
    maker.file.unlink()
    with pytest.raises(FileNotFoundError):
        made_of(maker, tmp_path)


def test_the_oldest_go(maker: Maker, tmp_path: Path) -> None:
    folder = tmp_path / "cache"
    made_of(maker, folder, "others")
    for number in range(MOST + 3):
        maker.file.write_text(f"w{number}")
        made_of(maker, folder)
    assert len(list(folder.glob("words-*"))) == MOST
    assert len(list(folder.glob("others-*"))) == 1
    times = maker.times
    made_of(maker, folder)
    assert maker.times == times


def test_words_and_rules_come_back_as_they_were_read(tmp_path: Path) -> None:
    for _ in range(2):
        # The shipped tables are remembered for a folder: another way to write it is as another program.
        for folder in (tmp_path, tmp_path / ".." / tmp_path.name):
            read = Language.shipped(cache=folder).lexicon
            for table in fields(Lexicon):
                assert getattr(read, table.name) == getattr(shipped_lexicon(), table.name), table.name
            for profile in Profile:
                assert Rulebook.shipped(profile, cache=folder).tables == Rulebook.shipped(profile).tables


def test_the_next_start_parses_no_yaml(tmp_path: Path) -> None:
    code = (
        "import sys, pathlib; from fuzzytime.language import Language; "
        "folder = pathlib.Path(sys.argv[1]); found = Language.shipped(cache=folder).lexicon.names; "
        "print('yaml' in sys.modules, len(found))"
    )
    said = [
        subprocess.run(
            [sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True
        ).stdout.split()
        for _ in range(2)
    ]
    assert [parsed for parsed, _ in said] == ["True", "False"]
    assert said[0][1] == said[1][1] != "0"
