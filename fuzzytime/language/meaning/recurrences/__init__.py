"""Repetitions that give their occurrences.

A ``recurrence``: ``recurrence_by_months``, ``recurrence_on_days``, and a ``delayed_recurrence``, behind
another or at its end. ``series`` makes them of what was said.
"""
