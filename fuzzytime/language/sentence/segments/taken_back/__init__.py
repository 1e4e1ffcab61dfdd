"""What is said better at once: ``corrections`` of times, ``corrected_things``, and ``retractions``."""
