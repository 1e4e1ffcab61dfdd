"""What is said without a verb: ``happenings``, ``named_deeds``, what is ``named_alone``.

What is ``put_there``, or must be so (``due_by_then``).
"""
