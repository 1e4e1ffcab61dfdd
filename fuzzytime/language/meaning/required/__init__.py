"""What is handed on: the requirement that the rest of the program works with.

``requirements``, with the ``edges`` that count; what the policy decided (``decisions``);
when something is not to be done (``denied_times``); one of several times (``offered``, ``offered_days``).
"""
