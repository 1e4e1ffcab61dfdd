"""Where ``clauses`` stand, from their ``markers`` to their ``ends``, and those that are ``at_levels``.

``deadlines`` that they set, and ``how_far`` something is from what they name.
"""
