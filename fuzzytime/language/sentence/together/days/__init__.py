"""Days and lines that hold for instructions elsewhere.

Lines: ``titles``, and ``windows`` of hours, ``dated_lines``, ``headings``, ``below_headings``,
``periods_above``, ``of_the_next_day``.
Lists: ``listed_days``.
Days: ``days_apart``, ``mornings_after``, ``day_by_day``, ``days_left_out``, ``days_on``, ``each_week``.
"""
