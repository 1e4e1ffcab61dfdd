"""Which instruction words refer to (``mentions``), what was ``told`` of it, and times that count from it.

What is meant is what is most alike (``likeness``), and what is put somewhere gets there (``whereabouts``).
Where somebody ``stays`` says what
"while she's out" means. A clause may be about ``several``, or about every one of a kind; what is
``left_inside`` goes in and comes out.

They stand in clauses (``anchors``) or in phrases (``phrase_anchors``). Some count from what was asked for of
the ``same_thing``, some are ``each_time`` that something is, some from the ``meals`` at which one eats.
What is on a day has its hours (``hours_on_days``).
"""
