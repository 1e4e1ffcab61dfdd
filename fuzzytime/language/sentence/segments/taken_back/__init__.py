"""What is said better at once: ``corrections`` of times, and ``corrected_things``."""
