"""A chart as SVG."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from fuzzytime_cli.drawing.chart import Chart, Curve, Panel
from fuzzytime_cli.drawing.markup import element, number, picture, words
from fuzzytime_cli.drawing.ticks import ticks

WIDTH, LEFT, RIGHT, PANEL, GAP, TOP, BOTTOM = 720, 56, 16, 120, 28, 24, 36
ROW = 15
COLOURS = ("#1f5fa8", "#b3541e", "#3d7a3a", "#7a4e9c", "#8a6d1a")
STYLE = (
    "text{font:12px system-ui,sans-serif;fill:#333}.axis{stroke:#999;stroke-width:1}"
    ".grid{stroke:#ddd;stroke-width:1}.mark{stroke:#c33;stroke-width:1.5;stroke-dasharray:4 3}"
    "@media(prefers-color-scheme:dark){text{fill:#ddd}.grid{stroke:#444}}"
)


def chart_svg(chart: Chart, title: str) -> str:
    """Draw a chart as an SVG document."""
    top = TOP + ROW * len(chart.marks)
    bottom = top + len(chart.panels) * (PANEL + GAP) - GAP
    parts = []
    for index, panel in enumerate(chart.panels):
        parts += _panel(panel, chart, top + index * (PANEL + GAP))
    parts += _ticks(chart, bottom)
    for index, mark in enumerate(chart.marks):
        x = float(_across(chart, np.asarray([mark.time]))[0])
        y = ROW * (index + 1)
        # Beside its line, on the side where there is room; each mark in a row of its own.
        place = {"x": x - 4, "text_anchor": "end"} if x > WIDTH / 2 else {"x": x + 4}
        # Not through the titles between the panels.
        panels = [top + index * (PANEL + GAP) for index in range(len(chart.panels))]
        lines = [(y - ROW + 4, y + 2), *((begin, begin + PANEL) for begin in panels)]
        parts += [element("line", class_="mark", x1=x, y1=begin, x2=x, y2=end) for begin, end in lines]
        parts.append(element("text", words(mark.label), y=y, **place))
    return picture(WIDTH, bottom + GAP + BOTTOM, title, STYLE, "".join(parts))


def _across(chart: Chart, times: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(LEFT + chart.share(times) * (WIDTH - LEFT - RIGHT))


def _panel(panel: Panel, chart: Chart, top: float) -> list[str]:
    bottom = top + PANEL
    title, legend = _title(panel)
    parts = [element("text", title, x=LEFT, y=top - 6)]
    if legend:
        parts.append(element("text", legend, x=WIDTH - RIGHT, y=top - 6, text_anchor="end"))
    for share in (0.0, 0.5, 1.0):
        y = bottom - share * PANEL
        value = panel.low + share * (panel.high - panel.low)
        parts.append(element("line", class_="grid", x1=LEFT, y1=y, x2=WIDTH - RIGHT, y2=y))
        parts.append(
            element("text", words(f"{value:g}{panel.unit}"), x=LEFT - 6, y=y, dy=4, text_anchor="end")
        )
    for index, curve in enumerate(panel.curves):
        parts += _curve(curve, panel, chart, bottom, _colour(index))
    return parts


def _colour(index: int) -> str:
    return COLOURS[index % len(COLOURS)]


def _title(panel: Panel) -> tuple[str, str]:
    """Give a panel's title and, where that does not name its curves, a legend, in the curves' colours."""
    if len(panel.curves) == 1:
        return words(panel.title), ""
    labels = [
        element("tspan", words(curve.label), style=f"fill:{_colour(index)}")
        for index, curve in enumerate(panel.curves)
    ]
    named = ", ".join(curve.label for curve in panel.curves)
    if panel.title.endswith(named):
        return words(panel.title.removesuffix(named)) + ", ".join(labels), ""
    return words(panel.title), " ".join(labels)


def _curve(curve: Curve, panel: Panel, chart: Chart, bottom: float, colour: str) -> list[str]:
    def up(values: NDArray[np.float64]) -> NDArray[np.float64]:
        share = (values - panel.low) / ((panel.high - panel.low) or 1.0)
        return np.asarray(bottom - np.clip(share, 0.0, 1.0) * PANEL)

    curve = _inside(curve, chart)
    x, y = _across(chart, curve.times), up(np.asarray(curve.values))
    parts = []
    if curve.band is not None:
        low, high = up(curve.band[0]), up(curve.band[1])
        outline = path(np.concatenate([x, x[::-1]]), np.concatenate([low, high[::-1]]))
        parts.append(element("path", d=outline + "Z", fill=colour, fill_opacity=0.15))
    if curve.dots:
        places = zip(x.tolist(), y.tolist(), strict=True)
        parts += [element("circle", cx=across, cy=height, r=2.5, fill=colour) for across, height in places]
    else:
        parts.append(element("path", d=path(x, y), fill="none", stroke=colour, stroke_width=2))
    return parts


def _inside(curve: Curve, chart: Chart) -> Curve:
    """Cut a curve at the ends of the time axis."""
    times, values = np.asarray(curve.times), np.asarray(curve.values)
    inside = (times >= chart.start) & (times <= chart.end)
    if curve.dots or not times.size:
        return replace(curve, times=times[inside], values=values[inside])
    first = [chart.start] if times[0] < chart.start < times[-1] else []
    last = [chart.end] if times[0] < chart.end < times[-1] else []

    def cut(values: NDArray[np.float64]) -> NDArray[np.float64]:
        before, behind = (np.interp(end, times, values) for end in (first, last))
        return np.concatenate([before, values[inside], behind])

    band = None if curve.band is None else (cut(curve.band[0]), cut(curve.band[1]))
    return replace(curve, times=np.concatenate([first, times[inside], last]), values=cut(values), band=band)


def path(x: NDArray[np.float64], y: NDArray[np.float64]) -> str:
    """Write a line through points as path data; a gap (NaN) interrupts it."""
    steps, pen = [], "M"
    for across, height in zip(x.tolist(), y.tolist(), strict=True):
        if np.isfinite(across) and np.isfinite(height):
            steps.append(f"{pen}{number(across)} {number(height)}")
            pen = "L"
        else:
            pen = "M"
    return "".join(steps)


def _ticks(chart: Chart, bottom: float) -> list[str]:
    parts = [element("line", class_="axis", x1=LEFT, y1=bottom, x2=WIDTH - RIGHT, y2=bottom)]
    for tick in ticks(chart.start, chart.end, 8, chart.now):
        x = float(_across(chart, np.asarray([tick.time]))[0])
        parts.append(element("line", class_="axis", x1=x, y1=bottom, x2=x, y2=bottom + 5))
        parts.append(element("text", words(tick.label), x=x, y=bottom + 19, text_anchor="middle"))
    return parts
