"""What the instructions of a text lend each other, in their ``sketches``.

Words and times
    ``lending``, ``verbs_again``, ``requested_too``, ``after_all``, ``pairs``, ``said_again``,
    ``several_times``, ``one_by_one``, ``both_sides``, ``first_offered``, ``again_between``, ``turns``,
    ``first_times``, ``at_once``, ``for_all``, ``also_at_events``, ``choices_of_repetitions``; what is
    ``told_beside``.
Days and lengths
    ``titles``, ``headings``, ``below_headings``, ``days_apart`` (``listed_days``, ``things_alone``),
    ``mornings``, ``day_by_day``, ``days_left_out``, ``each_week``, ``opening_hours``,
    ``days_on``, ``lengths``, ``waited``, ``consequences``, ``reasons_told``.
What is none
    ``orders_again``, ``doubts`` (``what_was``), ``denials``, ``naming``, ``how_often``.
"""
