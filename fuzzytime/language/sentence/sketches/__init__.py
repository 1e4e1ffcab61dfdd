"""One instruction before it is grounded: a ``sketch`` of its times, its clauses, what is to be done.

What goes into it, from the ground
    What it is called with (``telling``), what is ``happening`` without a verb; ``its_clauses``, and which of
    the times are ``its_times``.
What comes out of it
    Its ``meaning``, and times ``around_events``.
"""
