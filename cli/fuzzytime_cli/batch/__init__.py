"""Many task files planned at once: an answer each, in order, on this machine's processes or a cluster's.

``start`` takes the ``files``, ``backends`` do the work, ``answers`` are what comes of it, kept in a
``journal``.
"""
