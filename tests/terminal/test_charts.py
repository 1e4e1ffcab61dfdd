"""Charts as pictures: nothing is drawn outside of its axis, and no label over another."""

import itertools
import re
from xml.etree import ElementTree as ET

import numpy as np

from fuzzytime_cli.drawing.chart import Chart, Curve, Mark, Panel
from fuzzytime_cli.drawing.svg import LEFT, RIGHT, WIDTH, chart_svg

TIMES = np.linspace(-300, 900, 50)
RISING = Curve("forecast", TIMES, np.linspace(0, 1, 50), band=(np.linspace(0, 0.9, 50), np.ones(50)))
CHART = Chart(
    panels=(
        Panel("pan in °C", (Curve("readings", TIMES[:10], np.zeros(10), dots=True), RISING)),
        Panel("μ: warm, hot", (Curve("warm", TIMES, np.ones(50)), Curve("hot", TIMES, np.zeros(50)))),
    ),
    start=-60,
    end=600,
    marks=(Mark(0, "now"), Mark(20, "planned, satisfaction 1.00"), Mark(590, "the end")),
)


def elements(name: str) -> list[ET.Element]:
    root = ET.fromstring(chart_svg(CHART, "pan"))  # noqa: S314 - it is our own picture
    return [node for node in root.iter() if node.tag.endswith(f"}}{name}") or node.tag == name]


def test_curves_end_where_the_time_axis_ends() -> None:
    across = [
        float(x)
        for path in elements("path")
        for x, _ in re.findall(r"[ML]([-\d.]+) ([-\d.]+)", path.attrib["d"])
    ]
    across += [float(dot.attrib["cx"]) for dot in elements("circle")]
    assert min(across) == LEFT
    assert max(across) == WIDTH - RIGHT


def test_labels_of_marks_have_rows_of_their_own_and_stay_inside() -> None:
    labels = {"".join(text.itertext()): text.attrib for text in elements("text")}
    marks = [labels[mark.label] for mark in CHART.marks]
    rows = [float(text["y"]) for text in (*marks, labels["pan in °C"])]
    assert all(below - above >= 12 for above, below in itertools.pairwise(rows))
    assert [text.get("text-anchor", "start") for text in marks] == ["start", "start", "end"]


def test_a_title_that_names_its_curves_is_their_legend() -> None:
    coloured = [text.text for text in elements("tspan")]
    assert coloured == ["readings", "forecast", "warm", "hot"]
    assert any("".join(text.itertext()) == "μ: warm, hot" for text in elements("text"))
