"""What an instruction means: its ``negations``, on ``both_sides`` of a time, ``alternatives``, ``pronouns``.

Which hours are meant, by what was said last (``clock_times``) and by what people do (``usual_hours``).
"""
