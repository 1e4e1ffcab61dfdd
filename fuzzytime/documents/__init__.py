"""Documents that people write, read safely: YAML and tables of cells, with the places of their mistakes.

A YAML ``document`` is parsed to a ``tree`` of texts with their places (``parsing``); ``nodes`` are read
from it, and every mistake is found in one run. ``cells`` are those of spreadsheets. What is made of
documents may be ``kept``, as ``plain`` JSON.
"""
