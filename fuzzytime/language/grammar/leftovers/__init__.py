"""What looks like a time and is part of none: ``leftovers``.

Of ``unknown_days`` and ``unknown_hours``.
"""
