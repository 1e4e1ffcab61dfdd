"""Times shared, and several times of one thing.

Several times: ``several_times``, ``said_again``, ``pairs``, ``both_sides``, ``at_once``.
One of several: ``first_offered``, ``choices_of_repetitions``.
Repeated: ``again_between``, ``first_times``, ``turns``, ``one_by_one``. A part of the day behind another:
``mornings``. Said once: ``for_all``.
"""
