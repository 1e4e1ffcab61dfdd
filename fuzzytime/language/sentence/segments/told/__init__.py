"""What is said beside an order, and is none.

How long: ``asides``, ``told_lengths``, ``gaps`` between two; when somewhere is open: ``asides_of_hours``.
Why: ``reasons``. What somebody is told: ``messages``, which begin in ``told_clauses``.
"""
