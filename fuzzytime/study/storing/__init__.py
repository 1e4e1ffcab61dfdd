"""Answers kept in one SQLite file: what was acknowledged is on the disk."""
