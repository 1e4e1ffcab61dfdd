"""From what was said to instants.

``grounding`` is the road; ``standpoint`` is where one stands, ``moment`` when the instruction was given.
What the words leave open: ``chosen_clocks``, ``dated_weekdays``, ``part_instants``, ``range_instants``, and
from which day they are ``counted_from``.
"""
