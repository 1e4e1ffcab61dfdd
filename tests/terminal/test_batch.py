"""Many files: answers in order, errors beside them, wherever the work is done, however often it ends."""

import io
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from console import ROOT, environment
from fuzzytime_cli import patience as waiting
from fuzzytime_cli.batch import backends, start
from fuzzytime_cli.batch.answers import Job, Recipe, recipe_of
from fuzzytime_cli.batch.backends import WINDOW, Workers
from fuzzytime_cli.batch.files import task_files
from fuzzytime_cli.choices import BatchBackend
from fuzzytime_cli.exits import Exit
from terminal.running import ran

pytestmark = pytest.mark.model

NOW = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")
SCHEMAS = ROOT / "cli" / "fuzzytime_cli" / "schema"
ANSWER = jsonschema.Draft202012Validator(json.loads((SCHEMAS / "batch-1.json").read_text()))
PLAN = jsonschema.Draft202012Validator(json.loads((SCHEMAS / "plan-1.json").read_text()))

Json = dict[str, Any]


def answers_of(text: str) -> list[Json]:
    answers = [json.loads(line) for line in text.splitlines()]
    for answer in answers:
        ANSWER.validate(answer)
        if "plan" in answer:
            PLAN.validate(answer["plan"])
            answer["plan"]["certificate"].pop("seconds")
    return answers


def until(happened: Callable[[], object], patience: float = 120.0) -> None:
    """Wait for what happens beside the test; that it never does is an error."""
    deadline = time.monotonic() + patience
    while not happened():
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(0.01)


def lines_of(path: Path) -> list[bytes]:
    """Give the whole lines of a file; none where it is not there yet."""
    lines = path.read_bytes().splitlines(keepends=True) if path.exists() else []
    return [line for line in lines if line.endswith(b"\n")]


def tasks(folder: Path, count: int) -> Path:
    folder.mkdir()
    for number in range(count):
        minutes = number + 2
        (folder / f"{number:03}.txt").write_text(f"Stir the soup in {minutes} minutes\nSet the table soon\n")
    return folder


# -- which files --------------------------------------------------------------------------------------------


def test_a_folder_s_task_files_are_found_and_nothing_else(tmp_path: Path) -> None:
    for name in ("b.txt", "a/c.YAML", "a/b.yml", ".git/x.txt", "readme.md", "fuzzytime.yaml", "a/.x.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    found = task_files([tmp_path / "b.txt", tmp_path])
    assert [str(path.relative_to(tmp_path)) for path in found] == ["b.txt", "a/b.yml", "a/c.YAML"]


# -- answers ------------------------------------------------------------------------------------------------


def test_a_link_that_leads_nowhere_is_named_and_not_passed_over(tmp_path: Path) -> None:
    (tmp_path / "soup.txt").write_text("Stir the soup soon\n")
    (tmp_path / "gone.txt").symlink_to(tmp_path / "nosuch")
    done = ran("batch", str(tmp_path), "--jobs", "1", *NOW, folder=tmp_path)
    gone, soup = answers_of(done.out)
    assert gone["error"]["code"] == Exit.NO_INPUT
    assert "plan" in soup


def test_an_answer_is_what_plan_says(tmp_path: Path) -> None:
    done = ran(
        "batch", "examples/workshop.yaml", "examples/breakfast.txt", "--jobs", "1", *NOW, folder=tmp_path
    )
    assert (done.code, done.err) == (Exit.FINE, "")
    workshop, breakfast = answers_of(done.out)
    for answer, name in ((workshop, "workshop.yaml"), (breakfast, "breakfast.txt")):
        plan = json.loads(ran("plan", f"examples/{name}", "--format", "json", *NOW, folder=tmp_path).out)
        plan["certificate"].pop("seconds")
        assert answer["plan"] == plan


def test_errors_stand_beside_results(tmp_path: Path) -> None:
    good = tmp_path / "good.txt"
    good.write_text("Stir the soup soon")
    data = [f"tests/data/{name}" for name in ("binary.bin", "broken.yaml", "empty.txt", "comments.txt")]
    nothing = tmp_path / "nothing.txt"
    nothing.write_text("in ten minutes")
    done = ran("batch", *data, "missing.txt", str(nothing), str(good), "--jobs", "1", *NOW, folder=tmp_path)
    answers = answers_of(done.out)
    assert [answer.get("error", {}).get("code") for answer in answers] == [65, 65, 66, 66, 66, 65, None]
    assert "says a time but nothing to do" in answers[5]["error"]["message"]
    assert done.code == Exit.FINE
    assert "6 of 7 files could not be planned (tests/data/binary.bin, tests/data/broken.yaml" in done.err
    assert "tests/data/comments.txt and 2 more): see their 'error'" in done.err
    strict = ran("batch", *data, str(good), "--strict", "--jobs", "1", *NOW, folder=tmp_path)
    assert strict.code == Exit.BAD_DATA


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ((), Exit.USAGE),
        (("cli",), Exit.NO_INPUT),
        (("missing.txt", "--jobs", "1"), Exit.NO_INPUT),
        (("tests/data/binary.bin", "--jobs", "1"), Exit.BAD_DATA),
        (("examples", "--resume"), Exit.USAGE),
        (("examples", "--scheduler", "tcp://127.0.0.1:1"), Exit.USAGE),
        (("examples", "--backend", "dask"), Exit.USAGE),
        (("examples", "-o", "no/such/folder/answers.jsonl"), Exit.IO_ERROR),
        (("examples", "-o", "tests/data/comments.txt", "--resume"), Exit.BAD_DATA),
    ],
)
def test_an_end_has_its_code(arguments: tuple[str, ...], code: Exit, tmp_path: Path) -> None:
    done = ran("batch", *arguments, *NOW, folder=tmp_path)
    assert done.code == code, done.err
    assert done.err
    assert "Traceback" not in done.err


# -- wherever -----------------------------------------------------------------------------------------------


def recipe() -> Recipe:
    from fuzzytime_cli.assembly import Assembly
    from fuzzytime_cli.options import Moment, Solving, Understanding

    understanding = Understanding()
    return recipe_of(Assembly.of(Moment(now="2026-03-04T09:00"), understanding, Solving()), understanding)


@pytest.mark.parametrize("backend", [BatchBackend.LOKY, BatchBackend.THREADING])
def test_processes_and_threads_answer_the_same_in_order(backend: BatchBackend, tmp_path: Path) -> None:
    folder = tasks(tmp_path / "tasks", 5)
    alone, together = (
        answers_of(ran("batch", str(folder), *how, *NOW, folder=tmp_path).out)
        for how in (("--jobs", "1"), ("--jobs", "2", "--backend", backend.value))
    )
    assert [Path(answer["file"]).stem for answer in together] == ["000", "001", "002", "003", "004"]
    assert together == alone


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_dask_cluster_answers_the_same(tmp_path: Path) -> None:
    from distributed import LocalCluster

    folder = tasks(tmp_path / "tasks", 3)
    alone = answers_of(ran("batch", str(folder), "--jobs", "1", *NOW, folder=tmp_path).out)
    variables = {name: environment(tmp_path)[name] for name in ("PYTHONPATH", "FUZZYTIME_CACHE")}
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None, env=variables) as cluster:
        address = ("--backend", "dask", "--scheduler", cluster.scheduler_address)
        done = ran("batch", str(folder), *address, *NOW, folder=tmp_path)
    assert (done.code, done.err) == (Exit.FINE, "")
    assert answers_of(done.out) == alone


@pytest.mark.filterwarnings("ignore")
def test_a_ray_cluster_answers_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cluster_utils = pytest.importorskip("ray.cluster_utils", reason="Ray is not installed: it is not tried")
    folder = tasks(tmp_path / "tasks", 3)
    (folder / "001.txt").write_text("in ten minutes")
    alone = ran("batch", str(folder), "--jobs", "1", *NOW, folder=tmp_path)
    beside = os.environ.get("PYTHONPATH", "")
    monkeypatch.setenv("PYTHONPATH", environment(tmp_path)["PYTHONPATH"] + os.pathsep + beside)
    cluster = cluster_utils.Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
    try:
        address = ("--backend", "ray", "--scheduler", cluster.address)
        done = ran("batch", str(folder), *address, *NOW, folder=tmp_path)
    finally:
        cluster.shutdown()
    assert (done.code, done.err) == (Exit.FINE, alone.err)
    assert answers_of(done.out) == answers_of(alone.out)


def echo(job: Job, recipe: Recipe) -> str:
    """In the place of `answer`: the file's name; one that is called deadly ends its process."""
    del recipe
    if job.name == "deadly":
        os.kill(os.getpid(), signal.SIGKILL)
    return job.name


def test_few_files_are_in_memory_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backends, "answer", echo)
    read = 0

    def jobs() -> Iterator[Job]:
        nonlocal read
        for number in range(3 * WINDOW):
            read += 1
            yield Job(str(number))

    answers = Workers(BatchBackend.THREADING, 2).answers(jobs(), recipe())
    for number in range(3 * WINDOW):
        assert next(answers) == str(number)
        assert read <= number + 1 + WINDOW
    assert next(answers, None) is None


def test_a_worker_that_is_lost_costs_one_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backends, "answer", echo)
    jobs = [Job("a"), Job("deadly"), Job("b")]
    first, lost, last = Workers(BatchBackend.LOKY, 2).answers(jobs, recipe())
    assert (first, last) == ("a", "b")
    assert json.loads(lost)["error"]["code"] == Exit.FAILURE


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(("patience", "words"), [(3600.0, ""), (0.0, "1 failed")])
def test_progress_is_shown_on_a_terminal_once_it_takes_a_while(
    patience: float, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    terminal = Terminal()
    monkeypatch.setattr(waiting, "AFTER", patience)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(sys, "stdout", io.StringIO())
    with start.progress(3) as show:
        show(start.Tally(answered=1, failed=1))
        until(lambda: words in terminal.getvalue())
        show(start.Tally(answered=2, failed=1))
    assert bool(terminal.getvalue()) == bool(words)


@pytest.mark.parametrize(
    ("patience", "term", "words"), [(3600.0, "xterm", ""), (0.0, "dumb", ""), (0.0, "xterm", "planning")]
)
def test_what_takes_a_while_is_told_on_a_terminal_and_taken_back(
    patience: float, term: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    terminal = Terminal()
    monkeypatch.setattr(waiting, "AFTER", patience)
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setenv("TERM", term)
    with waiting.told("planning 3 instructions"):
        until(lambda: words in terminal.getvalue())
    shown = terminal.getvalue()
    assert bool(shown) == bool(words)
    assert not shown or shown.rindex("planning") < shown.rindex("\x1b[2K")


def test_one_who_stops_it_keeps_what_was_answered(tmp_path: Path) -> None:
    folder, output = tasks(tmp_path / "tasks", 200), tmp_path / "answers.jsonl"
    with subprocess.Popen(
        [
            sys.executable,
            "-m",
            "fuzzytime_cli",
            "batch",
            str(folder),
            "--jobs",
            "2",
            "-o",
            str(output),
            *NOW,
        ],
        cwd=ROOT,
        env=environment(tmp_path),
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        until(lambda: lines_of(output))
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert (process.returncode, errors) == (Exit.INTERRUPT, "")
    assert 1 <= len(answers_of(output.read_text())) < 200


# -- resumed ------------------------------------------------------------------------------------------------


def test_a_batch_that_was_killed_goes_on_where_it_was(tmp_path: Path) -> None:
    files, output = sorted(tasks(tmp_path / "tasks", 5).iterdir()), tmp_path / "answers.jsonl"
    third = files[2].read_text()
    files[2].unlink()
    os.mkfifo(files[2])  # nobody writes into it: there the batch waits
    arguments = ("batch", *map(str, files), "--jobs", "1", *NOW)
    process = subprocess.Popen(
        [sys.executable, "-m", "fuzzytime_cli", *arguments, "-o", str(output)],
        cwd=ROOT,
        env=environment(tmp_path),
    )
    until(lambda: len(lines_of(output)) == 2)
    process.kill()
    process.wait()
    kept = lines_of(output)
    files[2].unlink()
    files[2].write_text(third)
    with output.open("ab") as stream:
        stream.write(b'{"schema": "fuzzytime-batch/1", "file')
    done = ran(*arguments, "-o", str(output), "--resume", folder=tmp_path)
    assert (done.code, done.out) == (Exit.FINE, "")
    assert "2 of 5 files were answered before" in done.err
    assert lines_of(output)[:2] == kept
    fresh = ran(*arguments, folder=tmp_path)
    assert answers_of(output.read_text()) == answers_of(fresh.out)


def test_only_what_changed_is_planned_again_and_order_is_kept(tmp_path: Path) -> None:
    folder, output = tasks(tmp_path / "tasks", 3), tmp_path / "answers.jsonl"
    arguments = ("batch", str(folder), "--jobs", "1", "-o", str(output))
    ran(*arguments, *NOW, folder=tmp_path)
    before = output.read_text().splitlines()
    (folder / "001.txt").write_text("Feed the cat now")
    (folder / "0000.txt").write_text("Wash the pan now")
    done = ran(*arguments, *NOW, "--resume", folder=tmp_path)
    assert "2 of 4 files were answered before" in done.err
    after = output.read_text().splitlines()
    assert [Path(answer["file"]).stem for answer in answers_of(output.read_text())] == [
        "000",
        "0000",
        "001",
        "002",
    ]
    assert (after[0], after[3]) == (before[0], before[2])
    assert "feed the cat" in after[2]
    assert (
        "were answered before" not in ran(*arguments, *NOW, "--resume", "--agents", "2", folder=tmp_path).err
    )


def test_what_is_no_file_of_answers_is_left_as_it_is(tmp_path: Path) -> None:
    precious = tmp_path / "precious.txt"
    precious.write_text("not to be lost\n")
    done = ran("batch", "examples", "-o", str(precious), "--resume", *NOW, folder=tmp_path)
    assert "precious.txt:1:1: to resume, a file must hold nothing but" in done.err
    assert precious.read_text() == "not to be lost\n"
