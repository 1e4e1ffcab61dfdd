"""A tree for each segment (``parsing``), and what trees get wrong.

``mended_verbs`` and ``forms_of_be`` in ``mended_trees``, ``mended_things``, ``amounts``,
``last_nouns``, ``needed_deeds``, ``aims``; ``topics``, ``said_to_be`` and ``places_in_front``.
"""
