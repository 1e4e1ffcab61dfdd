"""What looks like a time.

As ``figures``, as ``proper_names``, as words ``spoken_of``, and as ``things_of_times``.
"""
