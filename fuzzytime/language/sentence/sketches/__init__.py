"""One instruction before it is grounded: a ``sketch`` of its times, its clauses, what is to be done.

Its times
    ``said_of_time``; its ``own_times``, and not those ``elsewhere`` (``what_is_told``) nor ``of_things``;
    what each is about (``referred``); ``retimed``; ``how_far``, ``clock_times``, ``usual_hours``,
    ``days_of_events``, ``at_events``, what is ``prepared``; what
    is done ``in_turns`` with what is repeated.
Its clauses
    Where ``clauses`` stand, from their ``clause_markers`` to their ``clause_ends``; what they require
    (``clause_requirements``), ``deadlines_of_clauses``.
What it means
    ``negations``, ``alternatives``, ``pronouns``; what it is called with (``telling``).
"""
