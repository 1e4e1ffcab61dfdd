"""What looks like a time and is part of none: ``leftovers``, ``countdowns``, but not ``called_things``."""
