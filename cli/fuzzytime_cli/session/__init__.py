"""A conversation that survives: its state as a value, kept in SQLite with every step undoable.

The ``state``, as a ``document``, in a ``store``.
"""

from fuzzytime_cli.session.document import state_of, state_text
from fuzzytime_cli.session.state import Entry, KeptBusy, KeptRating, KeptReading, Started, State
from fuzzytime_cli.session.store import NotKeptError, SessionStore, damage_of, open_store

__all__ = [
    "Entry",
    "KeptBusy",
    "KeptRating",
    "KeptReading",
    "NotKeptError",
    "SessionStore",
    "Started",
    "State",
    "damage_of",
    "open_store",
    "state_of",
    "state_text",
]
