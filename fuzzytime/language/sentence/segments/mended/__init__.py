"""A tree for each segment (``parsing``), and what trees get wrong.

``mended_verbs``, ``forms_of_be`` and ``joined_things`` in ``mended_trees``, ``mended_things``, ``amounts``,
``last_nouns``, ``needed_deeds``, ``aims``; ``topics``, ``said_to_be`` and ``places_in_front``.
"""
