"""Whether a reading is a time where it stands (``judging``).

For any kind of time
    ``borders``, ``cuts``, ``titles``, ``proper_names``, ``spoken_of``, ``no_times``, ``figures``,
    ``particles``, ``doses``, ``dining``, ``events``, ``standing``, ``given_times``, ``things_of_times``.
Behind another time
    ``further``.
For each kind
    ``walls`` with ``weak_walls``, ``bare_hours``, ``run_on_hours``, ``dated_entries`` and ``naming``;
    ``ranges``; ``lengths``.
"""
