"""What time words mean: expressions that know no language, and how they become instants and requirements.

Rules of a grammar build expressions; once it is known when they were said, the policy decides what they
leave open.

What was said
    ``expressions``, of ``units``, of the ``calendar`` (further ``days``, and ``feasts`` by their
    ``calendars``) and of ``times_of_day``. Two times ``joined`` to one. What is asked of ``phrases``; what
    names no time is ``ungrounded``.
What it is
    ``instants``, found as ``grounded``, of ``midnights`` the one that is meant; ``recurrences``; what is
    ``required``.
"""
