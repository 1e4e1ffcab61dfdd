"""A tree for each segment (``parsing``), and what trees get wrong.

``mended_verbs`` in ``mended_trees``, ``mended_things``, ``amounts``,
``needed_deeds``, ``aims``; ``places_in_front``.
"""
