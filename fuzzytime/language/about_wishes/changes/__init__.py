"""Orders that are about wishes (``changes``).

``moves`` to another time, ``exceptions`` from a repetition, and ``keeping_free`` of time.
"""
