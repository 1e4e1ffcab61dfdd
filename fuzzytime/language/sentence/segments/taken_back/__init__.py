"""What is said better at once: ``corrections`` of times, with ``new_times``, and ``corrected_things``."""
