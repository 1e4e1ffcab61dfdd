"""The page in a real browser: what people draw is what is stored."""

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from fuzzytime.study import AnswerStore, Design
from fuzzytime.study.serving.server import StudyServer
from study.serving import running

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.browser

PADDING = {"left": 52, "right": 28, "top": 18, "bottom": 52}
"""Where the plot lies inside its canvas."""


@pytest.fixture
def server(tmp_path: Path, design: Design) -> Iterator[StudyServer]:
    with running(tmp_path / "answers.sqlite", design) as server:
        yield server


Opened = Callable[..., "Page"]


@pytest.fixture
def opened(browser: "Browser", server: StudyServer) -> Iterator[Opened]:
    """Open pages whose scripts must not fail."""
    contexts = []
    broken: list[str] = []

    def open_page(width: int = 1440, height: int = 900, *, touch: bool = False) -> "Page":
        context = browser.new_context(viewport={"width": width, "height": height}, has_touch=touch)
        context.set_default_timeout(15_000)
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: broken.append(str(error)))
        page.on("console", lambda said: broken.append(said.text) if said.type == "error" else None)
        page.goto(server.url)
        return page

    yield open_page
    for context in contexts:
        context.close()
    # An answer that was refused or did not arrive is said on the page, and the browser notes it as well.
    assert [line for line in broken if "status of 422" not in line and "net::ERR_FAILED" not in line] == []


def agree(page: "Page") -> None:
    page.get_by_role("checkbox").check()
    page.get_by_role("button", name="Begin").click()


def reach_the_first_task(page: "Page") -> None:
    agree(page)
    page.get_by_role("heading", name="About you").wait_for()
    page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name="Try it out").wait_for()
    page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name="Instruction 1 of 14").wait_for()


class Canvas:
    """Where a time and a satisfaction lie on the screen, while the window begins at a time."""

    def __init__(self, page: "Page", first: float = 0.0, span: float = 900.0) -> None:
        self.page, self.first, self.span = page, first, span
        canvas = page.locator("canvas.curve")
        canvas.scroll_into_view_if_needed()
        box = canvas.bounding_box()
        assert box is not None
        self.left, self.top = box["x"] + PADDING["left"], box["y"] + PADDING["top"]
        self.width = box["width"] - PADDING["left"] - PADDING["right"]
        self.height = box["height"] - PADDING["top"] - PADDING["bottom"]

    def at(self, time: float, value: float) -> tuple[float, float]:
        return (
            self.left + self.width * (time - self.first) / self.span,
            self.top + self.height * (1 - value),
        )

    def draw(self, curve: Callable[[float], float], low: float, high: float, points: int = 14) -> None:
        times = np.linspace(low, high, points).tolist()
        self.page.mouse.move(*self.at(times[0], curve(times[0])))
        self.page.mouse.down()
        for time in times[1:]:
            self.page.mouse.move(*self.at(time, curve(time)))
        self.page.mouse.up()


def stored(server: StudyServer) -> dict[str, np.ndarray]:
    return dict(server.service.store.answers().participants[0].curves)


def save_and_go_on(page: "Page", position: int = 2) -> None:
    page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name=f"Instruction {position} of 14").wait_for()


def hill(time: float) -> float:
    """A smooth hill around seven minutes, 0 before two and after twelve."""
    return 0.5 - 0.5 * math.cos(2 * math.pi * (time - 120) / 600) if 120 <= time <= 720 else 0.0


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (360, 740)])
def test_a_drawn_curve_comes_back_within_three_hundredths_everywhere(
    opened: Opened, server: StudyServer, width: int, height: int
) -> None:
    page = opened(width, height)
    reach_the_first_task(page)
    Canvas(page).draw(hill, 0, 880, points=90)
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    meant = np.array([hill(time) for time in times.tolist()])
    assert np.abs(curve - meant).max() <= 0.03


def test_full_satisfaction_and_the_very_first_moment_can_be_reached(
    opened: Opened, server: StudyServer
) -> None:
    page = opened()
    reach_the_first_task(page)
    canvas = Canvas(page)
    # Over the edges of the plot, as hands are.
    x, y = canvas.at(0, 1)
    page.mouse.move(x - 20, y - 10)
    page.mouse.down()
    page.mouse.move(canvas.at(300, 1)[0], y - 10)
    page.mouse.move(canvas.at(301, 0)[0], canvas.at(301, 0)[1] + 12)
    page.mouse.up()
    save_and_go_on(page)
    (curve,) = stored(server).values()
    assert (curve[:66] == 1).all()
    assert (curve[68:] == 0).all()


def test_a_curve_is_corrected_by_drawing_over_it_and_by_undo(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    canvas = Canvas(page)
    canvas.draw(lambda _time: 0.8, 100, 800)
    canvas.draw(lambda _time: 0.3, 300, 500)
    canvas.draw(lambda _time: 0.9, 600, 700)
    page.get_by_role("button", name="Undo").click()
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    for low, high, value in ((110, 290, 0.8), (310, 490, 0.3), (510, 790, 0.8)):
        assert curve[(times > low) & (times < high)] == pytest.approx(value, abs=0.01)
    assert (curve[times > 820] == 0).all()


def test_the_timeline_is_moved_by_its_bar_and_its_buttons(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    page.get_by_role("button", name="Later").click(click_count=4)
    Canvas(page, first=1800).draw(lambda _time: 0.6, 1900, 2600)
    page.get_by_role("button", name="Show more time").click()
    page.get_by_role("button", name="Show more time").click()
    Canvas(page, first=0, span=3600).draw(lambda _time: 0.4, 3000, 3500)
    bar = page.get_by_role("slider")
    page.get_by_role("button", name="Show less time").click(click_count=3)
    box = bar.bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] * 0.25, box["y"] + 20)
    assert bar.get_attribute("aria-valuenow") == "12.5"
    bar.press("ArrowLeft")
    assert bar.get_attribute("aria-valuenow") == "11.3"
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    assert curve[(times > 1920) & (times < 2580)] == pytest.approx(0.6, abs=0.01)
    assert curve[(times > 3020) & (times < 3480)] == pytest.approx(0.4, abs=0.01)


def test_the_keyboard_draws_as_well(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    canvas = page.locator("canvas.curve")
    canvas.focus()
    for key in ["ArrowRight"] * 4 + ["ArrowUp"] * 6 + ["Enter"] + ["Shift+ArrowRight"] * 5 + ["Enter"]:
        canvas.press(key)
    assert "5.4 min: 80 % satisfied" in page.locator(".readout").inner_text()
    for key in [
        "ArrowRight",
        "Shift+ArrowDown",
        "Shift+ArrowDown",
        "Shift+ArrowDown",
        "Shift+ArrowDown",
        "Enter",
    ]:
        canvas.press(key)
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    assert curve[(times >= 54) & (times <= 324)] == pytest.approx(0.8)
    assert (curve[times > 345] == 0).all()


def test_points_can_be_entered_instead(opened: Opened, server: StudyServer) -> None:
    page = opened(360, 740)
    reach_the_first_task(page)
    page.get_by_text("Enter points instead of drawing").click()
    page.get_by_role("button", name="Add a point").click()
    for row, (minutes, percent) in enumerate(((25, 0), (30, 100), (40, 0))):
        page.get_by_label("Minutes").nth(row).fill(str(minutes))
        page.get_by_label("Satisfaction in %").nth(row).fill(str(percent))
    page.get_by_role("button", name="Draw these points").click()
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    assert curve == pytest.approx(np.interp(times, [1500, 1800, 2400], [0, 1, 0]), abs=0.016)


def test_points_that_are_none_are_said_to_be(opened: Opened) -> None:
    page = opened()
    reach_the_first_task(page)
    page.get_by_text("Enter points instead of drawing").click()
    page.get_by_label("Minutes").first.fill("70")
    page.get_by_label("Satisfaction in %").first.fill("50")
    page.get_by_role("button", name="Draw these points").click()
    page.get_by_text("Minutes must lie between 0 and 60").wait_for()


def test_a_finger_draws(opened: Opened, server: StudyServer) -> None:
    page = opened(360, 740, touch=True)
    reach_the_first_task(page)
    canvas = Canvas(page)
    session = page.context.new_cdp_session(page)
    path = [canvas.at(time, hill(time)) for time in np.linspace(0, 880, 90).tolist()]
    for kind, (x, y) in [("touchStart", path[0]), *(("touchMove", point) for point in path[1:])]:
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    assert np.abs(curve - np.array([hill(time) for time in times.tolist()])).max() <= 0.03


def test_a_whole_study_from_consent_to_thanks(opened: Opened, server: StudyServer) -> None:
    page = opened()
    begin = page.get_by_role("button", name="Begin")
    assert begin.is_disabled()
    agree(page)
    page.get_by_label("How old are you?").fill("31")
    page.get_by_label("female", exact=True).check()
    page.get_by_role("button", name="Next").click()
    page.get_by_role("button", name="Next").click()
    seen = []
    for position in range(14):
        page.get_by_role("heading", name=f"Instruction {position + 1} of 14").wait_for()
        seen.append(page.locator("p.instruction").inner_text())
        Canvas(page).draw(lambda _time: 0.7, 10, 800, points=4)
        page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name="One last question").wait_for()
    assert "three minutes late" in page.locator("legend").inner_text()
    page.get_by_role("button", name="Next").click()
    page.get_by_text("choose one of the answers").wait_for()
    page.get_by_label("2", exact=True).check()
    page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name="Thank you!").wait_for()
    (person,) = server.service.store.answers().participants
    design = server.service.store.design
    assert person.finished
    assert person.control == 2
    assert person.demographics == {"age": "31", "gender": "female"}
    assert [design.instruction(key).text for key in person.order] == seen
    assert len(person.curves) == 14
    page.get_by_role("button", name="Start anew").click()
    agree(page)
    page.get_by_role("heading", name="About you").wait_for()
    assert len(server.service.store.answers().participants) == 2


def test_who_comes_back_goes_on_with_what_was_drawn(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    Canvas(page).draw(lambda _time: 0.7, 10, 800, points=4)
    save_and_go_on(page)
    Canvas(page).draw(lambda _time: 0.4, 10, 800, points=4)
    second = page.locator("p.instruction").inner_text()
    page.reload()
    page.get_by_text("Welcome back").wait_for()
    assert page.locator("p.instruction").inner_text() == second
    save_and_go_on(page, 3)
    first, other = stored(server).values()
    assert first[90] == pytest.approx(0.7, abs=0.01)
    assert other[90] == pytest.approx(0.4, abs=0.01)
    page.get_by_role("button", name="Back").click()
    page.get_by_role("heading", name="Instruction 2 of 14").wait_for()
    assert page.locator("p.instruction").inner_text() == second


def test_nothing_drawn_is_asked_about_once(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    page.get_by_role("button", name="Next").click()
    page.get_by_text("no start would satisfy you").wait_for()
    save_and_go_on(page)
    (curve,) = stored(server).values()
    assert not curve.any()


def test_a_refused_answer_is_said_and_may_be_corrected(opened: Opened, server: StudyServer) -> None:
    page = opened()
    agree(page)
    female = page.get_by_label("female", exact=True)
    female.evaluate("input => { input.value = 'of course'; }")
    female.check()
    page.get_by_role("button", name="Next").click()
    page.get_by_text("gender must be one of female, male, another, got 'of course'").wait_for()
    page.get_by_label("another").check()
    page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name="Try it out").wait_for()
    assert server.service.store.answers().participants[0].demographics == {"gender": "another"}


def test_a_number_that_is_none_is_said_before_it_is_sent(opened: Opened, server: StudyServer) -> None:
    page = opened()
    agree(page)
    age = page.get_by_label("How old are you?")
    for typed in ("7", "30.5", "1e"):
        age.fill("")
        age.press_sequentially(typed)
        page.get_by_role("button", name="Next").click()
        page.get_by_text("whole number from 16 to 120, or leave it open").wait_for()
    age.fill("70")
    page.get_by_role("button", name="Next").click()
    page.get_by_role("heading", name="Try it out").wait_for()
    assert server.service.store.answers().participants[0].demographics == {"age": "70"}


def test_an_answer_waits_for_a_server_that_is_away(
    browser: "Browser", tmp_path: Path, design: Design
) -> None:
    context = browser.new_context()
    page = context.new_page()
    with running(tmp_path / "answers.sqlite", design) as server:
        port = server.port
        page.goto(server.url)
        reach_the_first_task(page)
    Canvas(page).draw(lambda _time: 0.7, 10, 800, points=4)
    page.get_by_role("button", name="Next").click()
    page.get_by_text("your drawing is kept").wait_for()
    with running(tmp_path / "answers.sqlite", design, port):
        page.get_by_role("heading", name="Instruction 2 of 14").wait_for()
    context.close()
    with AnswerStore.open(tmp_path / "answers.sqlite") as store:
        assert len(store.answers().participants[0].curves) == 1


@pytest.mark.parametrize("width", [360, 1440])
def test_no_page_is_wider_than_its_screen(opened: Opened, width: int) -> None:
    page = opened(width, 740)

    def fits() -> bool:
        return bool(page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"))

    assert fits()
    agree(page)
    page.get_by_role("heading", name="About you").wait_for()
    assert fits()
    page.get_by_role("button", name="Next").click()
    page.get_by_text("Enter points instead of drawing").click()
    assert fits()


def test_who_reloads_sees_the_same_page_again(opened: Opened) -> None:
    page = opened()
    agree(page)
    for title in ("About you", "Try it out", "Instruction 1 of 14"):
        page.get_by_role("heading", name=title).wait_for()
        page.reload()
        page.get_by_role("heading", name=title).wait_for()
        page.get_by_role("button", name="Next").click()


def test_somebody_else_may_begin_where_another_stopped(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    page.reload()
    page.get_by_role("button", name="Start anew").click()
    agree(page)
    page.get_by_role("heading", name="About you").wait_for()
    assert len(server.service.store.answers().participants) == 2


def double_click_next(page: "Page") -> None:
    button = page.get_by_role("button", name="Next")
    button.scroll_into_view_if_needed()
    box = button.bounding_box()
    assert box is not None
    page.mouse.dblclick(box["x"] + 5, box["y"] + 5)


def test_a_double_click_is_one_click(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    double_click_next(page)
    page.get_by_text("no start would satisfy you").wait_for()
    Canvas(page).draw(lambda _time: 0.7, 10, 800, points=4)
    assert page.locator("#status").inner_text() == ""
    double_click_next(page)
    page.get_by_role("heading", name="Instruction 2 of 14").wait_for()
    page.wait_for_timeout(200)
    assert page.locator("#status").inner_text() in ("", "Saved.")
    assert len(stored(server)) == 1


def test_the_browsers_back_goes_to_the_instruction_before(opened: Opened) -> None:
    page = opened()
    reach_the_first_task(page)
    for position in (2, 3):
        Canvas(page).draw(lambda _time: 0.7, 10, 800, points=4)
        save_and_go_on(page, position)
    for position in (2, 1):
        page.go_back()
        page.get_by_role("heading", name=f"Instruction {position} of 14").wait_for()


def test_nobody_draws_beyond_what_is_shown(opened: Opened, server: StudyServer) -> None:
    page = opened(900, 700)
    reach_the_first_task(page)
    Canvas(page).draw(lambda _time: 1.0, 300, 1300, points=6)
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    assert (curve[(times > 310) & (times < 890)] == 1).all()
    assert not curve[times > 910].any()


def test_enter_in_the_table_draws_its_points_and_next_takes_them(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    page.get_by_text("Enter points instead of drawing").click()
    minutes, percent = page.get_by_label("Minutes"), page.get_by_label("Satisfaction in %")
    minutes.nth(0).fill("5")
    minutes.nth(0).press("Enter")
    page.get_by_text("Minutes must lie between 0 and 60").wait_for()
    page.get_by_role("heading", name="Instruction 1 of 14").wait_for()
    percent.nth(0).fill("100")
    minutes.nth(1).fill("10")
    percent.nth(1).fill("100")
    save_and_go_on(page)
    (curve,) = stored(server).values()
    times = server.service.store.design.timeline.times
    assert (curve[(times > 305) & (times < 595)] == 1).all()
    assert not curve[times > 605].any()


def test_nothing_moves_while_an_answer_waits(opened: Opened, server: StudyServer) -> None:
    page = opened()
    reach_the_first_task(page)
    Canvas(page).draw(lambda _time: 0.7, 10, 800, points=4)
    save_and_go_on(page)
    Canvas(page).draw(lambda _time: 0.4, 10, 800, points=4)
    page.route("**/curve", lambda route: route.abort())
    page.get_by_role("button", name="Next").click()
    page.get_by_text("your drawing is kept").wait_for()
    assert page.locator("main").evaluate("main => main.inert")
    page.go_back()
    page.get_by_role("heading", name="Instruction 2 of 14").wait_for()
    page.unroute("**/curve")
    page.get_by_role("heading", name="Instruction 3 of 14").wait_for()
    assert len(stored(server)) == 2


LONG = "Donaudampfschifffahrtsgesellschaftskapitänsmützenabzeichenverleihungsurkunde"


def test_long_words_and_many_points_stay_on_a_small_screen(
    browser: "Browser", tmp_path: Path, design: Design
) -> None:
    text = design.yaml.replace("The assignment", LONG).replace("points: 5", "points: 11")
    wide = text.replace("[female, male, another]", f"[female, {LONG}]")
    context = browser.new_context(viewport={"width": 320, "height": 640}, color_scheme="dark")
    page = context.new_page()
    with running(tmp_path / "answers.sqlite", Design.of_text(wide)) as server:
        page.goto(server.url)
        agree(page)
        for title in ("About you", "Try it out", "Instruction 1 of 14"):
            page.get_by_role("heading", name=title).wait_for()
            assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
            page.get_by_role("button", name="Next").click()
        assert page.evaluate("getComputedStyle(document.body).color") == "rgb(228, 231, 235)"
    context.close()
