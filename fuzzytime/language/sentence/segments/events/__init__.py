"""What goes on beside what is to be done: ``named_events``, ``event_edges``, what is ``prepared_for`` it.

Several of one kind with a time each are ``instances``.
"""
