"""Days said by other days.

``nested`` in periods ("the first monday of march"), in ``relations`` to today or each other,
``workdays`` that pass over weekends, and ``spared_days`` that are none of others.
"""
