"""The command that is meant by how it goes: "done", "five more minutes", "not yet", "I'm late"."""

from dataclasses import replace
from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.about_wishes import About, AboutKind, Said
from fuzzytime.times import instant_after, parse_duration, seconds_between
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.repl.naming import all_called, called, entry_of, part_meant, running_one, unknown
from fuzzytime_cli.repl.plain_words.retiming import FOR, some_time, with_time
from fuzzytime_cli.repl.questions.stretches import on_its_day
from fuzzytime_cli.repl.scene import AskedBackError, Scene, check_sole, waiting
from fuzzytime_cli.repl.typed import number_of
from fuzzytime_cli.repl.which import alike
from fuzzytime_cli.repl.without import without_thing
from fuzzytime_cli.session import Entry


def progress(scene: Scene, about: About) -> str | None:
    """Give the command that says how a skill goes: one that is running, or that need not start any more."""
    longer = about.kind is AboutKind.MORE
    last_one = None if longer or not about.text else entry_of(scene, frozenset())
    if last_one is not None:
        # "I already did": what was spoken of last
        about = replace(about, names=frozenset({last_one.identifier}))

    def line(identifier: str) -> str:
        return f":more {identifier} {length_said(scene, about)}" if longer else f":done {identifier}"

    one = running_one(scene, about.names)
    entry = None if longer else entry_of(scene, about.names)
    if entry is not None and (rest := without_thing(scene, entry, about.names)):
        # "Got the milk", of milk and bread
        return f":edit {entry.number} {rest}"
    if one is not None:
        part = None if longer else part_meant(scene, number_of(one.identifier), about.names)
        return line(part or one.identifier)
    last = next(reversed(all_called(scene, about.names)), None)
    if last is not None and longer:
        return line(last.identifier)
    planned_last = entry_of(scene, frozenset()) if longer and not about.names else None
    if (
        planned_last is not None
        and called(scene, planned_last.number) is not None
        and scene.focus is not None
    ):
        return _lengthened(scene, planned_last, about)
    over = "" if last is None else Clock(scene.now, with_seconds=False).at(last.done)
    if not about.names:
        told = "" if last is None else f"; the last, {last.name}, was done at {over}"
        raise FuzzytimeError(f"nothing is running{told}: say what, such as: the soup is done")
    # Of what is called alike the next one is done.
    entry = next((one.entry for one in alike(scene, about.names)), None) or entry_of(scene, about.names)
    planned = None
    if entry is not None:
        planned = part_meant(scene, entry.number, about.names) or called(scene, entry.number)
    if entry is not None and planned is not None:
        if longer:
            # "Make the meeting shorter": by how much is asked
            return _lengthened(scene, entry, about) if about.certain or about.by is None else None
        return line(planned)
    if last is not None:
        raise FuzzytimeError(f"{last.name} was done at {over}")
    return unknown(about.names) if about.certain else None


def running_for(scene: Scene, about: About) -> str | None:
    """Give the command by which what is running takes so long in all: "it takes an hour"; else None."""
    if about.kind not in {AboutKind.TAKES, AboutKind.MOVE} or not about.time.lower().startswith(FOR):
        return None
    entry = entry_of(scene, about.names) if not (about.places or about.upcoming or about.both) else None
    running = scene.conversation.running(scene.now) if scene.tried is None else []
    mine = [one for one in running if entry is not None and number_of(one.identifier) == entry.number]
    length = Said(about.time, scene.now, scene.lexicon).length()
    if len(mine) != 1 or entry is None or length is None or length.rest.words:
        return None
    by = length.seconds - seconds_between(mine[0].start, mine[0].done)
    return f":more {mine[0].identifier} {as_typed(by)}" if by and not waiting(scene, entry.number) else None


def _lengthened(scene: Scene, entry: Entry, about: About) -> str:
    """Give the command that lets what has not started take longer: perhaps one of several things of a line.

    Raises
    ------
    FuzzytimeError
        If it would take no time, or which of several things is meant is not said.
    """
    by = parse_duration(length_said(scene, about))
    part = part_meant(scene, entry.number, about.names)
    if part is None:
        check_sole(scene, entry.number, as_typed(by))
    left = [one for _, one in waiting(scene, entry.number) if part in {None, one.identifier}]
    lasts = max(one.skill.time_until_done for one in left)
    if lasts + by <= 0:
        raise FuzzytimeError(f"it takes {as_typed(lasts)}, and cannot be {as_typed(-by)} shorter")
    if part is None:
        return f":duration {entry.number} {as_typed(lasts + by)}"
    length = About(kind=AboutKind.MOVE, time=f"for {as_typed(lasts + by)}")
    return f":edit {entry.number} {with_time(scene, entry, length, part=part)}"


def unstarted(scene: Scene, about: About) -> str:
    """Give the command that plans anew what was taken to have started.

    Raises
    ------
    FuzzytimeError
        If nothing that is meant has started, or which of several is not said.
    """
    done = scene.taken is not None and scene.taken.kind is AboutKind.DONE
    if about.text and done and scene.focus is not None and called(scene, scene.focus) is None:
        # What was taken to be done is not planned any more.
        return ":undo"
    last = entry_of(scene, frozenset()) if about.text else None
    if last is not None:
        # "No, not yet": what was spoken of last
        about = replace(about, names=frozenset({last.identifier}))
    one = running_one(scene, about.names) or next(reversed(all_called(scene, about.names)), None)
    if one is None or (about.text and last is not None and called(scene, last.number) is not None):
        entry = entry_of(scene, about.names)
        planned = None if entry is None else called(scene, entry.number)
        raise FuzzytimeError(
            f"{planned} is still planned" if planned and about.names else "nothing is running"
        )
    number = number_of(one.identifier)
    text = next(entry.text for entry in scene.conversation.state.entries if entry.number == number)
    return f":edit {number} {text}"


def late(scene: Scene, about: About) -> str:
    """Give the command that keeps who is late from everything for so long."""
    if about.by is None:
        message = (
            "by how much? Say: I'm ten minutes late (nothing starts before then), "
            "or: push everything back by ten minutes"
        )
        raise AskedBackError(message, about)
    busy = [one for one in scene.conversation.running(scene.now) if one.end > scene.now]
    if len(busy) == 1:
        return f":more {busy[0].identifier} {as_typed(about.by)}"
    return _busy(scene, scene.now, instant_after(scene.now, about.by), "late")


def blocked(scene: Scene, about: About) -> str:
    """Give the command that keeps everything from a stretch of time: "keep the afternoon free"."""
    first, end = on_its_day(scene, about.time)
    first = max(scene.now, first or scene.now)
    if end is None or end <= first:
        raise FuzzytimeError(f"{about.time!r} is over, or has no end: say from when to when")
    return _busy(scene, first, end, about.thing or "kept free")


def _busy(scene: Scene, first: datetime, end: datetime, why: str) -> str:
    begin, until = (
        f"{'' if one.date() == scene.now.date() else f'{one:%Y-%m-%d}T'}{one:%H:%M:%S}"
        for one in (first, end)
    )
    return f":busy {begin} {until} {why}"


def length_said(scene: Scene, about: About) -> str:
    """Give by how much, as a command takes it.

    Raises
    ------
    AskedBackError
        If that is not said.
    """
    if about.by is None and about.text:
        by = some_time(scene, about.text)
        return as_typed(-by if about.earlier else by)
    if about.by is None:
        raise AskedBackError(length_asked(about), replace(about, certain=True))
    return as_typed(about.by)


def length_asked(about: About) -> str:
    """Ask by how much something is to be later, earlier, longer or shorter."""
    if about.kind is AboutKind.MORE:
        return f"by how much? Say: twenty minutes {'shorter' if about.earlier else 'longer'}"
    way = "bring it forward" if about.earlier else "push it back"
    return f"by how much? Say: {way} by ten minutes (or: make it half past six)"


def as_typed(length: float) -> str:
    """Give a length as a command takes it."""
    whole, rest = divmod(abs(length), 60.0)
    return f"{'-' if length < 0 else ''}{f'{whole:g}min' if not rest else f'{abs(length):g}s'}"
