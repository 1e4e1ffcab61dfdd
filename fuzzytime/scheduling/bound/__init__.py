"""What no schedule can cost less than: a Lagrangian bound, on grid after finer grid.

The ``relaxation`` walks the cheapest ``paths`` at prices that ``multipliers`` make better; ``refinement``
goes from grid to grid.
"""
