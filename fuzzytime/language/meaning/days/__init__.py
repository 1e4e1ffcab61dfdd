"""Days said by other days.

``nested`` in periods ("the first monday of march"), in ``relations`` to today or each other, said
``side_by_side``; ``workdays`` that pass over weekends, and days that are none of others.
"""
