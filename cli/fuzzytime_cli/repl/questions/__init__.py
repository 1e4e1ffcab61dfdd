"""Questions about the plan, and what answers them.

``answering`` them by what is planned, or when all is over (``ends``); ``gaps`` in it, by what is ``taken``;
where ``rooms`` are; ``leeways`` of what may start earlier, or later; ``stretches`` of time that they name.
"""
