"""What comes before what, one entry after the other, and never in a circle."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from fuzzytime.skills import Precedence


@dataclass(frozen=True, slots=True)
class Before:
    """Which skills come after each, by their positions."""

    after: dict[int, set[int]] = field(default_factory=dict)

    @classmethod
    def of(cls, entries: Iterable[tuple[int, int]]) -> "Before":
        """Give the order of entries that form no circle, each a position and one that comes after it."""
        order = cls()
        for first, second in entries:
            order.after.setdefault(first, set()).add(second)
        return order

    def says(self, first: int, second: int) -> bool:
        """Whether an entry is among those added."""
        return second in self.after.get(first, ())

    def add(self, first: int, second: int) -> bool:
        """Add an entry unless it would close a circle, and say whether it is added."""
        if self._reaches(second, first):
            return False
        self.after.setdefault(first, set()).add(second)
        return True

    def _reaches(self, start: int, end: int) -> bool:
        seen, open_ends = {start}, [start]
        for place in open_ends:
            if place == end:
                return True
            for following in self.after.get(place, set()) - seen:
                seen.add(following)
                open_ends.append(following)
        return False


def free_of_circles(order: Iterable[Precedence], precedences: Iterable[Precedence]) -> tuple[Precedence, ...]:
    """Give the order as far as it agrees with what words say, without what they say already."""
    before = Before.of((entry.first, entry.second) for entry in precedences)
    return tuple(
        entry
        for entry in order
        if not before.says(entry.first, entry.second) and before.add(entry.first, entry.second)
    )
