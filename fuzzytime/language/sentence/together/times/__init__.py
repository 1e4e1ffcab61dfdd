"""Times shared, and several times of one thing.

Several times: ``several_times``, ``said_again``, ``pairs``, ``at_once``.
One of several: ``first_offered``, ``choices_of_repetitions``.
Repeated: ``again_between``, ``first_times``, ``turns``, ``one_by_one``. Said once: ``for_all``.
Of one thing on another day: ``behind_the_same``.
"""
