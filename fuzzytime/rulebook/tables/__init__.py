"""What rule files say, as values, and how they are read."""
