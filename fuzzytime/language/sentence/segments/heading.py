"""A time on a line of its own, which those below it have."""

from dataclasses import dataclass

from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.meaning.expressions import Phrase, Repeat, wall_of
from fuzzytime.language.sentence.clauses.clause import Clause

HEADED = "heading"
"""The rule of a time that a line above says."""


@dataclass(frozen=True, slots=True)
class Heading:
    """A time on a line of its own: its name, the line, and the times and clauses in it.

    ``addressee`` is who is called there instead: "Robot 2:". Its line ``happens`` where it tells of what goes
    on then, too: "Night shift Friday 21:00-07:00".
    """

    name: str
    text: str
    scanned: Scanned
    phrases: tuple[Phrase, ...] = ()
    clauses: tuple[Clause, ...] = ()
    addressee: str | None = None
    happens: bool = False

    @property
    def day(self) -> Phrase | None:
        """The day, part of a day or repetition of days that it says first, if any."""
        return next((phrase for phrase in self.phrases if phrase.said.is_day), None)

    @property
    def is_day(self) -> bool:
        """Whether it says which day is meant."""
        time = None if self.day is None else self.day.said.time
        return isinstance(time, Repeat) or wall_of(time).days is not None
