"""What rule files say, as values, and how they are read.

What they say
    Their ``contents``: rows and ``rules``, over which requirements (``matching``), models by ``expression``,
    ``width``, ``variables``, ``durations``; a ``profile`` chooses.
How they are read
    ``documents``, in two passes: the ``vocabulary``, then the ``sections``; and their ``agreement`` with
    files read before.
"""
