"""What a study asks: its design, read from YAML, and its page's words.

A ``design`` is read in ``design_parts``, from ``questions`` and ``page_texts`` with their ``placeholders``.
"""
