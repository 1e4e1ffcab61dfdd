"""Days and lines that hold for instructions elsewhere.

Lines: ``titles``, ``headings``, ``below_headings``; lists: ``listed_days``, ``things_alone``.
Days: ``days_apart``, ``day_by_day``, ``days_left_out``, ``days_on``, ``each_week``.
"""
