"""From answers and ratings to a rule table that plans by them.

To ``calibrate`` is to make sums (``breakpoints``) of what was ``measured`` and to write a ``table``; ratings
move a ``personal`` table away from a ``prior``.
"""
