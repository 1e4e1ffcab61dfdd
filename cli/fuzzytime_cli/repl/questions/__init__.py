"""Questions about the plan: ``answering`` them, ``gaps`` in it, and ``stretches`` of time that they name."""
