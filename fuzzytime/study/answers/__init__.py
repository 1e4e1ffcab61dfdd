"""What people drew and said, as values; synthetic people; files for other programs.

The ``participants`` and what they drew (``subjective``), a ``rating`` of a start, people that we
``simulate``. Files for other programs and back: ``as_csv`` and ``as_json``, which says mistakes with their
``places``; both bring curves to the design's times by ``sampling``.
"""
