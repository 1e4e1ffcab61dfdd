"""Orders that are about wishes (``changes``), of one or of ``every`` one that is left.

``moves`` to another time, and ``exceptions`` from a repetition.
"""
