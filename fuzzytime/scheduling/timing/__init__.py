"""From an order to start times: in slots, and in continuous time."""
