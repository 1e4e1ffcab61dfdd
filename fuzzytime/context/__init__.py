"""Readings of the world over time, and forecasts of them."""

from fuzzytime.context.readings import Context, Reading
from fuzzytime.context.signals import Approach, Course, Hold, Linear, Signal

__all__ = ["Approach", "Context", "Course", "Hold", "Linear", "Reading", "Signal"]
