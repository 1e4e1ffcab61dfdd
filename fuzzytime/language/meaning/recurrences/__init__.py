"""Repetitions that give their occurrences.

A ``recurrence``: ``recurrence_by_months``, ``recurrence_on_days``, a ``closing_recurrence`` at an end,
and a ``delayed_recurrence`` behind another. ``series`` makes them of what was said.
"""
