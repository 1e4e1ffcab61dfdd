"""What people drew and said, as values; synthetic people; files for other programs.

The ``participants`` and what they drew (``subjective``), a ``rating`` of a start, people that we
``simulate``. Files for other programs and back: ``as_csv`` by its ``csv_rows``, and ``as_json`` with the
``places`` of its mistakes; both bring curves to the design's times by ``sampling``.
"""
