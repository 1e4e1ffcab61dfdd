"""What was said, in words that the rest can plan.

Wishes ``in_full`` that lean on the one before; instructions ``retold`` with two ends as start and length.
On a day without a time of day, meals and evenings out are ``at_its_hours``. Conditions: how long they must be
``lasting``, what ``waits`` for one, what comes ``by_the_sky``. And ``why_nothing`` is asked for.
"""
