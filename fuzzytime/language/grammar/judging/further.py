"""Times that go on with another and could not stand alone: "at seven and nine", "on the 1st and 15th"."""

from collections.abc import Sequence

from fuzzytime.language.grammar.chart import Cell, Piece
from fuzzytime.language.grammar.judging.beside.cuts import Cuts
from fuzzytime.language.grammar.judging.beside.doses import Doses
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.meaning.calendar import Fields, is_day_of_month
from fuzzytime.language.meaning.expressions import Range, Said, Wall, wall_of

JOINTS = frozenset({"and", "or", ",", "then"})
"""What joins times of the same thing."""

ENDS = frozenset({"", ".", "!", ";", ","})
"""What may stand behind a number that is then: "at nine then five", not "at nine, then five eggs"."""


class Further(Standing):
    """What stands behind times that were chosen, and goes on with them."""

    def __init__(self, around: Surroundings) -> None:
        super().__init__(around)
        self.cuts, self.doses = Cuts(around), Doses(around)

    def continued(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the number behind a clock time and "and" or "or": "at seven and nine"."""
        time = piece.value.time
        place = piece.end + 1
        if not isinstance(time, (Wall, Range)) or place >= len(self.words):
            return []
        if isinstance(time, Range):
            return self._further_stretches(piece, cells, chosen) or self._further_days(piece, cells, chosen)
        if time.clock is None:
            return self._further_days(piece, cells, chosen)
        run_on = self.run_on.behind(time.clock, piece.end) if _is_open(piece) else []
        if run_on:
            return [p for first, end in run_on for p in _clock_from(cells[first], end)]
        joint, place = self._joined(piece.end)
        if not joint or place >= len(self.words) or any(one.start == place for one in chosen):
            return []
        if self.doses.count(place):
            return []
        numbers = [p for p in cells[place].get("said", {}).values() if isinstance(p.value.time, Wall)]
        if self.measures.is_sure(place) and self.measures.is_sure(piece.end - 1):
            # "At 1400 and 2200": no year
            clocks = cells[place].get("clock", {}).values()
            numbers = [p._replace(category="said", value=Said(Wall(clock=p.value))) for p in clocks]
        found = [p for p in numbers if _is_open(p) and self.around.may_end(p) and not self.cuts.runs_on(p)][
            :1
        ]
        # "One tablet at eight and one at noon"
        found = [p for p in found if not any(one.start == p.end and _is_clocked(one) for one in chosen)]
        if joint == "," and found and self.around.follower(found[0]) not in {",", "and", "or"}:
            return []
        if joint == "then" and found and self.around.follower(found[0]) not in ENDS:
            return []
        return found + [more for one in found for more in self.continued(one, cells, chosen)]

    def _further_stretches(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the stretch of hours behind another: "from 9 to 12 and 1 to 5"."""
        joint, place = self._joined(piece.end)
        if not joint or place >= len(self.words) or any(one.start == place for one in chosen):
            return []
        hours = cells[place].get("hours open", {}).values() if _has_hours(piece) else ()
        found = [p._replace(category="said") for p in hours if _has_hours(p) and self.around.may_end(p)][:1]
        return found + [more for one in found for more in self._further_stretches(one, cells, chosen)]

    def _joined(self, place: int) -> tuple[str, int]:
        """Give what joins a further time at a place, and where that begins: "or" of "at nine, or | ten"."""
        joint = ""
        for text in self.texts[place:]:
            if text not in JOINTS or (joint and joint != "," and text != "then"):
                break
            joint, place = text, place + 1
        return joint, place

    def before(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the typed day of a month in front of another: "the play 25th & 26th at seven"."""
        place = piece.start - 1
        joined = place > 2 and self.texts[place] in JOINTS - {"then"} and _is_dated(piece)
        typed = joined and self.texts[place - 1] in self.beside.ordinal_endings
        if not typed or self.texts[place - 3] in self.closed.noun_openers:
            # "Hang the 2nd & 3rd at six"
            return []
        if any(one.end >= place for one in chosen if one.start < place):
            return []
        said = (p for p in cells[place - 2].get("said", {}).values() if p.end == place)
        found = [p for p in said if _is_day_of_month(p) and isinstance(p.value.time, Wall)][:1]
        return found + [more for one in found for more in self.before(one, cells, chosen)]

    def _further_days(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the days of a month behind another: "on the 1st and 15th", "on the 3rd, 10th and 17th"."""
        place = piece.end + 1
        listed = self.around.follower(piece) in {"and", "or", ","} and _is_day_of_month(piece)
        if not listed or place >= len(self.words) or any(one.start == place for one in chosen):
            return []
        found = [
            p
            for p in cells[place].get("said", {}).values()
            if _is_day_of_month(p) and isinstance(p.value.time, Wall) and self.around.may_end(p)
        ][:1]
        return found + [more for one in found for more in self._further_days(one, cells, chosen)]


def _clock_from(cell: Cell, end: int) -> list[Piece]:
    """Give the clock time in a cell that ends at a place."""
    said = (p for p in cell.get("said", {}).values() if p.end == end and isinstance(p.value.time, Wall))
    return [p for p in said if _is_open(p)][:1]


def _is_open(piece: Piece) -> bool:
    """Whether it is a number alone, or two that a full stop joins: "12.30"."""
    clock = piece.value.time.clock
    return piece.value.time.bare or (clock is not None and clock.pair and piece.value.preposition is None)


def _is_dated(piece: Piece) -> bool:
    """Whether it is on a day of a month: "26th july"."""
    days = piece.value.wall.days
    return isinstance(days, Fields) and days.day is not None


def _is_day_of_month(piece: Piece) -> bool:
    """Whether it is on a day of some month, and no other is said: "15th", "from two to ten on the 14th"."""
    time = piece.value.time
    return is_day_of_month(wall_of(time.first if isinstance(time, Range) else time).days)


def _has_hours(piece: Piece) -> bool:
    """Whether it is from one time of day to another."""
    time = piece.value.time
    ends = (time.first, time.last) if isinstance(time, Range) else ()
    return bool(ends) and all(wall_of(end).clock is not None for end in ends)


def _is_clocked(piece: Piece) -> bool:
    """Whether it is a time of day."""
    return piece.value.wall.clock is not None
