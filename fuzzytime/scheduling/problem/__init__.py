"""What is solved: jobs with costs and windows, on a grid where that is wanted, posed from a task.

A task becomes a problem of ``jobs`` by ``posing``; where each may start are ``windows``, and costs in slots
a ``grid``. What one could have ``alone``, which of them ``clash``, and the ``placement`` of what is
rejected need no solver.
"""
