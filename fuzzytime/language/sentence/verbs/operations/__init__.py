"""What is to be done (``operations``): a verb with its ``particles``, and ``amounts``."""
