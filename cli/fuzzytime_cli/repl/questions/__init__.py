"""Questions about the plan, and what answers them.

``answering`` them by what is planned, or when all is over (``ends``); ``gaps`` in it, by what is ``taken``;
where ``rooms`` are; ``stretches`` of time that they name.
"""
