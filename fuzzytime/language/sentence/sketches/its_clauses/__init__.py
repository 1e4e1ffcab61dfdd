"""Where ``clauses`` stand, from their ``markers`` to their ``ends``.

``deadlines`` that they set, and ``how_far`` something is from what they name.
"""
