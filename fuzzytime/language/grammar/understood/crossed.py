"""Days and times of day in a list of times: each day has all the times that are said with it.

"Monday and friday at six and sunday at ten", "at eleven on tuesday and thursday", "tuesday and
thursday at six and eight".
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from fuzzytime.language.meaning.expressions import Phrase, Range, Said, Wall, wall_of
from fuzzytime.requirement import Unit

SEVERAL = 2


def crossed(
    members: Sequence[Phrase], ends_with_day: Callable[[Phrase], bool], *, either: bool
) -> list[Phrase]:
    """Give each day of a list the times said behind it, in front of it, or else of the days before.

    Of days of which ``either`` will do, a part of the last is of all: "saturday or sunday morning".
    """
    found: list[Phrase] = []
    times: list[Phrase] = []
    for group in _groups(members, ends_with_day):
        days = [member for member in group if is_listed(first_of(member.said))]
        times = [member for member in group if first_of(member.said).is_timed] or times
        alone = any(not first_of(day.said).is_timed for day in days)
        several = len(days) >= SEVERAL or (alone and len(group) == 1)
        held = all(member in days or member in times for member in group)
        found += _pairs(days, times) if several and held and _are_given(times, either=either) else group
    return _of_one_half(found)


def first_of(said: Said) -> Wall:
    """Give the time of day that something is at, or from."""
    return wall_of(said.time.first if isinstance(said.time, Range) else said.time)


def is_listed(wall: Wall) -> bool:
    """Whether it is on a day, as a list may have several."""
    return wall.days is not None and wall.days.grain is Unit.DAY


def _groups(members: Sequence[Phrase], ends_with_day: Callable[[Phrase], bool]) -> Iterator[list[Phrase]]:
    """Give stretches of a list in which days stand in front of their times, or else all behind them."""
    first = next((one for one in members if is_listed(first_of(one.said))), members[0])
    behind = first is not members[0] or ends_with_day(first)
    group: list[Phrase] = []
    for member in members:
        dated, timed = is_listed(first_of(member.said)), first_of(member.said).is_timed
        walls = [first_of(other.said) for other in group]
        whole = any(map(is_listed, walls)) if behind else any(wall.is_timed for wall in walls)
        if whole and (timed if behind else dated):
            yield group
            group = []
        group.append(member)
    yield group


def _are_given(times: Sequence[Phrase], *, either: bool) -> bool:
    """Whether times are those of all days beside them, as "saturday and sunday morning" are not."""
    walls = [first_of(time.said) for time in times]
    clocked = [wall for wall in walls if wall.clock is not None]
    ranges = (time.said.time for time in times if isinstance(time.said.time, Range))
    lasting = all(isinstance(one.last, Wall) for one in ranges)
    parts = (either or len(walls) >= SEVERAL) and not clocked
    return lasting and any(map(is_listed, walls)) and (parts or len(clocked) == len(walls))


def _pairs(days: Sequence[Phrase], times: Sequence[Phrase]) -> Iterator[Phrase]:
    """Give each of some days at each of some times."""
    for day in days:
        for time in times:
            if day is time:
                yield day
                continue
            told = time if first_of(day.said).is_timed else day
            yield replace(told, said=_on(first_of(day.said), time.said, told.said))


def _on(day: Wall, giver: Said, said: Said) -> Said:
    """Give the time of day, or the hours, of one day on another, as words for it say."""
    time = giver.time
    first = replace(first_of(giver), days=day.days)
    if isinstance(time, Range) and isinstance(time.last, Wall):
        last = time.last if time.last.days is None else replace(time.last, days=day.days)
        return replace(giver, time=Range(first, last), preposition=said.preposition)
    return replace(said, time=first)


def _of_one_half(members: Sequence[Phrase]) -> list[Phrase]:
    """Let days with the same clock time have it in the same half of the day."""
    walls = [first_of(member.said) for member in members]
    found = []
    for member, wall in zip(members, walls, strict=True):
        alike = (one.days for one in walls if one.days is not None and one.clock == wall.clock)
        others = tuple(days for days in alike if days != wall.days)
        said = member.said
        if wall.clock is None or not wall.clock.is_open or wall.days is None or not others:
            found.append(member)
        elif isinstance(said.time, Range):
            found.append(member.at(replace(said.time, first=replace(wall, others=others))))
        else:
            found.append(member.at(replace(wall, others=others)))
    return found
