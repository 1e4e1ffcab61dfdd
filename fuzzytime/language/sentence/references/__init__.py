"""Which instruction words refer to (``mentions``), what was ``told`` of it, and times that count from it.

They stand in clauses (``anchors``) or in phrases (``phrase_anchors``). Some count from what was asked for of
the ``same_thing``, some are ``each_time`` that something is, some from the ``meals`` at which one eats.
"""
