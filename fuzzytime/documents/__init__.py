"""Documents that people write, read safely: YAML and tables of cells, with the places of their mistakes.

A YAML ``document`` holds a ``tree`` of texts with their places; ``nodes`` are read from it, and every
mistake is found in one run. ``cells`` are those of spreadsheets.
"""
