"""Reading rule files, a module for each kind of section.

Readers share one form, ``(scope, node, key) -> value``: the document with all declared names, the
section's node and its key in messages. They note mistakes and read on.

A ``scope`` is what a section is read with: ``rows`` and ``rules``, ``variables``, ``signals``,
``models``, ``widths``, ``durations``.
"""
