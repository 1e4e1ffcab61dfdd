"""Make the pictures of docs/study.md: ``PYTHONPATH=.:cli:tests python docs/study_images.py``.

The page is shown by a real browser at the widths of a telephone and of a desk; the figures are those of a
simulated study.
"""

import math
import tempfile
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from chromium import ARGUMENTS, chromium
from fuzzytime.rulebook import Profile
from fuzzytime.study import Design, Hand, Population, analyse, simulate
from fuzzytime.study.reporting.plots import figures, rendered
from fuzzytime_cli.study.truth import read_truth
from study.serving import running

IMAGES = Path(__file__).parent / "images"
SIZES = {"desk": (1440, 900), "telephone": (360, 740)}


def draw(page: Page, time: float, width: float) -> None:
    """Draw a hill around a time in minutes on the canvas, which shows the first quarter of an hour."""
    canvas = page.locator("canvas.curve")
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    if box is None:
        raise RuntimeError("the page shows no canvas")
    across, high = box["width"] - 80, box["height"] - 70
    for step in range(81):
        minute = 15 * step / 80
        value = 1 / (1 + abs((minute - time) / width) ** 5) + 0.01 * math.sin(step)
        x, y = box["x"] + 52 + across * minute / 15, box["y"] + 18 + high * (1 - min(max(value, 0), 1))
        page.mouse.move(x, y)
        if step == 0:
            page.mouse.down()
    page.mouse.up()


def pages() -> None:
    """Take pictures of the page."""
    with (
        tempfile.TemporaryDirectory() as folder,
        running(Path(folder) / "answers.sqlite", Design.shipped()) as server,
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=chromium(), args=ARGUMENTS)
        for name, (width, height) in SIZES.items():
            page = browser.new_context(viewport={"width": width, "height": height}).new_page()
            page.goto(server.url)
            page.get_by_role("checkbox").check()
            page.get_by_role("button", name="Begin").click()
            page.get_by_role("heading", name="About you").wait_for()
            page.get_by_role("button", name="Next").click()
            page.get_by_role("heading", name="Try it out").wait_for()
            draw(page, 5.0, 2.0)
            page.get_by_role("button", name="Next").click()
            while "in 10 minutes" not in page.locator("p.instruction").inner_text():
                position = page.get_by_role("heading", level=2).inner_text()
                page.get_by_role("button", name="Next").click()
                page.get_by_text("no start would satisfy you").wait_for()
                page.get_by_role("button", name="Next").click()
                page.get_by_role("heading", name=position, exact=True).wait_for(state="detached")
            draw(page, 10.0, 2.2)
            page.screenshot(path=IMAGES / f"study-instruction-{name}.png", full_page=True)
        browser.close()


def plots() -> None:
    """Draw the figures of a simulated study whose groups differ."""
    design = Design.shipped()
    population = Population(
        individual=0.35, group_widths={"robot": 1.15, "person": 0.87}, hand=Hand(time=4.0, satisfaction=0.02)
    )
    truth = read_truth(design, None, Profile.STUDY, by_actor=False)
    found = analyse(simulate(design, truth, 32, seed=1, population=population))
    for name, draw_figure in figures(found):
        if name in ("fits", "groups", "start-times", "instruction-in-30"):
            (IMAGES / f"study-{name.removeprefix('instruction-')}.png").write_bytes(
                rendered(draw_figure, "png")[0]
            )


if __name__ == "__main__":
    IMAGES.mkdir(exist_ok=True)
    pages()
    plots()
