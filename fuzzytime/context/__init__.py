"""Readings of the world over time, and forecasts of them.

``signals`` can be read, in ``units``; ``readings`` come from ``files``, ``lines`` and a
``spreadsheet``. A ``series`` is one signal over all time, and its ``forecast`` comes of ``fitting`` and
``sampling``.
"""

from fuzzytime.context.files import parse_assignment, read_context_file, read_context_lines, read_context_node
from fuzzytime.context.lines import parse_context_line, parse_fields, reading_of, time_of
from fuzzytime.context.readings import Context, Reading
from fuzzytime.context.signals import Approach, Course, Hold, Linear, Signal
from fuzzytime.context.units import parse_quantity, symbol

__all__ = [
    "Approach",
    "Context",
    "Course",
    "Hold",
    "Linear",
    "Reading",
    "Signal",
    "parse_assignment",
    "parse_context_line",
    "parse_fields",
    "parse_quantity",
    "read_context_file",
    "read_context_lines",
    "read_context_node",
    "reading_of",
    "symbol",
    "time_of",
]
