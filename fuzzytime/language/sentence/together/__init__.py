"""What the instructions of a text lend each other, in their ``sketches``.

Words and times
    ``lending``, ``verbs_again``, ``after_all``, ``pairs``, ``said_again``, ``several_times``, ``both_sides``,
    ``first_offered``, ``again_between``, ``turns``, ``first_times``, ``at_once``, ``for_all``.
Days and lengths
    ``headings``, ``days_apart``, ``mornings``, ``day_by_day``, ``lengths``, ``waited``, ``consequences``.
What is none
    ``doubts``, ``denials``, ``naming``.
"""
