"""What clauses about time say.

A ``clause`` says that something is done, is so, or is an event (``clause_contents``): ``conditions``, numbers
in ``comparisons``, ``levels``. Lengths of time stand in front of it (``before_markers``), and it binds on one
side (``clause_sides``).
"""
