"""The study's commands, as a shell runs them."""

import json
import re
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from console import ROOT, environment
from fuzzytime.rulebook import check
from fuzzytime.study import Design
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.study.collecting import new_name
from terminal.running import Ran, ran

Run = Callable[..., Ran]


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Runs `fuzzytime study` with some words."""
    folder = tmp_path_factory.mktemp("home")
    return lambda *words, stdin=b"": ran("study", *map(str, words), folder=folder, stdin=stdin)


@pytest.fixture(scope="module")
def fine(run: Run) -> Run:
    """Runs `fuzzytime study` with some words, by which it must end well."""

    def checked(*words: object) -> Ran:
        done = run(*words)
        assert done.code == Exit.FINE, done.err
        return done

    return checked


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The paper's design with the four plain instructions with "in", which is quicker to analyse."""
    lines = (ROOT / "rules/study/sucker2024.yaml").read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if not line.startswith(("  after", "  before", "  soon", "  in-about"))]
    path = tmp_path_factory.mktemp("design") / "small.yaml"
    path.write_text("\n".join(kept), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def simulated(fine: Run, tmp_path_factory: pytest.TempPathFactory, small: Path) -> Path:
    path = tmp_path_factory.mktemp("study") / "answers.sqlite"
    assert fine("simulate", "--participants", 8, "--seed", 1, "--db", path, "--design", small).out == ""
    return path


def test_participants_are_listed_with_what_became_of_them(fine: Run, simulated: Path) -> None:
    lines = fine("list", simulated).out.splitlines()
    assert lines[0].split() == ["participant", "group", "origin", "state", "curves"]
    assert sum("counts" in line for line in lines[1:9]) == 8
    assert lines[-1] == "sucker2024: 8 participants (4 robot, 4 person) count, 0 set aside"
    rows = [json.loads(line) for line in fine("list", simulated, "--json").out.splitlines()]
    assert len(rows) == 8
    assert rows[0]["curves"] == 4
    assert rows[0]["set_aside"] is None


def test_a_participant_is_excluded_and_taken_back(fine: Run, run: Run, simulated: Path) -> None:
    fine("exclude", simulated, "s1-002", "--reason", "joked \x1b[31m")
    line = fine("list", simulated).out.splitlines()[2]
    assert "excluded: joked \\x1b[31m" in line
    assert "7 participants" in fine("analyse", simulated, "--permutations", 9).out
    fine("exclude", simulated, "s1-002", "--undo")
    assert "0 set aside" in fine("list", simulated).out
    nobody = run("exclude", simulated, "nobody", "--reason", "x")
    assert (nobody.code, nobody.err) == (Exit.BAD_DATA, "fuzzytime: there is no participant 'nobody'\n")
    assert run("exclude", simulated, "s1-002").code == Exit.USAGE


def test_the_analysis_is_a_summary_or_json(fine: Run, simulated: Path) -> None:
    text = fine("analyse", simulated, "--permutations", 9).out
    for word in ("F1", "F2", "F3", "person against robot", "caution"):
        assert word in text
    assert all(len(line) <= 80 for line in text.splitlines())
    document = json.loads(fine("analyse", simulated, "--json", "--permutations", 9).out)
    assert document["participants"]["counted"] == 8


def test_the_report_is_a_folder_of_page_plots_and_numbers(fine: Run, simulated: Path, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="matplotlib is not installed: no figure is drawn")
    fine("analyse", simulated, "--out", tmp_path / "report", "--permutations", 9)
    names = {path.name for path in (tmp_path / "report").iterdir()}
    own = {"instruction-in-30.svg", "instruction-in-30.png"}
    assert {"report.html", "numbers.json", "fits.svg", "fits.png", *own} <= names
    without = tmp_path / "without"
    fine("analyse", simulated, "--out", without, "--no-plots", "--permutations", 9)
    assert {path.name for path in without.iterdir()} == {"report.html", "numbers.json"}


def test_a_report_without_matplotlib_has_no_figures(
    fine: Run, simulated: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    done = fine("analyse", simulated, "--out", tmp_path, "--permutations", 9)
    assert "plots need matplotlib" in done.err
    assert {path.name for path in tmp_path.iterdir()} == {"report.html", "numbers.json"}


def test_a_calibrated_table_is_checked_and_written(fine: Run, simulated: Path, tmp_path: Path) -> None:
    text = fine("calibrate", simulated).out
    assert text.startswith("# Rules calibrated")
    fine("calibrate", simulated, "-o", tmp_path / "mine.yaml")
    assert (tmp_path / "mine.yaml").read_text(encoding="utf-8") == text
    assert check([tmp_path / "mine.yaml"]) == ()


def test_answers_go_out_and_come_back(
    fine: Run, run: Run, simulated: Path, small: Path, tmp_path: Path
) -> None:
    for form in ("csv", "json"):
        text = fine("export", simulated, f"--{form}").out
        (tmp_path / f"answers.{form}").write_text(text, encoding="utf-8", newline="")
        fine("import", tmp_path / f"answers.{form}", "--db", tmp_path / f"{form}.sqlite", "--design", small)
        assert fine("export", tmp_path / f"{form}.sqlite", f"--{form}").out == text
    fine("export", simulated, "-o", tmp_path / "again.csv")
    assert (tmp_path / "again.csv").read_bytes() == (tmp_path / "answers.csv").read_bytes()
    assert run("export", simulated, "--csv", "--json").code == Exit.USAGE
    twice = run("import", tmp_path / "answers.csv", "--db", tmp_path / "csv.sqlite")
    assert twice.code == Exit.BAD_DATA
    assert "must differ, and 's1-001' is already in " in twice.err


def test_a_study_that_is_there_goes_on_with_its_own_design(
    fine: Run, run: Run, small: Path, tmp_path: Path
) -> None:
    path = tmp_path / "answers.sqlite"
    fine("simulate", "--participants", 2, "--db", path, "--design", small)
    fine("simulate", "--participants", 2, "--seed", 2, "--db", path)
    assert len(fine("list", path, "--json").out.splitlines()) == 4
    other = tmp_path / "other.yaml"
    other.write_text(small.read_text(encoding="utf-8") + "# changed\n", encoding="utf-8")
    refused = run("simulate", "--participants", 2, "--seed", 3, "--db", path, "--design", other)
    assert "was begun with another version of 'sucker2024'" in refused.err


def test_answers_come_from_a_pipe(fine: Run, run: Run, simulated: Path, small: Path, tmp_path: Path) -> None:
    text = fine("export", simulated).out
    database = tmp_path / "piped.sqlite"
    assert run("import", "-", "--db", database, "--design", small, stdin=text.encode()).code == Exit.FINE
    assert fine("export", database).out == text


def test_the_truth_may_be_a_rule_table_or_written_for_each_instruction(
    fine: Run, run: Run, small: Path, tmp_path: Path
) -> None:
    (tmp_path / "wide.yaml").write_text("fuzzytime: 1\nwidth: {base: 300 s, growth: 0.1}\n")
    keys = [entry.key for entry in Design.of_file(small).instructions]
    plain = "".join(f"{key}: {{rectangle: [0 s, 40 min]}}\n" for key in keys)
    (tmp_path / "plain.yaml").write_text(plain)
    variances = {}
    for name in ("wide", "plain"):
        fine(
            "simulate",
            "--design",
            small,
            "--db",
            tmp_path / f"{name}.sqlite",
            "--participants",
            6,
            "--truth",
            tmp_path / f"{name}.yaml",
        )
        numbers = json.loads(fine("analyse", tmp_path / f"{name}.sqlite", "--json", "--permutations", 9).out)
        variances[name] = {key: entry["variance_min2"] for key, entry in numbers["instructions"].items()}
    # A trapezoid with half-base w and half-plateau 0.4 w has the variance (1 + 0.16) w² / 6.
    assert variances["wide"]["in-30"] == pytest.approx(1.16 * 8**2 / 6, rel=0.1)
    assert variances["plain"]["in-30"] == pytest.approx(40**2 / 12, rel=0.05)
    (tmp_path / "part.yaml").write_text("in-1: {rectangle: [0 s, 1 min]}\n")
    part = tmp_path / "part.yaml"
    missing = run("simulate", "--design", small, "--db", tmp_path / "x.sqlite", "--truth", part)
    assert missing.code == Exit.BAD_CONFIG
    assert "missing key 'in-now'" in missing.err


def test_groups_may_be_given_widths_by_a_factor_or_by_the_tables_actors(
    fine: Run, small: Path, tmp_path: Path
) -> None:
    def ratio(*more: object) -> float:
        path = tmp_path / f"{len(list(tmp_path.iterdir()))}.sqlite"
        fine("simulate", "--design", small, "--db", path, "--participants", 16, *more)
        groups = json.loads(fine("analyse", path, "--json", "--permutations", 9).out)["instructions"][
            "in-30"
        ]["groups"]
        return float(groups["person"]["variance_min2"] / groups["robot"]["variance_min2"])

    assert ratio("--group-effect", 2) == pytest.approx(4, rel=0.35)
    # The study's 1.805 and 1.171 min².
    assert ratio("--by-actor", "--individual", 0) == pytest.approx(1.805 / 1.171, rel=0.1)


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        ("list none", Exit.NO_INPUT, "none: there is no such study"),
        ("analyse none", Exit.NO_INPUT, "none: there is no such study"),
        ("calibrate none", Exit.NO_INPUT, "none: there is no such study"),
        ("export none", Exit.NO_INPUT, "none: there is no such study"),
        ("exclude none x --reason y", Exit.NO_INPUT, "none: there is no such study"),
        ("list {folder}", Exit.NO_INPUT, "there is no such study"),
        ("list README.md", Exit.BAD_DATA, "README.md"),
        ("import none --db {new}", Exit.NO_INPUT, "none: there is no such file"),
        ("import {folder} --db {new}", Exit.NO_INPUT, "must be a file"),
        ("import tests/data/empty.txt --db {new}", Exit.NO_INPUT, "it is empty"),
        ("import tests/data/latin1.txt --db {new}", Exit.BAD_DATA, "text must be UTF-8"),
        (
            "import README.md --db {new}",
            Exit.BAD_DATA,
            "README.md:1:1: a file of answers must have the column",
        ),
        ("simulate --db {new} --truth none", Exit.NO_INPUT, "none: there is no such truth"),
        ("simulate --db {new} --truth tests/data/mistakes.yaml", Exit.BAD_CONFIG, "mistakes.yaml:"),
        ("simulate --db {new} --design none", Exit.NO_INPUT, "none: there is no such design"),
        ("simulate --db {new} --design tests/data/broken.yaml", Exit.BAD_CONFIG, "broken.yaml:"),
        ("simulate --db {new} --participants 0", Exit.USAGE, "--participants"),
        ("simulate", Exit.USAGE, "--db"),
        ("simulate --db no/such/folder/x", Exit.IO_ERROR, "no/such/folder/x: "),
        ("serve --db {new} --name a/b", Exit.USAGE, "--name: a name must be a host"),
        ("serve none --db {new}", Exit.NO_INPUT, "none: there is no such design"),
        ("analyse none --resamples 5", Exit.USAGE, "--resamples must be 0 or at least 20, got 5"),
        ("nonsense", Exit.USAGE, "nonsense"),
    ],
)
def test_bad_input_has_one_clear_message_and_its_code(
    run: Run, tmp_path: Path, words: str, code: Exit, said: str
) -> None:
    done = run(*(word.format(folder=tmp_path, new=tmp_path / "new.sqlite") for word in words.split()))
    assert (done.code, done.out) == (code, "")
    assert said in done.err
    assert "Traceback" not in done.err
    assert list(tmp_path.iterdir()) == []


def test_an_address_that_is_taken_is_said(run: Run, tmp_path: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        done = run("serve", "--db", tmp_path / "a.sqlite", "--port", port)
    assert done.code == Exit.IO_ERROR
    assert f"127.0.0.1:{port}: " in done.err


def test_half_hearted_answers_are_warned_of_on_the_whole_road(fine: Run, tmp_path: Path) -> None:
    truth = tmp_path / "truth.yaml"
    half = "{points: [[0 s, 0.4], [40 min, 0.4], [45 min, 0]]}"
    truth.write_text("".join(f"{entry.key}: {half}\n" for entry in Design.shipped().instructions))
    database = tmp_path / "half.sqlite"
    fine("simulate", "--db", database, "--participants", 4, "--truth", truth)
    said = fine("analyse", database, "--permutations", 9, "--no-plots", "--out", tmp_path / "report").out
    assert "caution: a trapezoid fits the median badly (R² below 0.9) for: in-now" in said
    cautions = said[said.index("caution: a") : said.index("F1")]
    assert max(map(len, cautions.splitlines())) <= 80
    page = (tmp_path / "report" / "report.html").read_text()
    assert "A trapezoid fits the median badly" in page
    table = fine("calibrate", database, "-o", tmp_path / "half.yaml")
    assert "caution: a trapezoid fits the median badly" in table.err


def test_a_participants_name_is_a_word_to_shells_and_no_number_to_spreadsheets() -> None:
    names = {new_name() for _ in range(200)}
    assert len(names) == 200
    assert all(re.fullmatch(r"p-[0-9a-f]{16}", name) for name in names)


def test_the_page_is_served_until_it_is_stopped_and_keeps_its_token(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "fuzzytime_cli", "study"]
    addresses = []
    for _ in range(2):
        with subprocess.Popen(
            [*command, "serve", "--db", str(tmp_path / "a.sqlite"), "--port", "0"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment(tmp_path),
            cwd=ROOT,
        ) as process:
            assert process.stdout is not None
            assert process.stderr is not None
            addresses.append(process.stdout.readline().strip())
            process.send_signal(signal.SIGTERM)
            said = process.stderr.read()
            assert process.wait(timeout=20) == 0
        assert "stopped, with 0 participants" in said
    tokens = {address.partition("?token=")[2] for address in addresses}
    assert len(tokens) == 1
    assert len(tokens.pop()) >= 20
    assert all(address.startswith("http://127.0.0.1:") for address in addresses)
