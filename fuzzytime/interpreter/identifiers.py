"""Identifiers of skills, each of its own."""

from collections import Counter
from dataclasses import dataclass, field

from fuzzytime.interpreter.request import SpokenWish, Wish


@dataclass(slots=True)
class Identifiers:
    """The identifiers that are taken, and how many skills each wish has so far."""

    taken: set[str]
    seen: Counter[str] = field(default_factory=Counter)

    def of(self, wish: Wish) -> str:
        """Give a skill of a wish an identifier of its own: the wish's, and further ones eggs.2, eggs.3."""
        name = wish.identifier
        parts = wish.parts if isinstance(wish, SpokenWish) else ()
        place, self.seen[name] = self.seen[name], self.seen[name] + 1
        number = parts[place] if place < len(parts) else max(parts, default=0) + place - len(parts) + 1
        if number == 1:
            return name
        name = f"{name}.{number}"
        while name in self.taken:
            name += "'"
        self.taken.add(name)
        return name
