"""Commands of the conversation that give what is asked for another time: later, earlier, each other's."""

from collections.abc import Sequence
from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import Language
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import format_duration, instant_after, parse_duration
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.scene import Reply, Scene, begun_of, ended_line, is_for_others, step, waiting
from fuzzytime_cli.repl.typed import got, number_and_rest, number_of, several_numbers
from fuzzytime_cli.session import Entry, State

ALL = "all"

Waiting = Sequence[tuple[int, Interpreted]]
"""Skills that have not started, with their places in the plan."""


def delay(scene: Scene, text: str) -> Reply:
    """Move an instruction, several ("1,3"), or all that have not started; a negative length is earlier."""
    first, _, rest = text.strip().partition(" ")
    if rest.strip() and (several := several_numbers(first)):
        return _all_later(scene, parse_duration(rest), several)
    if first.lower() == ALL and rest.strip():
        return _all_later(scene, parse_duration(rest))
    number, rest = number_and_rest(text, "a length of time, such as 10min,")
    by = parse_duration(rest)
    entry = scene.conversation.state.entry(number)
    begun = begun_of(scene, number)
    if begun is not None:
        # It does not start now, but then; what has started does not move, so that it is another.
        moved_by = entry.moved_by + by
        to = max(instant_after(begun.start, by), scene.now)
        changes = {"moved_by": moved_by, "moved_to": to}
        reply = step(scene, _what(number, by), lambda state: state.with_another(number, **changes))
        return replace(reply, lines=(*ended_line(scene, begun), *reply.lines))
    mine = waiting(scene, number)
    if not mine:
        raise FuzzytimeError(f"nothing of instruction {number} is planned")
    if _follows(scene, mine, waiting(scene)):
        raise FuzzytimeError(
            f"instruction {number} follows another one's time: move that, or use :edit {number}"
        )
    moved = _moved(scene, entry, by, mine)
    return step(scene, _what(number, by), lambda state: _with(state, (moved,)))


def _what(number: int | str, by: float) -> str:
    return f":delay {number} {format_duration(by)}"


def _all_later(scene: Scene, by: float, numbers: Sequence[int] = ()) -> Reply:
    """Move all that has not started, or some of it; what is told to happen stays, and is named."""
    entries, stays, left = [], [], waiting(scene)
    chosen = [scene.conversation.state.entry(number) for number in numbers]
    for entry in chosen or scene.conversation.state.entries:
        mine = [(place, one) for place, one in left if one.wish.identifier == entry.identifier]
        # What only has its name ("lunch at one") may be chosen; when the guests come is theirs to say.
        if any((is_for_others(one) if chosen else one.stated) for _, one in mine):
            stays.append(f"{entry.number} ({mine[0][1].skill.name})")
        elif mine and not _follows(scene, mine, left):
            entries.append(_moved(scene, entry, by, mine))
    if not entries:
        raise FuzzytimeError("nothing is left that could be moved")
    what = _what(",".join(map(str, numbers)) or ALL, by)
    reply = step(scene, what, lambda state: _with(state, tuple(entries)))
    told = f"not moved, since it was told, not asked for: {', '.join(stays)}"
    return replace(reply, lines=(Text(plain(told)), *reply.lines)) if stays else reply


def _follows(scene: Scene, mine: Waiting, left: Waiting) -> bool:
    """Whether some skills have no time of their own but follow others that are left: they move along."""
    places = {place for place, _ in left}
    bound = {entry.second for entry in scene.plan.schedule.task.precedences if entry.first in places}
    happening = {one.identifier for _, one in left}
    bound |= {place for place, one in mine if not happening.isdisjoint(one.tied_to)}
    return all(place in bound and not _has_time(one) for place, one in mine)


def _has_time(one: Interpreted) -> bool:
    return any(part.anchor is None or part.anchor.target is None for part in one.requirements)


def _moved(scene: Scene, entry: Entry, by: float, mine: Waiting) -> Entry:
    """Give an entry moved by some seconds, from where it is planned.

    Raises
    ------
    FuzzytimeError
        If it would have to start before now.
    """
    schedule = scene.plan.schedule
    starts = [
        scene.plan.instant(schedule.start_times[place]) for place, _ in mine if scene.plan.has_time(place)
    ]
    to = instant_after(starts[0], by) if len(starts) == 1 else None
    if to is not None and to < scene.now:
        name = plain(mine[0][1].skill.name)
        at = Clock(scene.now, with_seconds=False).at(to)
        raise FuzzytimeError(f"{name} would have to start at {at}, which is over")
    return replace(entry, moved_by=entry.moved_by + by, moved_to=to)


def _with(state: State, entries: tuple[Entry, ...]) -> State:
    """Give the state with some entries as they are now."""
    for entry in entries:
        state = state.with_changed(entry.number, moved_by=entry.moved_by, moved_to=entry.moved_to)
    return state


def swap(scene: Scene, text: str) -> Reply:
    """Give two instructions each other's times."""
    numbers = [number_of(part) for part in text.split()]
    if len(numbers) != 2 or numbers[0] == numbers[1]:
        raise FuzzytimeError(f"two numbers must follow, such as: :swap 1 2{got(text)}")
    one, other = (scene.conversation.state.entry(number) for number in numbers)
    for entry in (one, other):
        if not waiting(scene, entry.number):
            raise FuzzytimeError(f"nothing of instruction {entry.number} is left to do")
    times = [_time_of(entry, scene.language) for entry in (one, other)]
    if times == [None, None]:
        message = f"neither says a time: say what comes first, such as: do {_name(scene, one)} first"
        raise FuzzytimeError(message)
    changed = (_with_time_of(one, other, times), _with_time_of(other, one, times[::-1]))

    def swapped(state: State) -> State:
        for entry in changed:
            kept = {name: getattr(entry, name) for name in ("text", "given", "moved_by", "moved_to")}
            state = state.with_changed(entry.number, **kept)
        return state

    return step(scene, f":swap {numbers[0]} {numbers[1]}", swapped)


def _name(scene: Scene, entry: Entry) -> str:
    return plain(next((one.skill.name for _, one in waiting(scene, entry.number)), entry.text))


def _time_of(entry: Entry, language: Language) -> TimeRequirement | None:
    """Give the one time that an entry says.

    Raises
    ------
    FuzzytimeError
        If it says several, or one that counts from another instruction.
    """
    reading = language.read(entry.text, now=entry.given)
    parts = [part for one in reading.instructions for part in one.requirements]
    times = [part for part in parts if part.constraint is not Constraint.FOR]
    if len(times) > 1 or any(part.anchor is not None for part in times):
        raise FuzzytimeError(f"instruction {entry.number} says more than a time: say it anew, with :edit")
    return times[0] if times else None


def _with_time_of(entry: Entry, other: Entry, times: list[TimeRequirement | None]) -> Entry:
    """Give an entry with the time of another in place of its own; both times are given."""
    own, new = times
    text = entry.text
    first, end = own.span if own is not None else (len(text.rstrip(".! ")),) * 2
    front = f"{text[:first].rstrip()} {new.text if new is not None else ''}".strip()
    words = f"{front}{text[end:]}".strip(" ,")
    return replace(entry, text=words, given=other.given, moved_by=other.moved_by, moved_to=other.moved_to)
