"""What was typed at the prompt, kept in a file of the person's own."""

from contextlib import suppress
from pathlib import Path

from prompt_toolkit.history import FileHistory, History, InMemoryHistory


class _Kept(FileHistory):
    """A history that goes on without its file where the disk is full."""

    def store_string(self, string: str) -> None:
        with suppress(OSError):
            super().store_string(string)


def kept_history(path: Path) -> History:
    """Give the history in a file that only its owner may read; where there can be none, one in memory."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch(mode=0o600)
    except OSError:
        return InMemoryHistory()
    return _Kept(str(path))
