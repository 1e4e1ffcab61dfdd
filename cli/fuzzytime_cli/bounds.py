"""How much one may ask for, however it is said: in options, files, messages, or a conversation."""

MAX_INSTRUCTIONS = 2_000
"""More than a person can have said; a plan of them would take minutes and help nobody."""

MAX_AGENTS = 100

PRIORITIES = (1e-3, 1e3)
"""The least and the most that an instruction may count."""
