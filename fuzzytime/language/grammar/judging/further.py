"""Times that go on with another and could not stand alone: "at seven and nine", "on the 1st and 15th"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from fuzzytime.language.grammar.chart import Cell, Piece
from fuzzytime.language.grammar.judging.beside.cuts import Cuts
from fuzzytime.language.grammar.judging.beside.doses import Doses
from fuzzytime.language.grammar.judging.standing import Standing
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.meaning.calendar import Fields, is_day_of_month
from fuzzytime.language.meaning.expressions import HourMark, Range, Said, Wall, wall_of
from fuzzytime.language.meaning.joined.beside import joined

ENDS = frozenset({"", ".", "!", ";", ","})
"""What may stand behind a number that is then: "at nine then five", not "at nine, then five eggs"."""


DAY_NAMED = "further.numbered_days"
"""The rule of a day of the month that only a list makes one."""


class Further(Standing):
    """What stands behind times that were chosen, and goes on with them."""

    def __init__(self, around: Surroundings) -> None:
        super().__init__(around)
        self.cuts, self.doses = Cuts(around), Doses(around)

    def listed(self, chosen: Sequence[Piece], cells: Sequence[Cell]) -> list[Piece]:
        """Give times with those that go on with them; what lies in one of these is no time of its own."""
        found = list(chosen)
        for piece in chosen:
            further = [*self._behind(piece, cells, found), *self.before(piece, cells, found)]
            starts = {one.start for one in found}
            # "At nine, three and six on friday"
            further = [one for one in further if one.start not in starts]
            places = {place for one in further for place in range(one.start, one.end)}
            found = [one for one in found if one.start not in places] + further
        return found

    def _behind(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the members of the list that a time begins, or goes on with: "at seven | and | nine"."""
        clock = wall_of(piece.value.time).clock
        run_on = self.run_on.behind(clock, piece.end) if _is_open(piece) else []
        if run_on:
            return [p for first, end in run_on for p in _clock_from(cells[first], end)]
        joint, place = self._joined(piece.end)
        if not joint or place >= len(self.words) or any(one.start == place for one in chosen):
            return []
        members = (p for p in self._members(piece, place, cells, chosen) if self._goes_on(p, joint))
        one = next(members, None)
        if one is None:
            return []
        more = self._behind(one, cells, chosen)
        if joint != "," or more or _is_whole(one):
            return [one, *more]
        # "At seven, nine and again at six"; but "on the first, third and fifth skewers"
        behind = self._joined(one.end)[1]
        return [one] if any(other.start == behind for other in chosen) else []

    def _members(
        self, piece: Piece, place: int, cells: Sequence[Cell], chosen: Sequence[Piece]
    ) -> Iterator[Piece]:
        """Give the times at a place that may go on with one of their kind, the longest in front."""
        said = sorted(cells[place].get("said", {}).values(), key=lambda p: -p.end)
        if _is_day_of_month(piece):
            yield from (p for p in said if _is_day_of_month(p) and isinstance(p.value.time, Wall))
            yield from self._numbered_days(place, cells, chosen)
        elif isinstance(piece.value.time, Range):
            hours = cells[place].get("hours open", {}).values() if _has_hours(piece) else ()
            yield from (p._replace(category="said") for p in hours if _has_hours(p))
        elif _is_clocked(piece) or _is_mark(piece):
            yield from (p for p in said if _is_mark(p))
        yield from _other_halves(piece, cells[place])
        if not (_is_clocked(piece) or _is_mark(piece)) or self.doses.count(place):
            return
        numbers = (p for p in said if isinstance(p.value.time, Wall))
        if self.measures.is_sure(place) and self.measures.is_sure(piece.end - 1):
            # "At 1400 and 2200": no year
            clocks = cells[place].get("clock", {}).values()
            numbers = (p._replace(category="said", value=Said(Wall(clock=p.value))) for p in clocks)
        # "One tablet at eight and one at noon"
        behind = {one.start for one in chosen if _is_clocked(one)}
        yield from (p for p in numbers if _is_open(p) and p.end not in behind)

    def _numbered_days(self, place: int, cells: Sequence[Cell], chosen: Sequence[Piece]) -> Iterator[Piece]:
        """Give a day of the month that is a word alone, at the hour behind it: "and fifteenth at six"."""
        more = self.lexicon.ordinals.keys() | self.closed.joints_of_times | {"last"}
        behind = next((at for at in range(place, len(self.texts)) if self.texts[at] not in more), place)
        # "On the second, fourth and last friday"
        days = () if self.around.is_weekday(behind) else cells[place].get("month day", {}).values()
        for day in days:
            if self.texts[day.end - 1] not in self.lexicon.ordinals:
                continue
            wall, end = Wall(Fields(day=day.value)), day.end
            clocked = next((one for one in chosen if one.start == end and _is_clocked(one)), None)
            timed = None if clocked is None else joined(wall, wall_of(clocked.value.time))
            if clocked is not None and timed is not None:
                wall, end = timed, clocked.end
            yield Piece("said", place, end, Said(wall), day.weight, DAY_NAMED)

    def _goes_on(self, piece: Piece, joint: str) -> bool:
        """Whether what stands behind a member of a list lets it be one."""
        if not self.around.may_end(piece) or self.cuts.runs_on(piece):
            return False
        listed = joint != "," or self.around.follower(piece) in self.closed.coordinators
        return listed or _is_whole(piece)

    def _joined(self, place: int) -> tuple[str, int]:
        """Give what joins a further time at a place, and where that begins: "or" of "at nine, or | ten"."""
        joint, joints = "", self.closed.joints_of_times
        for text in self.texts[place:]:
            again = joint and text in self.beside.again
            if not again and (text not in joints or (joint and joint != "," and text != "then")):
                break
            joint, place = text if text in joints else joint, place + 1
        return joint, place

    def before(self, piece: Piece, cells: Sequence[Cell], chosen: Sequence[Piece]) -> list[Piece]:
        """Give the typed day of a month in front of another: "the play 25th & 26th at seven"."""
        place = piece.start - 1
        joined = place > 2 and self.texts[place] in self.closed.coordinators and _is_dated(piece)
        typed = joined and self.texts[place - 1] in self.beside.ordinal_endings
        if not typed or self.texts[place - 3] in self.closed.noun_openers:
            # "Hang the 2nd & 3rd at six"
            return []
        if any(one.end >= place for one in chosen if one.start < place):
            return []
        said = (p for p in cells[place - 2].get("said", {}).values() if p.end == place)
        found = [p for p in said if _is_day_of_month(p) and isinstance(p.value.time, Wall)][:1]
        return found + [more for one in found for more in self.before(one, cells, chosen)]


def _other_halves(piece: Piece, cell: Cell) -> Iterator[Piece]:
    """Give the further half of the day, or the part of it, that a time is in: "at eight am and pm"."""
    time = piece.value.time
    wall = wall_of(time.first if isinstance(time, Range) else time)
    clock = wall.clock
    if clock is not None and wall.part is not None:
        parts = (p for p in cell.get("part", {}).values() if not p.value.is_point and not p.value.meal)
        yield from (p._replace(category="said", value=Said(Wall(part=p.value))) for p in parts)
    if clock is not None and clock.half is not None and isinstance(time, Wall):
        for half in cell.get("meridiem", {}).values():
            yield half._replace(
                category="said", value=Said(replace(time, clock=replace(clock, half=half.value)))
            )


def _clock_from(cell: Cell, end: int) -> list[Piece]:
    """Give the clock time in a cell that ends at a place."""
    said = (p for p in cell.get("said", {}).values() if p.end == end and isinstance(p.value.time, Wall))
    return [p for p in said if _is_open(p)][:1]


def _is_whole(piece: Piece) -> bool:
    """Whether a comma alone may stand before it: a typed day of the month, "on the 1st, 15th", a stretch."""
    return (piece.rule != DAY_NAMED and _is_day_of_month(piece)) or isinstance(piece.value.time, Range)


def _is_open(piece: Piece) -> bool:
    """Whether it is a number alone, or two that a full stop joins: "12.30"."""
    wall = piece.value.wall
    return wall.bare or (wall.clock is not None and wall.clock.pair and piece.value.preposition is None)


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


def _is_mark(piece: Piece) -> bool:
    """Whether it is some minutes past an hour that is not said, or to it: "quarter past"."""
    time = piece.value.time
    return isinstance(time, HourMark) and time.open
