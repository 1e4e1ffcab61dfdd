"""Temporal fuzzy logic: conditions as values, how they are read and joined, and windows of time.

A ``formula`` is read by a ``grammar``, joined by ``norms``, and looks through ``windows`` at ``traces``.
"""
