"""Whether a reading is a time where it stands: ``judging`` a text as it is ``standing`` there.

For any kind of time
    What stands at its ``borders``, and ``beside`` it; that it is one of ``no_times`` by its ``look_alikes``,
    or one of ``given_times``, which something has.
For each kind
    ``walls``, and several ``run_on_hours``; ``ranges``; ``lengths``; ``repeats``; ``further`` ones behind
    another time.
"""
