"""Readings, forecast, μ and ψ of a skill as a chart."""

import math

import numpy as np

from fuzzytime.context import symbol
from fuzzytime.interpreter import Interpreted, Plan
from fuzzytime.rulebook import Trace
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime_cli.drawing.chart import Chart, Curve, Mark, Panel, satisfaction_panel, window_of


def chart_of(interpreted: Interpreted, plan: Plan, position: int | None = None) -> Chart:
    """Draw what there is: readings, forecast and μ of a condition, then ψ with the planned start."""
    function: SatisfactionFunction = interpreted.skill.satisfaction
    start, end = window_of(function)
    panels: list[Panel] = []
    for resolution in interpreted.resolutions:
        if resolution.trace is not None:
            trace = resolution.trace
            shown = trace.times[trace.satisfaction > 0] if (trace.satisfaction > 0).any() else trace.times
            firsts = [signal.reading_times[0] for signal in trace.signals if signal.reading_times.size]
            start = min([start, *map(float, firsts)])
            end = (
                max(end, float(shown[-1]) * 1.05)
                if (trace.satisfaction > 0).any()
                else min(float(trace.times[-1]), 3600)
            )
            panels += _trace_panels(trace, start, end)
    panels.append(satisfaction_panel(function, start, end))
    marks: tuple[Mark, ...] = (Mark(0.0, "now"),) if start < 0 else ()
    if position is not None and plan.has_time(position):
        when = plan.schedule.start_times[position]
        planned = f"planned, satisfaction {plan.schedule.satisfactions[position]:.2f}"
        marks = (*marks, Mark(when, planned))
        end = max(end, when * 1.05)
    return Chart(tuple(panels), start, end, plan.request.now, marks)


def _trace_panels(trace: Trace, start: float, end: float) -> list[Panel]:
    panels = []
    for signal in trace.signals:
        readings = Curve("readings", signal.reading_times, signal.reading_values, dots=True)
        forecast = Curve(
            "forecast",
            signal.forecast_times,
            signal.forecast_median,
            band=(signal.forecast_low, signal.forecast_high),
        )
        inside = (signal.forecast_times >= start) & (signal.forecast_times <= end)
        seen = np.concatenate([signal.reading_values, signal.forecast_median[inside]])
        seen = seen[np.isfinite(seen)]
        if not seen.size:
            continue
        low, high = float(seen.min()), float(seen.max())
        margin = 0.05 * (high - low) or 1.0
        unit = f" in {symbol(signal.unit)}" if signal.unit else ""
        title = f"{signal.name}{unit}" + (f": {signal.outlook}" if signal.outlook else "")
        panels.append(Panel(title, (readings, forecast), *_rounded(low - margin, high + margin)))
    if trace.atoms:
        curves = tuple(Curve(text, trace.times, values) for text, values in trace.atoms)
        panels.append(Panel("μ: " + ", ".join(text for text, _ in trace.atoms), curves))
    return panels


def _rounded(low: float, high: float) -> tuple[float, float]:
    """Give limits of an axis with as few digits as tell them apart."""
    unit = 10.0 ** math.floor(math.log10(high - low) - 1)
    return math.floor(low / unit) * unit, math.ceil(high / unit) * unit
