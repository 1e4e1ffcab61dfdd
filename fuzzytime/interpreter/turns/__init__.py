"""What is done again and again beside something else.

``inside`` of what goes on, ``behind`` what comes before, with ``each_turn`` of another, or once ``of_each``.
Turns that others keep from their time are ``passing``; ``turns_in_bounds`` end with something, and those
without an end last for the ``waking_hours``. Those that are ``planned`` lie within the horizon.
"""
