"""Two times as one: what is said beside each other, and what one lends the other.

Times said ``beside`` each other or ``told_apart``; the ends of a range (``range_ends``); ``distances``
from a time. Repetitions: with a time of day or days beside them (``repeats_beside``,
``intervals_on_days``), with their bounds (``bounded_repeats``, ``first_times``), ``throughout`` a
period, and with ``weekdays_left_out``.
"""
