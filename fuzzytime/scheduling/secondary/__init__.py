"""The best among schedules that satisfy equally.

The ``objectives``, some of them about quantities ``over_time``, are followed in turn: ``lexicographic``. What
is wished for at ``distances`` from others follows these. What is tied to each other moves in ``clusters``;
what has no time of its own is done ``as_said``.
"""
