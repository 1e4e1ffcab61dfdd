"""Days that are none of others: "at six unless it's sunday"."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Days, Today
from fuzzytime.requirement import Unit


@dataclass(frozen=True, slots=True)
class SparedDays(Calendar):
    """Every day that lies in no period of some series."""

    others: tuple[Calendar, ...]

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give days in ascending order."""
        return (days for days in Cycle(Unit.DAY).upcoming(today, since) if self._is_spared(today, days))

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give days in descending order."""
        return (days for days in Cycle(Unit.DAY).past(today, until) if self._is_spared(today, days))

    def _is_spared(self, today: Today, days: Days) -> bool:
        found = (next(other.upcoming(today, days.first), None) for other in self.others)
        return not any(other is not None and other.first <= days.first < other.end for other in found)
