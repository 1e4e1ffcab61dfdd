"""What is said better at once.

``corrections`` of times, with ``new_times`` in place of the old, ``corrected_things``, and ``retractions``.
"""
