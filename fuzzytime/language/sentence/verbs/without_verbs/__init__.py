"""What is said without a verb: ``happenings``, ``named_deeds``, what is ``named_alone``, ``due_by_then``."""
