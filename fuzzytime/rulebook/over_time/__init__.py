"""What a context tells over time, and how true a condition is at each moment."""
