"""From answers and ratings to a rule table that plans by them.

To ``calibrate`` is to fit ``breakpoints`` and write a ``table``; ``personal`` ratings move it away from a
``prior``.
"""
