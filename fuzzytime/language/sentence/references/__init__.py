"""Which instruction words refer to (``mentions``), and times that count from it.

They stand in clauses (``anchors``) or in phrases (``phrase_anchors``).
"""
