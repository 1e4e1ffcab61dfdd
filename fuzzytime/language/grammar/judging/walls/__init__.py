"""Whether a clock time or a day is one where it stands: ``walls``.

Those that alone are no sure time (``weak_walls``): ``bare_hours``, ``dated_entries``; those that are
``naming`` something, or count something else.
"""
