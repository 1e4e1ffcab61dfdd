"""What the command writes is read by the tools that people read such files with: jq, pandas, a browser."""

import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from terminal.running import ran

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.model

NOW = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")
TYPED = 'Paint the <b>"door"</b> & <script>document.title="owned"</script> sill\'s ${edge} in ten minutes'
"""What a person may type, and a page must show as it is."""


def written(folder: Path, kind: str, *arguments: str) -> str:
    done = ran("plan", *arguments, "--format", kind, *NOW, folder=folder)
    assert done.code == 0, done.err
    return done.out


@pytest.fixture(scope="module")
def breakfast(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """One plan in the formats that hold its figures."""
    folder = tmp_path_factory.mktemp("breakfast")
    return {kind: written(folder, kind, "examples/breakfast.txt") for kind in ("json", "jsonl", "csv")}


# -- jq -----------------------------------------------------------------------------------------------------


def chosen(program: str, text: str) -> list[Any]:
    """Run a jq program over a text of one or more JSON documents."""
    jq = pytest.importorskip("jq", reason="jq is not installed: it does not read our JSON")
    found: list[Any] = jq.compile(program).input_text(text).all()
    return found


def test_jq_chooses_among_lines_as_among_the_skills_of_the_document(breakfast: dict[str, str]) -> None:
    wanted = "select(.satisfaction < 1 and (.rejected | not)) | [.id, .start_s, .name]"
    lines = chosen(f'select(.type == "skill") | {wanted}', breakfast["jsonl"])
    assert lines == chosen(f".skills[] | {wanted}", breakfast["json"])
    assert 0 < len(lines) < 10


def test_jq_finds_the_plan_in_the_last_line(breakfast: dict[str, str]) -> None:
    (status,) = chosen('select(.type == "plan") | .certificate.status', breakfast["jsonl"])
    assert [status] == chosen(".certificate.status", breakfast["json"])
    assert chosen(".type", breakfast["jsonl"])[-1] == "plan"


def test_jq_reads_the_answers_of_a_batch_and_the_events_of_a_run(tmp_path: Path) -> None:
    done = ran(
        "batch", "examples/breakfast.txt", "tests/data/empty.txt", "--jobs", "1", *NOW, folder=tmp_path
    )
    assert chosen("[.file, (.plan.skills | length), .error.code]", done.out) == [
        ["examples/breakfast.txt", 10, None],
        ["tests/data/empty.txt", 0, 66],
    ]
    events = ran("run", "-i", "Stir the soup in ten minutes", "--simulate", *NOW, folder=tmp_path).out
    assert chosen('select(.type == "start") | .id', events) == ["s1"]


# -- pandas -------------------------------------------------------------------------------------------------


def test_pandas_reads_the_same_figures_from_csv_lines_and_document(breakfast: dict[str, str]) -> None:
    pandas = pytest.importorskip("pandas", reason="pandas is not installed: it does not read our tables")
    table = pandas.read_csv(io.StringIO(breakfast["csv"]), parse_dates=["start", "end", "done"])
    lines = pandas.read_json(io.StringIO(breakfast["jsonl"]), lines=True, dtype=False)
    skills = lines[lines["type"] == "skill"].set_index("id")
    whole = {skill["id"]: skill for skill in json.loads(breakfast["json"])["skills"]}
    assert table["start"].dtype.kind == "M"
    assert table["satisfaction"].dtype.kind == "f"
    assert table["rejected"].dtype.kind == "b"
    assert set(table["id"]) == set(skills.index) == set(whole)
    for row in table.itertuples():
        skill, line = whole[row.id], skills.loc[row.id]
        assert row.start == pandas.Timestamp(skill["start"])
        assert (row.end - row.start).total_seconds() == skill["duration_s"]
        assert line["start_s"] == skill["start_s"]
        # Some versions of pandas read the last digit otherwise.
        assert row.satisfaction == pytest.approx(skill["satisfaction"], rel=1e-12)
        assert line["satisfaction"] == pytest.approx(skill["satisfaction"], rel=1e-12)
        assert row.instruction == line["instruction"] == skill["instruction"]


def test_pandas_reads_what_was_typed_from_csv_as_it_was_typed(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas", reason="pandas is not installed: it does not read our tables")
    table = pandas.read_csv(io.StringIO(written(tmp_path, "csv", "-i", TYPED)))
    assert list(table["instruction"]) == [TYPED]


# -- a browser ----------------------------------------------------------------------------------------------


@pytest.fixture
def page(browser: "Browser") -> Iterator["Page"]:
    """Open a page that may neither ask for anything nor fail in a script."""
    context = browser.new_context(color_scheme="light", viewport={"width": 1000, "height": 900})
    context.set_default_timeout(15_000)
    found = context.new_page()
    wrong: list[str] = []
    found.on("pageerror", lambda error: wrong.append(str(error)))
    found.on("console", lambda said: wrong.append(said.text))
    found.on(
        "request",
        lambda asked: wrong.append(asked.url) if not asked.url.startswith("file:") else None,
    )
    yield found
    context.close()
    assert wrong == []


def shown(page: "Page", folder: Path, kind: str, *arguments: str) -> "Page":
    """Show a plan in the browser, from a file as a person opens it."""
    path = folder / f"plan.{kind}"
    path.write_text(written(folder, kind, *arguments), encoding="utf-8")
    page.goto(path.as_uri())
    return page


@pytest.mark.browser
def test_a_browser_shows_the_plan_as_a_table(page: "Page", breakfast: dict[str, str], tmp_path: Path) -> None:
    shown(page, tmp_path, "html", "examples/breakfast.txt")
    skills = sorted(json.loads(breakfast["json"])["skills"], key=lambda skill: skill["start_s"])
    rows = [row.locator("td").all_inner_texts() for row in page.locator("tbody tr").all()]
    assert sorted(row[3] for row in rows) == sorted(skill["name"] for skill in skills)
    assert [row[:2] for row in rows] == [[skill["id"], skill["start"][11:16]] for skill in skills]
    assert {row[3]: row[5].strip() for row in rows} == {
        skill["name"]: f"{skill['satisfaction']:.2f}" for skill in skills
    }
    assert page.locator("meter").count() == len(skills)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


@pytest.mark.browser
def test_a_page_for_several_says_who_does_what_and_of_what_happens_that_nobody_does(
    page: "Page", tmp_path: Path
) -> None:
    wishes = ("-i", "Stir the soup now", "-i", "Feed the cat now", "-i", "The guests come in an hour")
    shown(page, tmp_path, "html", *wishes, "--agents", "2")
    rows = [row.locator("td").all_inner_texts() for row in page.locator("tbody tr").all()]
    doers = {row[0]: row[3] for row in rows}
    assert doers.pop("s3") == "–"
    assert sorted(doers.values()) == ["1", "2"]


@pytest.mark.browser
def test_no_name_in_a_picture_reaches_into_the_curves(page: "Page", tmp_path: Path) -> None:
    names = ("W" * 60, "minimum mummy women " * 4, "LARGE CAPITALS EVERYWHERE " * 3, "日本語" * 20, "il" * 50)
    wishes = [part for name in names for part in ("-i", f"Call {name} at noon")]
    shown(page, tmp_path, "svg", *wishes)
    curves = page.locator("line.grid[y1='56']").first.bounding_box()
    labels = [
        label.evaluate("one => one.getBBox().x + one.getBBox().width")
        for label in page.locator(".label").all()
    ]
    assert curves is not None
    assert len(labels) == len(names)
    assert max(labels) <= curves["x"]


@pytest.mark.browser
def test_a_plan_fits_the_screen_of_a_telephone(page: "Page", tmp_path: Path) -> None:
    page.set_viewport_size({"width": 360, "height": 740})
    shown(page, tmp_path, "html", "examples/workshop.yaml")
    assert page.evaluate("document.documentElement.scrollWidth") == 360


@pytest.mark.browser
@pytest.mark.parametrize("kind", ["html", "svg"])
def test_a_browser_draws_every_skill_inside_the_picture(kind: str, page: "Page", tmp_path: Path) -> None:
    shown(page, tmp_path, kind, "examples/workshop.yaml")
    picture = page.locator("svg").bounding_box()
    bars = page.locator("svg rect").all()
    assert picture is not None
    assert len(bars) >= 6
    for bar in bars:
        box = bar.bounding_box()
        assert box is not None
        assert picture["x"] - 1 <= box["x"]
        assert box["x"] + box["width"] <= picture["x"] + picture["width"] + 1
        assert box["y"] + box["height"] <= picture["y"] + picture["height"] + 1
        assert min(box["width"], box["height"]) > 0


@pytest.mark.browser
@pytest.mark.parametrize("kind", ["html", "svg"])
def test_a_browser_shows_what_was_typed_and_runs_none_of_it(kind: str, page: "Page", tmp_path: Path) -> None:
    shown(page, tmp_path, kind, "-i", TYPED)
    titles = page.locator("svg title").evaluate_all("found => found.map(one => one.textContent)")
    assert TYPED in titles
    assert page.locator("script, b").count() == 0
    assert "owned" not in page.title()
