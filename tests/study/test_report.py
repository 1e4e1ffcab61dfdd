"""Figures and the report that holds them."""

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from fuzzytime.study import Answers, Design, analyse
from fuzzytime.study.analysis.analyse import Analysis
from fuzzytime.study.reporting.plots import figures, instruction_figure, rendered
from fuzzytime.study.reporting.report import report

pytest.importorskip("matplotlib", reason="matplotlib is not installed: no figure is drawn")


@pytest.fixture(scope="module")
def analysis(answers: Answers) -> Analysis:
    # What people typed must not be read as markup, of HTML or of mathematics.
    design = answers.design
    odd = replace(design.instructions[0], text="Start <b>now</b> & $pay_{x}$!")
    design = replace(design, instructions=(odd, *design.instructions[1:3]), title="A <study> & more")
    first, *rest = answers.participants
    people = (replace(first, excluded="<script>alert(1)</script>"), *rest)
    return analyse(Answers(design, people), permutations=19)


@pytest.fixture(scope="module")
def pictures(analysis: Analysis) -> dict[str, bytes]:
    return {name: rendered(draw, "svg")[0] for name, draw in figures(analysis)}


class Checker(HTMLParser):
    """Collects tags, and checks that each that opens closes."""

    EMPTY = frozenset({"meta", "img", "br"})

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: list[str] = []
        self.outside: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.append(tag)
        self.outside += [
            v for name, v in attrs if name in ("src", "href") and v and not v.startswith("data:")
        ]
        if tag not in self.EMPTY:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_every_figure_of_the_paper_is_drawn(analysis: Analysis, pictures: dict[str, bytes]) -> None:
    assert list(pictures) == [
        "fits",
        "groups",
        "start-times",
        *map(instruction_figure, analysis.overall),
    ]
    for picture in pictures.values():
        root = ET.fromstring(picture)  # noqa: S314 - our own picture
        assert root.tag.endswith("svg")


def test_letters_that_no_font_has_and_control_characters_are_drawn_without_a_word(
    analysis: Analysis, recwarn: pytest.WarningsRecorder
) -> None:
    entry = next(iter(analysis.overall.values()))
    odd = replace(entry, instruction=replace(entry.instruction, text="すぐに\x1b[31m\a!"))
    drawings = dict(figures(replace(analysis, overall={entry.instruction.key: odd})))
    svg, _ = rendered(drawings["fits"], "svg", "png")
    ET.fromstring(svg)  # noqa: S314 - our own picture
    assert "すぐに [31m" in svg.decode()
    assert not recwarn.list


def test_a_figure_is_the_same_each_time_and_nothing_global_changes(analysis: Analysis) -> None:
    import matplotlib as mpl

    before = dict(mpl.rcParams)
    draw = dict(figures(analysis))["start-times"]
    assert rendered(draw, "svg", "png") == rendered(draw, "svg", "png")
    assert dict(mpl.rcParams) == before


def test_a_bitmap_has_the_size_of_a_page(analysis: Analysis) -> None:
    (bitmap,) = rendered(dict(figures(analysis))["fits"], "png")
    assert bitmap.startswith(b"\x89PNG")
    width = int.from_bytes(bitmap[16:20], "big")
    assert 1200 <= width <= 1500


def test_the_report_is_one_sound_page_that_needs_nothing_else(
    analysis: Analysis, pictures: dict[str, bytes]
) -> None:
    text = report(analysis, pictures)
    checker = Checker()
    checker.feed(text)
    assert checker.open == []
    assert checker.outside == []
    assert "script" not in checker.seen
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in text
    assert "<b>now</b>" not in text
    assert checker.seen.count("img") == len(pictures)
    for word in ("F1", "F2", "F3", "Methods", "Table 1.", "Figure 1.", "Cliff", "R²", "SSE"):
        assert word in text
    numbers = [int(number) for number in re.findall(r"<b>Table (\d+)\.", text)]
    assert numbers == list(range(1, len(numbers) + 1))


def test_without_pictures_the_tables_remain(analysis: Analysis) -> None:
    text = report(analysis, {})
    assert "<img" not in text
    assert "Table 5." in text


def test_a_study_with_one_group_gets_a_report_too(design: Design, answers: Answers) -> None:
    robots = tuple(person for person in answers.participants if person.group == "robot")
    alone = analyse(Answers(replace(design, groups={"robot": "robot"}), robots), permutations=9)
    assert "F2" not in report(alone, {})
    assert "groups" not in dict(figures(alone))
