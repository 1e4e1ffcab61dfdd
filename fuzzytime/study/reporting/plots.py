"""The paper's data figures, drawn from an analysis with matplotlib (the optional extra ``study``).

Only matplotlib's objects are used, never pyplot, so that nothing global changes. Times are in minutes.
"""

import io
import warnings
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.analysis.analyse import Analysis
from fuzzytime.study.analysis.characteristics import histogram
from fuzzytime.study.analysis.density import SQUARE_MINUTE
from fuzzytime.study.analysis.described import Described
from fuzzytime.study.analysis.fitting import Model
from fuzzytime.times import MINUTE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN_CURVES = 10
"""Curves of single participants in one panel, as many as the paper shows for a better overview."""

TIME_BINS = 100
"""Times of a histogram: finer ones are stripes, not a picture."""

COLUMNS = 3
"""Panels beside each other where every instruction has one."""

NOTED = 1.28
"""Upper end of the axis of satisfaction in panels with a note above the curves."""

_GREEN, _RED, _VIOLET, _GREY = "#2e7d4f", "#c0272d", "#6a4c93", "#5f6368"
_GROUPS = ("#1f77b4", "#e07b00", "#2e7d4f", "#6a4c93")
_SETTINGS: Mapping[Any, Any] = MappingProxyType(
    {
        "font.size": 9.0,
        "axes.titlesize": 9.5,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.linewidth": 0.7,
        "lines.linewidth": 1.4,
        "legend.frameon": False,
        "legend.fontsize": 8.0,
        "svg.fonttype": "none",
        # What people typed is text, also where it holds a dollar sign.
        "text.parse_math": False,
        "svg.hashsalt": "fuzzytime",
        "figure.dpi": 150.0,
    }
)


def figures(analysis: Analysis) -> Iterator[tuple[str, Callable[[], "Figure"]]]:
    """Give the figures of an analysis: a name for each, and what draws it.

    ``fits`` (F1), ``groups`` (F2, where there are two), ``start-times`` (F3), then one for each instruction,
    by `instruction_figure`: ten participants' curves, their histogram, and the distribution with quantiles.

    Raises
    ------
    FuzzytimeError
        If matplotlib is not installed.
    """
    try:
        import matplotlib.figure  # noqa: F401 - asked for here, once, for a clear message
    except ImportError as error:
        raise FuzzytimeError("plots need matplotlib: install fuzzytime-planner[study]") from error
    yield "fits", lambda: _grid(analysis, _fit_panel)
    if len(analysis.by_group) > 1:
        yield "groups", lambda: _grid(analysis, _group_panel)
    if analysis.start_times:
        yield "start-times", lambda: _start_times(analysis)
    for key, described in analysis.overall.items():
        yield instruction_figure(key), lambda described=described: _three_views(described)  # type: ignore[misc]


def instruction_figure(key: str) -> str:
    """Name the figure of an instruction, so that no key is another figure's name."""
    return f"instruction-{key}"


def rendered(draw: Callable[[], "Figure"], *forms: str) -> tuple[bytes, ...]:
    """Draw a figure in forms such as ``svg`` and ``png``; the same figure gives the same bytes."""
    import matplotlib as mpl

    with mpl.rc_context(dict(_SETTINGS)), warnings.catch_warnings():
        # An SVG keeps text as text; a PNG has boxes for what no font here can write.
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        figure = draw()
        streams = [io.BytesIO() for _ in forms]
        for form, stream in zip(forms, streams, strict=True):
            metadata = {"Date": None} if form == "svg" else {"Software": None}
            figure.savefig(stream, format=form, metadata=metadata)
    return tuple(stream.getvalue() for stream in streams)


def _grid(analysis: Analysis, draw: Callable[["Axes", Analysis, Described], None]) -> "Figure":
    """One panel per instruction, by preposition, with one legend for all."""
    from matplotlib.figure import Figure

    entries = sorted(
        analysis.overall.values(),
        key=lambda entry: list(analysis.models).index(entry.instruction.preposition),
    )
    rows = -(-len(entries) // COLUMNS)
    height = 0.5 + 1.9 * rows
    figure = Figure(figsize=(9.0, height))
    figure.subplots_adjust(
        left=0.06, right=0.985, bottom=0.45 / height, top=1 - 0.55 / height, wspace=0.16, hspace=0.62
    )
    axes: list[Axes] = []
    for position, entry in enumerate(entries):
        panel = figure.add_subplot(rows, COLUMNS, position + 1)
        _frame(panel, entry, _short(entry.instruction.text))
        draw(panel, analysis, entry)
        if position % COLUMNS:
            panel.set_yticklabels([])
        else:
            panel.set_ylabel("satisfaction")
        if position + COLUMNS >= len(entries):
            panel.set_xlabel("start time [min]")
        axes.append(panel)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=len(labels))
    return figure


def _fit_panel(axes: "Axes", analysis: Analysis, entry: Described) -> None:
    del analysis
    _distribution(axes, entry)
    times = entry.subjective.times[_visible(entry)]
    for model, colour, style in ((Model.TRAPEZOID, _RED, "-"), (Model.BELL, _VIOLET, "--")):
        if model in entry.fits:
            fitted = entry.fits[model].function(times)
            axes.plot(times / MINUTE, fitted, style, color=colour, lw=1.0, label=model.value)
    shown = [model for model in (Model.TRAPEZOID, Model.BELL) if model in entry.fits]
    _note(axes, "SSE: " + ", ".join(f"{model.value} {entry.fits[model].sse:.3f}" for model in shown))


def _group_panel(axes: "Axes", analysis: Analysis, entry: Described) -> None:
    notes = []
    for colour, (group, described) in zip(_GROUPS, analysis.by_group.items(), strict=False):
        own = described[entry.instruction.key]
        found, shown = own.characteristics, _visible(entry)
        minutes = found.times[shown] / MINUTE
        low, high = found.lower_quartile[shown], found.upper_quartile[shown]
        axes.fill_between(minutes, low, high, color=colour, alpha=0.18, lw=0)
        axes.plot(minutes, found.median[shown], color=colour, label=f"{group}: median and quartiles")
        notes.append(f"{group} {own.variance / SQUARE_MINUTE:.3g}")
    _note(axes, "variance [min²]: " + ", ".join(notes))


def _start_times(analysis: Analysis) -> "Figure":
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.2, 3.4))
    axes = figure.add_subplot()
    figure.subplots_adjust(left=0.12, right=0.97, bottom=0.15, top=0.96)
    colours = dict(zip(analysis.by_group, _GROUPS, strict=False))
    for group, found in analysis.start_times.items():
        axes.plot(
            found.t_spec / MINUTE,
            found.variances / SQUARE_MINUTE,
            "o-" if group is None else "s--",
            color=colours.get(group or "", "#202124"),
            label=group or "all",
            markersize=4,
        )
    axes.set_xlabel("specified start time [min]")
    axes.set_ylabel("variance of the median [min²]")
    axes.set_ylim(bottom=0)
    axes.grid(visible=True, axis="y", alpha=0.25, lw=0.6)
    axes.legend(loc="upper left")
    return figure


def _three_views(entry: Described) -> "Figure":
    """Draw some participants' curves, everybody's histogram, and the distribution with quantiles."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.0, 2.7))
    figure.subplots_adjust(left=0.06, right=0.985, bottom=0.18, top=0.82, wspace=0.24)
    curves, density, spread = (figure.add_subplot(1, 3, position) for position in (1, 2, 3))
    times = entry.subjective.times
    rows = np.unique(np.linspace(0, entry.subjective.participants - 1, SHOWN_CURVES).round().astype(int))
    for row in rows:
        shown = _visible(entry)
        curves.plot(times[shown] / MINUTE, entry.subjective.values[row, shown], lw=0.9, alpha=0.85)
    window = _visible(entry)
    counts, edges = _binned(histogram(entry.subjective)[:, window], times[window] / MINUTE)
    image = density.pcolormesh(
        edges,
        np.linspace(-0.025, 1.025, counts.shape[0] + 1),
        np.where(counts > 0, counts, np.nan),
        cmap="viridis",
        vmin=0,
        vmax=entry.subjective.participants,
        rasterized=True,
    )
    figure.colorbar(image, ax=density, pad=0.02, fraction=0.06)
    _distribution(spread, entry)
    figure.legend(*spread.get_legend_handles_labels(), loc="upper right", ncols=3)
    for panel, title in (
        (curves, f"{rows.size} of {entry.subjective.participants} participants"),
        (density, "histogram: how many participants"),
        (spread, "distribution"),
    ):
        _frame(panel, entry, title)
        panel.set_xlabel("start time [min]")
    curves.set_ylabel("satisfaction")
    return figure


def _binned(counts: Floats, minutes: Floats) -> tuple[Floats, Floats]:
    """Average counts of shape (bins, k) over neighbouring times; give them and the edges between them."""
    together = -(-minutes.size // TIME_BINS)
    starts = np.arange(0, minutes.size, together)
    sizes = np.diff(np.append(starts, minutes.size))
    step = minutes[1] - minutes[0]
    edges = np.append(minutes[starts], minutes[-1] + step) - step / 2
    return np.add.reduceat(counts, starts, axis=1) / sizes, edges


def _distribution(axes: "Axes", entry: Described) -> None:
    found, shown = entry.characteristics, _visible(entry)
    minutes = found.times[shown] / MINUTE
    low, high = found.lower_quartile[shown], found.upper_quartile[shown]
    axes.fill_between(minutes, low, high, color=_GREEN, alpha=0.22, lw=0, label="quartiles")
    axes.plot(minutes, found.maximum[shown], ":", color=_GREEN, lw=0.8, label="minimum, maximum")
    axes.plot(minutes, found.minimum[shown], ":", color=_GREEN, lw=0.8)
    axes.plot(minutes, found.median[shown], color=_GREEN, lw=2.4, alpha=0.75, label="median")


def _note(axes: "Axes", text: str) -> None:
    """Write figures in a strip above the curves."""
    axes.set_ylim(top=NOTED)
    axes.text(0.995, 0.985, text, transform=axes.transAxes, ha="right", va="top", fontsize=7, color=_GREY)


def _window(entry: Described) -> tuple[float, float]:
    """Give the minutes at which anybody is satisfied, with a margin."""
    found = entry.characteristics
    drawn = np.flatnonzero(found.maximum > 0.02)
    times = found.times / MINUTE
    low, high = (times[drawn[0]], times[drawn[-1]]) if drawn.size else (times[0], times[-1])
    margin = max(0.08 * (high - low), 1.0)
    return max(times[0], low - margin), min(times[-1], high + margin)


def _visible(entry: Described) -> slice:
    """Give the samples within the window, and one more on both sides."""
    low, high = _window(entry)
    first, last = np.searchsorted(entry.subjective.times / MINUTE, [low, high])
    return slice(max(int(first) - 1, 0), int(last) + 2)


def _frame(axes: "Axes", entry: Described, title: str) -> None:
    """Show the times at which anybody is satisfied, with the specified time marked."""
    from matplotlib.ticker import MaxNLocator

    axes.set_xlim(*_window(entry))
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
    axes.set_ylim(-0.03, 1.05)
    axes.set_yticks([0.0, 0.5, 1.0])
    axes.vlines(entry.instruction.t_spec / MINUTE, -0.03, 1.05, color=_GREY, lw=0.7, ls=(0, (2, 3)))
    axes.set_title(title, loc="left")


def _short(text: str) -> str:
    """Leave out what all instructions of the paper begin with, and what cannot be printed."""
    short = text.removeprefix("The assignment should start ").removesuffix("!")
    return "".join(sign if sign.isprintable() else " " for sign in short)
