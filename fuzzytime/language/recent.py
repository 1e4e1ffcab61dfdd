"""What was made last, kept in memory: in a conversation, one text is read for all that it may mean."""

from collections.abc import Hashable, Iterable
from datetime import datetime
from typing import Generic, TypeVar

_Key = TypeVar("_Key", bound=Hashable)
_Made = TypeVar("_Made")


class Recent(Generic[_Key, _Made]):
    """Values by their keys, ``most`` of them: the oldest go. It only ever saves time.

    >>> recent = Recent[str, int](2)
    >>> recent.keep({"one": 1, "two": 2, "three": 3})
    >>> recent.known(["one", "two", "three"])
    {'two': 2, 'three': 3}
    """

    def __init__(self, most: int) -> None:
        self.most = most
        self._kept: dict[_Key, _Made] = {}

    def known(self, keys: Iterable[_Key]) -> dict[_Key, _Made]:
        """Give the values of those keys that are there."""
        return {key: made for key in keys if (made := self._kept.get(key)) is not None}

    def keep(self, made: dict[_Key, _Made]) -> None:
        """Add values, each the newest."""
        for key, value in made.items():
            self._kept.pop(key, None)
            self._kept[key] = value
        # Another thread may add and take away meanwhile.
        for key in list(self._kept)[: -self.most]:
            self._kept.pop(key, None)


def moment_as_typed(now: datetime | None) -> Hashable:
    """Give a moment as a key: one instant in two zones is not the same for words that tell the time there."""
    return None if now is None else (now.replace(tzinfo=None), now.tzinfo, now.fold)
