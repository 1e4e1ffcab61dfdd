"""The state of a conversation as a value."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from datetime import datetime
from typing import Any

from fuzzytime.errors import FuzzytimeError


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """One instruction of the conversation, with the moment it was given, and how it was moved since.

    ``moved_by`` are seconds, and ``moved_to`` the start it was moved to (`fuzzytime.interpreter.Moved`);
    ``parts`` number what it still asks for, where it asked for more (`fuzzytime.interpreter.SpokenWish`).
    """

    number: int
    text: str
    given: datetime
    hands_on: float | None = None
    elapsed: float | None = None
    priority: float = 1.0
    moved_by: float = 0.0
    moved_to: datetime | None = None
    parts: tuple[int, ...] = ()

    @property
    def identifier(self) -> str:
        """The label that it is called by: "s2"."""
        return f"s{self.number}"


@dataclass(frozen=True, slots=True)
class KeptReading:
    """A reading with its instant; an event has no value."""

    signal: str
    at: datetime
    value: float | None = None
    unit: str | None = None


@dataclass(frozen=True, slots=True)
class KeptBusy:
    """A time that is taken, by instants."""

    start: datetime
    end: datetime
    what: str = ""


@dataclass(frozen=True, slots=True)
class Started:
    """A skill that has started, or that ``happens`` by itself: it does not move any more."""

    identifier: str
    name: str
    start: datetime
    end: datetime
    done: datetime
    agent: int = 1
    satisfaction: float = 1.0
    happens: bool = False


@dataclass(frozen=True, slots=True)
class KeptRating:
    """What a person thought of a start: of which skill at which instant, and the rating as JSON."""

    identifier: str
    name: str
    start: datetime
    rating: str


@dataclass(frozen=True, slots=True, kw_only=True)
class State:
    """Everything that was said in a conversation, as a value.

    An instruction may refer to those before it in ``entries``; one that is said anew keeps its place.
    ``agents`` says how many can work at once, ``in_order`` whether each instruction is done after the one
    before; None leaves that to the settings.
    """

    entries: tuple[Entry, ...] = ()
    next_number: int = 1
    readings: tuple[KeptReading, ...] = ()
    busy: tuple[KeptBusy, ...] = ()
    agents: int | None = None
    in_order: bool | None = None
    solver: str = ""
    finished: tuple[str, ...] = field(default=())
    ratings: tuple[KeptRating, ...] = ()

    def with_entry(self, text: str, given: datetime) -> "State":
        """Give the state with one more instruction."""
        entry = Entry(number=self.next_number, text=text, given=given)
        return replace(self, entries=(*self.entries, entry), next_number=self.next_number + 1)

    def with_entries(self, texts: Iterable[str], given: datetime) -> "State":
        """Give the state with more instructions, given at one moment."""
        state = self
        for text in texts:
            state = state.with_entry(text, given)
        return state

    def entry(self, number: int) -> Entry:
        """Find an instruction by its number.

        Raises
        ------
        FuzzytimeError
            If there is none.
        """
        for entry in self.entries:
            if entry.number == number:
                return entry
        known = ", ".join(str(entry.number) for entry in self.entries) or "none yet"
        raise FuzzytimeError(f"a number must be one of the list ({known}), got {number}")

    def with_changed(self, number: int, **changes: Any) -> "State":  # noqa: ANN401 - the fields of Entry
        """Give the state with one instruction changed."""
        self.entry(number)
        entries = (replace(entry, **changes) if entry.number == number else entry for entry in self.entries)
        return replace(self, entries=tuple(entries))

    def with_another(self, number: int, **changes: Any) -> "State":  # noqa: ANN401 - the fields of Entry
        """Give the state with a new instruction in the place of one, which it equals but for some changes."""
        old = self.entry(number)
        another = replace(old, number=self.next_number, **changes)
        entries = (another if entry is old else entry for entry in self.entries)
        return replace(self, entries=tuple(entries), next_number=self.next_number + 1)

    def with_last(self, number: int) -> "State":
        """Give the state with an instruction behind all others."""
        last = self.entry(number)
        return replace(self, entries=(*(entry for entry in self.entries if entry is not last), last))

    def without(self, number: int) -> "State":
        """Give the state without one instruction."""
        dropped = self.entry(number)
        return replace(self, entries=tuple(entry for entry in self.entries if entry is not dropped))

    def with_rating(self, kept: KeptRating) -> "State":
        """Give the state with a rating, in the place of an earlier one of the same start."""
        same = (kept.identifier, kept.start)
        others = (one for one in self.ratings if (one.identifier, one.start) != same)
        return replace(self, ratings=(*others, kept))
