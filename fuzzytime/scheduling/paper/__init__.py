"""The paper's own methods, for comparison: nothing is proved by them.

``exhaustive`` sampling; ``climbing`` and annealing, and ``genetic`` search, on ``wishes`` for starts.
"""
