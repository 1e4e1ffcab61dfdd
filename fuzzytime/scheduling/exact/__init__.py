"""Schedules proved best: by sets of jobs, by labels, by shares of the work, by mixed-integer programs.

Few jobs
    ``small``: Held-Karp over sets.
One agent
    ``labels`` with a ``memory``, ``merging`` them, and ``backward`` over them; below a rising ``threshold``,
    as far as they ``reach``; ``dominance``. A ``crowd`` has too many skills for labels.
Lags of any kind
    ``pauses``, by a program that is ``waiting``: it knows ``open_jobs``, and what ``leeway`` they leave.
Several agents
    ``shares`` of the work, and ``fitting`` them together; else a ``flow`` that is solved by ``milp``.
"""
