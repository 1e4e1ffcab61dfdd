import os
import shutil
import sqlite3
import stat
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import Answers, AnswerStore, Design, Origin


@pytest.fixture
def store(tmp_path: Path, design: Design) -> Iterator[AnswerStore]:
    with AnswerStore.create(tmp_path / "answers.sqlite", design) as store:
        yield store


def test_answers_come_back_as_they_were_saved(store: AnswerStore, answers: Answers, tmp_path: Path) -> None:
    some = answers.participants[:3]
    assert store.add([some[0], replace(some[1], excluded="joked"), some[2]], "2026-03-04") == 3
    store.close()
    with AnswerStore.open(tmp_path / "answers.sqlite") as again:
        assert again.design.instructions == answers.design.instructions
        for saved, meant in zip(again.answers().participants, some, strict=True):
            assert {key: curve.tolist() for key, curve in saved.curves.items()} == {
                key: curve.tolist() for key, curve in meant.curves.items()
            }
            assert (saved.name, saved.group, saved.order) == (meant.name, meant.group, meant.order)
            assert (saved.demographics, saved.control) == (meant.demographics, meant.control)
            assert (saved.origin, saved.finished) == (Origin.SIMULATED, True)
        assert again.answers().participants[1].excluded == "joked"


def test_a_participant_who_joins_is_carried_to_the_end(store: AnswerStore) -> None:
    person = store.join("p1", "2026-03-04T09:00")
    assert not person.finished
    assert sorted(person.order) == sorted(entry.key for entry in store.design.instructions)
    store.save_demographics("p1", {"age": "31", "gender": ""})
    store.save_demographics("p1", {"age": "32", "gender": ""})
    curve = np.linspace(0, 1, 800)
    store.save_curve("p1", "soon", np.zeros(800), "t")
    store.save_curve("p1", "soon", curve, "t")
    store.save_control("p1", 2)
    store.finish("p1")
    found = store.participant("p1")
    assert found.demographics == {"age": "32"}
    assert (found.curves["soon"] == curve).all()
    assert found.control == 2
    assert found.finished
    assert store.answers().participants[0].order == person.order


def test_groups_stay_of_one_size(store: AnswerStore) -> None:
    groups = [store.join(f"p{i}", "").group for i in range(9)]
    for count in range(2, 10, 2):
        assert groups[:count].count("robot") == count // 2


def test_orders_differ_between_participants_and_can_be_repeated(tmp_path: Path, design: Design) -> None:
    with (
        AnswerStore.create(tmp_path / "a.sqlite", design) as one,
        AnswerStore.create(tmp_path / "b.sqlite", design) as other,
    ):
        assert one.join("x", "").order == other.join("x", "").order != one.join("y", "").order


def test_what_cannot_be_saved_is_refused_and_nothing_changes(store: AnswerStore, answers: Answers) -> None:
    store.join("p1", "")
    refused: list[Callable[[], object]] = [
        lambda: store.save_curve("p1", "soon", np.full(800, 1.01), ""),
        lambda: store.save_curve("p1", "soon", np.full(800, np.nan), ""),
        lambda: store.save_curve("p1", "soon", np.zeros(799), ""),
        lambda: store.save_curve("p1", "soon", ["x"] * 800, ""),
        lambda: store.save_curve("p1", "later", np.zeros(800), ""),
        lambda: store.save_curve("p2", "soon", np.zeros(800), ""),
        lambda: store.save_control("p1", 0),
        lambda: store.save_control("p1", 6),
        lambda: store.save_demographics("p1", {"age": "3"}),
        lambda: store.save_demographics("p1", {"income": "3"}),
        lambda: store.exclude("p1", " "),
        lambda: store.exclude("p2", "why"),
        lambda: store.finish("p2"),
        lambda: store.participant("p2"),
        lambda: store.add([answers.participants[0], answers.participants[0]]),
        lambda: store.add([replace(answers.participants[0], group="dog")]),
        lambda: store.add([replace(answers.participants[0], control=9)]),
    ]
    for attempt in refused:
        with pytest.raises(FuzzytimeError):
            attempt()
    (person,) = store.answers().participants
    assert person.name == "p1"
    assert not person.curves


def test_excluding_can_be_taken_back(store: AnswerStore) -> None:
    store.join("p1", "")
    store.exclude("p1", "test run")
    assert store.participant("p1").excluded == "test run"
    store.exclude("p1", None)
    assert store.participant("p1").excluded is None


def test_a_study_keeps_its_design(tmp_path: Path, design: Design) -> None:
    path = tmp_path / "answers.sqlite"
    AnswerStore.create(path, design).close()
    AnswerStore.create(path, design).close()
    with pytest.raises(FuzzytimeError, match="keeps its design"):
        AnswerStore.create(path, Design.of_text(design.yaml + "# another"))


def test_what_is_no_study_is_refused_and_left_alone(tmp_path: Path, design: Design) -> None:
    with pytest.raises(FileNotFoundError):
        AnswerStore.open(tmp_path / "none.sqlite")
    text = tmp_path / "text.sqlite"
    text.write_text("these are not answers " * 100)
    empty = tmp_path / "empty.sqlite"
    empty.touch()
    other = tmp_path / "other.sqlite"
    with sqlite3.connect(other) as connection:
        connection.execute("CREATE TABLE recipes (name TEXT)")
    connection.close()
    for path in (text, empty, other):
        before = path.read_bytes()
        with pytest.raises(FuzzytimeError, match=r"\.sqlite holds"):
            AnswerStore.open(path)
        assert path.read_bytes() == before
    for path in (text, other):
        with pytest.raises(FuzzytimeError, match=r"\.sqlite holds"):
            AnswerStore.create(path, design)
    with pytest.raises(OSError, match="directory"):
        AnswerStore.open(tmp_path)


def test_a_later_version_is_not_guessed_at(tmp_path: Path, design: Design) -> None:
    path = tmp_path / "answers.sqlite"
    AnswerStore.create(path, design).close()
    with sqlite3.connect(path) as connection:
        connection.execute("PRAGMA user_version = 99")
    connection.close()
    with pytest.raises(FuzzytimeError, match="later version"):
        AnswerStore.open(path)


def test_an_archived_study_can_be_read_where_nothing_can_be_written(
    tmp_path: Path, design: Design, answers: Answers, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "archive"
    folder.mkdir()
    with AnswerStore.create(folder / "answers.sqlite", design) as store:
        store.add(answers.participants[:2])
    (folder / "answers.sqlite").chmod(stat.S_IREAD)
    # The superuser may write everywhere, whatever a file's mode says.
    monkeypatch.setattr(os, "access", lambda _path, _mode: False)
    before = sorted(entry.name for entry in folder.iterdir())
    with AnswerStore.open(folder / "answers.sqlite") as archived:
        assert len(archived.answers().participants) == 2
        with pytest.raises(OSError, match="readonly"):
            archived.join("p1", "")
    assert sorted(entry.name for entry in folder.iterdir()) == before


def test_a_file_copied_while_the_page_is_open_is_not_read_without_its_log(
    tmp_path: Path, design: Design, monkeypatch: pytest.MonkeyPatch
) -> None:
    with AnswerStore.create(tmp_path / "answers.sqlite", design) as store:
        store.join("p1", "")
        for part in ("answers.sqlite", "answers.sqlite-wal"):
            shutil.copy(tmp_path / part, tmp_path / part.replace("answers", "copied"))
    monkeypatch.setattr(os, "access", lambda _path, _mode: False)
    with pytest.raises(FuzzytimeError, match=r"copied\.sqlite-wal"):
        AnswerStore.open(tmp_path / "copied.sqlite")


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        ("UPDATE curves SET samples = zeroblob(80) WHERE instruction = 'soon'", "must have 800 samples"),
        ("UPDATE curves SET samples = zeroblob(81) WHERE instruction = 'soon'", "buffer size"),
        ("UPDATE curves SET samples = 'text' WHERE instruction = 'soon'", "bytes-like"),
        (
            "UPDATE curves SET instruction = 'later' WHERE instruction = 'soon'",
            "an instruction must be one of",
        ),
        ("UPDATE participants SET instructions = '3'", "not iterable"),
        ("UPDATE participants SET instructions = '[1]'", "an instruction must be one of"),
        ("UPDATE participants SET instructions = '['", "Expecting value"),
        ("UPDATE participants SET actor = 'dog'", "a group must be one of robot, person"),
        ("UPDATE participants SET control = 77", "the answer must be one of 1 to 5"),
        ("UPDATE participants SET control = 'often'", "invalid literal"),
        ("UPDATE participants SET origin = 'dream'", "'dream' is not a valid Origin"),
        ("UPDATE demographics SET question = 'income' WHERE question = 'age'", "there is no question"),
    ],
)
def test_what_another_hand_wrote_into_the_file_is_said(
    tmp_path: Path, answers: Answers, change: str, rule: str
) -> None:
    path = tmp_path / "answers.sqlite"
    with AnswerStore.create(path, answers.design) as store:
        store.add(answers.participants[:2])
    with sqlite3.connect(path) as connection:
        connection.execute(change)
    connection.close()
    with AnswerStore.open(path) as store, pytest.raises(FuzzytimeError, match=f"participant 's.*{rule}"):
        store.answers()
