"""What people drew and said, as values; synthetic people; rows for other programs.

The ``participants`` and what they drew (``subjective``), a ``rating`` of a start, people that we
``simulate``, and the ``exchange`` with other programs.
"""
