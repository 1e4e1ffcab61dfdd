"""A chart in the terminal."""

import numpy as np

from fuzzytime_cli.clock import Clock
from fuzzytime_cli.drawing.canvas import Canvas
from fuzzytime_cli.drawing.chart import Chart, Panel
from fuzzytime_cli.drawing.ticks import axis
from fuzzytime_cli.render import fitted, plain, width_of

_AXIS = 7
_ROWS = 8
"""Lines of text of a panel in which anything rises."""

_SPARSE = 8
"""Of the edges of a band, every so-manieth point is drawn."""


def chart_lines(chart: Chart, width: int, *, unicode: bool) -> list[str]:
    """Draw a chart as lines of text."""
    columns = max(16, width - _AXIS - 1)
    lines: list[str] = []
    for panel in chart.panels:
        high = _ROWS if _rises(panel) else 1
        lines += _panel(panel, chart, columns, high, unicode=unicode)
    lines.append(_axis(chart, columns))
    for mark in chart.marks:
        lines.append(_placed(f"{_time(chart, mark.time)}: {plain(mark.label)}", columns))
    return lines


def _rises(panel: Panel) -> bool:
    """Whether anything in a panel is above its lower edge: what is 0 everywhere needs no room."""
    edges = (edge for curve in panel.curves for edge in (curve.values, *(curve.band or ())))
    return any(bool(np.any(np.asarray(edge) > panel.low)) for edge in edges)


def _panel(panel: Panel, chart: Chart, columns: int, rows: int, *, unicode: bool) -> list[str]:
    canvas = Canvas(columns, rows)
    span = (panel.high - panel.low) or 1.0
    for curve in panel.curves:
        up = (np.asarray(curve.values) - panel.low) / span
        draw = canvas.points if curve.dots else canvas.curve
        draw(chart.share(curve.times), up)
        for edge in curve.band or ():
            canvas.points(chart.share(curve.times)[::_SPARSE], ((edge - panel.low) / span)[::_SPARSE])
    for mark in chart.marks:
        share = float(chart.share(np.asarray(mark.time)))
        if 0 <= share <= 1:
            canvas.vertical(share)
    labels = {0: f"{panel.high:g}{panel.unit}", rows - 1: f"{panel.low:g}{panel.unit}"}
    heading = [_placed(plain(panel.title), columns)] if panel.title else []
    bar = "│" if unicode else "|"
    return heading + [
        f"{labels.get(row, '')[:_AXIS]:>{_AXIS}}{bar}{line}"
        for row, line in enumerate(canvas.lines(unicode=unicode))
    ]


def _placed(text: str, columns: int) -> str:
    """Put a line of text above or below the plot, further left where it is too long for that."""
    width = _AXIS + 1 + columns
    indent = max(0, min(_AXIS + 1, width - width_of(text)))
    return " " * indent + fitted(text, width - indent).rstrip()


def _axis(chart: Chart, columns: int) -> str:
    def column(time: float) -> int:
        return round(float(chart.share(np.asarray(time))) * (columns - 1))

    return fitted("", _AXIS + 1) + axis(columns, columns // 12, (chart.start, chart.end), chart.now, column)


def _time(chart: Chart, time: float) -> str:
    if chart.now is None:
        return f"{time / 60:+.4g} min"
    return Clock(chart.now, with_seconds=bool(round(time + chart.now.second) % 60)).of(time)
