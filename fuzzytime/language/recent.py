"""What was made last, kept in memory: in a conversation, one text is read for all that it may mean."""

from collections.abc import Callable, Hashable, Iterable
from datetime import datetime
from functools import wraps
from typing import Generic, ParamSpec, TypeVar

_Asked = ParamSpec("_Asked")
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


def remembering(most: int) -> Callable[[Callable[_Asked, _Made]], Callable[_Asked, _Made]]:
    """Have a function of texts, moments and tables keep the values that it made last.

    >>> @remembering(64)
    ... def shouted(text: str, now: datetime) -> str:
    ...     print("made")
    ...     return text.upper()
    >>> [shouted("now", datetime(2026, 3, 4)) for _ in range(2)]
    made
    ['NOW', 'NOW']
    """

    def decorated(function: Callable[_Asked, _Made]) -> Callable[_Asked, _Made]:
        recent = Recent[Hashable, tuple[_Made]](most)

        @wraps(function)
        def remembered(*values: _Asked.args, **named: _Asked.kwargs) -> _Made:
            asked = (*values, *named.keys(), *named.values())
            key = tuple(moment_as_typed(one) if isinstance(one, datetime) else one for one in asked)
            known = recent.known([key]).get(key)
            if known is None:
                known = (function(*values, **named),)
                recent.keep({key: known})
            return known[0]

        return remembered

    return decorated
