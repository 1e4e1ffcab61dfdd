"""Orders that are about wishes (``changes``).

``moves`` to another time, and ``exceptions`` from a repetition.
"""
