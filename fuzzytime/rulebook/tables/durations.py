"""How long operations take, where nobody says it: a table by verb and object."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from fuzzytime.english import PLACING, singular_forms
from fuzzytime.errors import FuzzytimeError
from fuzzytime.rulebook.tables.matching import verbs_of


@dataclass(frozen=True, slots=True, kw_only=True)
class OperationDuration:
    """Seconds that an operation keeps the agent busy, and until it is done.

    ``assumed`` says that nobody said it: it comes from a table. ``known`` says that the table has a row for
    the verb; otherwise it is the default for anything. ``worked`` says that it only dries by itself
    when the work is over, so that a length that is said is that of the work. ``needed_for`` are the verbs
    that wait until it is done where several things are done in a row; without any, all do.
    """

    hands_on: float
    elapsed: float
    source: str
    assumed: bool = True
    known: bool = True
    worked: bool = False
    needed_for: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not 0 <= self.hands_on <= self.elapsed < float("inf"):
            raise FuzzytimeError(
                f"hands-on time must lie between 0 and the elapsed time, got {self.hands_on:g} s "
                f"of {self.elapsed:g} s"
            )


Key = tuple[str, str | None]
"""A verb's lemma, and a word of its object or None for any object."""


@dataclass(frozen=True, slots=True)
class Begun:
    """What is only begun by hand, and goes on by itself: seconds at most, and times those at least.

    ``verbs`` put or leave a thing somewhere, so that for how long is said of the thing.
    """

    hands_on: float
    times: float
    verbs: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Durations:
    """Rows by verb and object word, the default, and what is only begun by hand."""

    rows: Mapping[Key, OperationDuration] = field(default_factory=lambda: MappingProxyType({}))
    default: OperationDuration | None = None
    begun: Begun | None = None
    in_passing: float | None = None
    """How many times as long as it takes the time between is at least, for what is repeated in passing."""

    def overridden(self, by: "Durations") -> "Durations":
        """Give these rows with another's laid over them."""
        rows = MappingProxyType({**self.rows, **by.rows})
        return Durations(
            rows, by.default or self.default, by.begun or self.begun, by.in_passing or self.in_passing
        )

    def left_alone(self, row: OperationDuration, length: float, verb: str | None = None) -> float | None:
        """Give the hands-on seconds of what goes on by itself for so many seconds; None where it does not.

        "Put the dish in the oven for an hour" needs hands only to put it there: with its ``verb``, a thing is
        left somewhere for a length. Without, the length was told apart: "the loaves need 40 minutes".
        """
        if self.begun is None:
            return None
        hands_on = min(row.hands_on, self.begun.hands_on)
        if verb is None:
            alone = row.known and hands_on == row.hands_on
        else:
            alone = not self.begun.verbs.isdisjoint(verbs_of(verb))
        return hands_on if alone and length >= self.begun.times * hands_on else None

    def of(self, lemma: str | None, thing: str | None) -> OperationDuration:
        """Give the row for a verb and its object: the object's own, the verb's, the default.

        The last word of an object counts most: a "tomato soup" is a soup. A phrasal verb is looked up whole
        ("turn on"), then by its first word.

        Raises
        ------
        FuzzytimeError
            If no table gives a default.
        """
        for verb in verbs_of(lemma):
            for word in (*_words(thing), None):
                row = self.rows.get((verb, word))
                if row is not None:
                    return row
        if self.default is None:
            raise FuzzytimeError("durations must have a default")
        return self.default


def _words(thing: str | None) -> tuple[str, ...]:
    """Give an object's words in the order in which they count, each as it stands and in the singular.

    Whole phrases come first, then the words from the last on; what follows "of" comes after what stands
    before it ("the lid of the pot", "a cup of coffee"), and what follows another preposition is a place.
    """
    said = re.findall(r"[^\W\d_]+(?:['\u2019-][^\W\d_]+)*", (thing or "").lower())
    place = next((i for i, word in enumerate(said) if i and word in PLACING), len(said))
    found: list[str] = []
    for part in _parts(said[:place]):
        for start in range(len(part)):
            found += [" ".join([*part[start:-1], form]) for form in singular_forms(part[-1])]
        for word in reversed(part[:-1]):
            found += singular_forms(word)
    return tuple(dict.fromkeys(found))


def _parts(words: list[str]) -> list[list[str]]:
    """Split a phrase at "of"; no part is empty."""
    parts: list[list[str]] = [[]]
    for word in words:
        if word == "of":
            parts.append([])
        else:
            parts[-1].append(word)
    return [part for part in parts if part]
