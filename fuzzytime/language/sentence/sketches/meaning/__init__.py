"""What an instruction means: its ``negations``, on ``both_sides`` of a time, ``alternatives``, ``pronouns``.

The ``times_of_cases`` are none of what is to be done. Which hours are meant, by what was said last
(``clock_times``) and by what people do (``usual_hours``).
"""
