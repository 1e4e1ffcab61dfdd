"""Commands of the conversation that give what is asked for another time: later, earlier, each other's."""

from dataclasses import replace

from rich.text import Text

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import Interpreted
from fuzzytime.language import Language
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.times import format_duration, instant_after, parse_duration
from fuzzytime_cli.render import plain
from fuzzytime_cli.repl.scene import (
    Reply,
    Scene,
    begun_of,
    ended_line,
    is_waiting,
    number_and_rest,
    number_of,
    step,
)
from fuzzytime_cli.session import Entry, State

ALL = "all"


def delay(scene: Scene, text: str) -> Reply:
    """Move an instruction, or all that have not started, by a length of time; a negative one is earlier."""
    first, _, rest = text.strip().partition(" ")
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
    if not _skills(scene, number):
        raise FuzzytimeError(f"nothing of instruction {number} is planned")
    if _follows(scene, number):
        raise FuzzytimeError(
            f"instruction {number} follows another one's time: move that, or use :edit {number}"
        )
    moved = _moved(scene, entry, by)
    return step(scene, _what(number, by), lambda state: _with(state, (moved,)))


def _what(number: int | str, by: float) -> str:
    return f":delay {number} {format_duration(by)}"


def _all_later(scene: Scene, by: float) -> Reply:
    """Move everything that has not started; what is told to happen then stays, and is named."""
    entries, stays = [], []
    for entry in scene.conversation.state.entries:
        skills = _skills(scene, entry.number)
        if any(one.operation is not None and one.operation.stated for one in skills):
            stays.append(f"{entry.number} ({skills[0].skill.name})")
        elif skills and not _follows(scene, entry.number):
            entries.append(_moved(scene, entry, by))
    if not entries:
        raise FuzzytimeError("nothing is left that could be moved")
    reply = step(scene, _what(ALL, by), lambda state: _with(state, tuple(entries)))
    told = f"not moved, since it was told, not asked for: {', '.join(stays)}"
    return replace(reply, lines=(Text(plain(told)), *reply.lines)) if stays else reply


def _skills(scene: Scene, number: int) -> list[Interpreted]:
    skills = (one for one in scene.plan.skills if one.wish.identifier == f"s{number}")
    return [one for one in skills if is_waiting(scene, one)]


def _follows(scene: Scene, number: int) -> bool:
    """Whether an instruction has no time of its own but follows another that waits: it moves along."""
    waiting = [one.identifier for one in _skills(scene, number)]
    bound = {
        entry.second
        for entry in scene.plan.schedule.task.precedences
        if is_waiting(scene, scene.plan.skills[entry.first])
    }

    def follows(position: int, one: Interpreted) -> bool:
        own = any(part.anchor is None or part.anchor.target is None for part in one.requirements)
        return position in bound and not own

    mine = [(place, one) for place, one in enumerate(scene.plan.skills) if one.identifier in waiting]
    return all(follows(place, one) for place, one in mine)


def _moved(scene: Scene, entry: Entry, by: float) -> Entry:
    """Give an entry moved by some seconds, from where it is planned.

    Raises
    ------
    FuzzytimeError
        If it would have to start before now.
    """
    schedule, waiting = scene.plan.schedule, _skills(scene, entry.number)
    starts = [
        scene.plan.instant(schedule.start_times[position])
        for position, one in enumerate(scene.plan.skills)
        if one in waiting and not schedule.rejected[position]
    ]
    to = instant_after(starts[0], by) if len(starts) == 1 else None
    if to is not None and to < scene.now:
        name = plain(waiting[0].skill.name)
        raise FuzzytimeError(f"{name} would have to start at {to:%H:%M}, which is over")
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
        raise FuzzytimeError(f"two numbers must follow, such as: :swap 1 2, got {text.strip()!r}")
    one, other = (scene.conversation.state.entry(number) for number in numbers)
    for entry in (one, other):
        if not _skills(scene, entry.number):
            raise FuzzytimeError(f"nothing of instruction {entry.number} is left to do")
    language = scene.conversation.interpreter.language
    times = [_time_of(entry, language) for entry in (one, other)]
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
    skills = _skills(scene, entry.number)
    return plain(skills[0].skill.name if skills else entry.text)


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
