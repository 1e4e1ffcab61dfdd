"""Lines and their entries: ``list_marks`` and ``leading_tags`` in front, ``heads`` that hold for all.

The weeks and days of a plan are ``numbered_periods``.

What may be one of the ``entries``; where ``dividers`` stand between them, and where nothing does
(``unmarked``); lines of ``things_needed``; what ``chains`` of steps join.
Of ``timed_lines``, a list of times, the hours beside what is named are ``hours_of_lines``, which are so
``typed_hours``, with ``joints`` between. What is then may be ``named_by_time``.
"""
