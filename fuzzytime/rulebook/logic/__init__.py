"""Temporal fuzzy logic: conditions as values, how they are read and joined, and windows of time."""
