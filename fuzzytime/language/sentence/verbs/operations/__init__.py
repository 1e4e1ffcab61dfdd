"""What is to be done (``operations``): a verb with its ``particles`` and ``verb_words``, and ``amounts``."""
