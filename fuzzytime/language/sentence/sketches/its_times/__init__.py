"""Which times are the instruction's (``own_times``), of those that are ``said_of_time``.

Some are ``elsewhere``, as in ``what_is_told``, or ``of_things``. What each is about is ``referred``.
"""
