"""What a context tells over time, and how true a condition is at each moment.

The ``world`` gives values over the times of a ``grid``, ``truth`` the degrees of a formula; ``thinning``
leaves out points that nobody misses.
"""
