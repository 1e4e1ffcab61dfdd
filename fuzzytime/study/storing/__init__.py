"""Answers kept in one SQLite file: what was acknowledged is on the disk.

A ``store`` over ``store_rows`` in a ``database``.
"""
