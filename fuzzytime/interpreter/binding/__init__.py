"""What binds skills to each other.

What wishes say of each other: ``references``, made to ``ties`` without ``circles``; what goes on
``meanwhile``, unless it keeps ``both_hands``; and a length ``giving_way`` to what begins then. What is
``prepared`` comes before what it is for, an errand behind what has ``opened``. Order: ``in_order`` by
``steps``, ``leaning``, ``procedures``, ``same_things``, ``timetables``. In steps, ``delays`` count from the
one before, ``bounds`` hold for all, ``doers`` are asked, and all is done shortly before the meal that it is
``led_to``. Where something cannot be planned: what waits is set ``apart``, and the order of the others is
kept by ``loosening`` and ``left_out``.
"""
