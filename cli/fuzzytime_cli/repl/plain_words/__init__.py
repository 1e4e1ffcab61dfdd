"""Plain words about what was asked for already: ``speaking`` tells which command they are, ``taking`` does.

They are taken as ``usually_said``: by what is told (``told_times``) of what is ``known``, and by
a table of ``ways``. Wishes may be for what is ``between_planned`` things.

The command that is ``meant``, of one thing, of several or ``of_all``: ``retiming``, ``shifting``, what is
``said_again``, ``leaving_out``, ``progress``, and what is ``leaning`` on what was said before,
``redirected`` to another, ``offered``, only tried by ``supposing``, or said beside ``reasons``.
News: ``telling`` how things are, what ``happened``, what one ``has_done``. What ``perhaps`` means something
else.
"""
