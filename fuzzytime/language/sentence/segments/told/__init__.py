"""What is said beside an order, and is none.

How long: ``asides``, ``told_lengths``, ``gaps`` between two; when somewhere is open: ``asides_of_hours``;
by when it is needed: ``asides_of_needs``. What is over by then, or needs something: ``told_apart``.
Why: ``reasons``. In brackets: ``notes``. What somebody is told: ``messages``, begun in ``told_clauses``.
"""
