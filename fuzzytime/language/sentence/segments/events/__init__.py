"""What goes on beside what is to be done: ``named_events``, ``event_edges``.

Several of one kind with a time each are ``instances``.
"""
