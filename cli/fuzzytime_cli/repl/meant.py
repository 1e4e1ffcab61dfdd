"""The command that plain words about what was asked for mean."""

from dataclasses import replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import AT_FIRST, AT_ONCE, About, AboutKind, content_words
from fuzzytime_cli.formats.clock import Clock
from fuzzytime_cli.repl.naming import (
    all_called,
    called,
    entries_meant,
    entry_of,
    part_meant,
    running_one,
    unknown,
    words_of_entry,
)
from fuzzytime_cli.repl.retiming import days_on, some_time, with_time, without_thing
from fuzzytime_cli.repl.scene import AskedBackError, Scene, number_of, waiting
from fuzzytime_cli.session import Entry

ONE_AT_A_TIME = "one at a time, such as: move the call to six; or: push everything back by an hour"


def command_meant(scene: Scene, about: About) -> str | None:
    """Give the command that is meant, as it would be typed; None where it may be a wish of its own.

    Raises
    ------
    FuzzytimeError
        If nothing that is known can be meant, or which of several is not said.
    """
    match about.kind:
        case AboutKind.UNDO if about.text and scene.taken is None:
            # "No, leave it", where nothing was changed
            if about.certain:
                raise FuzzytimeError("nothing was changed: it stays as it is")
            return None
        case AboutKind.UNDO | AboutKind.REDO:
            return _undone_report(scene, about) or f":{about.kind.value}"
        case AboutKind.DROP if about.corrects and scene.taken is not None:
            # "Scratch that", of what was changed
            return ":undo"
        case AboutKind.STOP:
            return _stopping(scene, about)
        case AboutKind.REVERSE:
            return _reversing(scene, about)
        case AboutKind.DONE | AboutKind.MORE:
            return _progress(scene, about)
        case AboutKind.LATE:
            return _late(scene, about)
        case AboutKind.SWAP:
            return _swap(scene, about)
        case AboutKind.STARTED:
            return _started(scene, about)
        case AboutKind.UNSTARTED:
            return _unstarted(scene, about)
    return _changing(scene, about)


def _undone_report(scene: Scene, about: About) -> str | None:
    """Give the command that plans anew what was told to be done just before; None where that was not."""
    if about.kind is not AboutKind.UNDO or scene.taken is None or scene.taken.kind is not AboutKind.DONE:
        return None
    known = {entry.number for entry in scene.conversation.state.entries}
    if scene.focus not in known:
        return None
    return _unstarted(scene, replace(about, kind=AboutKind.UNSTARTED, names=frozenset({f"s{scene.focus}"})))


def _changing(scene: Scene, about: About) -> str | None:
    """Give the command that drops, moves or delays what is meant."""
    if about.everything and about.kind is AboutKind.MOVE:
        raise FuzzytimeError(ONE_AT_A_TIME)
    if about.everything:
        if about.kind is AboutKind.DROP:
            return _dropping_all(scene, about)
        return f":delay all {_length(scene, about)}"
    if about.corrects and scene.told_last is not None:
        scene = replace(scene, focus=scene.told_last)
    meant = entries_meant(scene, about)
    if not meant:
        return unknown(about.names) if about.certain else None
    again = about.kind is AboutKind.MOVE and about.text
    if again and about.text in content_words(meant[-1].text):
        return None
    numbers = ",".join(str(entry.number) for entry in meant)
    match about.kind:
        case AboutKind.DROP:
            return _dropping(scene, about, meant)
        case AboutKind.DELAY:
            return f":delay {numbers} {_length(scene, about)}"
        case _ if about.time == AT_FIRST and (other := _of_two(scene, meant[0])) is not None:
            # Two that have their times each take the other's: "do the second one first"
            return f":swap {other} {numbers}"
        case _ if len(meant) == 1 and about.days:
            return f":edit {numbers} {days_on(scene, meant[0], about.days)}"
        case _ if len(meant) == 1:
            return f":edit {numbers} {with_time(scene, meant[0], about)}"
    raise FuzzytimeError(ONE_AT_A_TIME)


def _dropping(scene: Scene, about: About, meant: list[Entry]) -> str:
    """Give the command that forgets what is meant: of "clean the hall and the kitchen", perhaps the hall."""
    numbers = ",".join(str(entry.number) for entry in meant)
    if len(meant) == 1 and (part := part_meant(scene, meant[0].number, about.names)):
        # "Forget the roses", of "water the roses, then mow the lawn"
        return f":done {part}"
    rest = without_thing(scene, meant[0], about.names) if len(meant) == 1 else ""
    return f":edit {numbers} {rest}" if rest else f":drop {numbers}"


def _of_two(scene: Scene, entry: Entry) -> int | None:
    """Give the number of the other of two that are left; None where there are others, or one has no time."""
    left = [one for one in scene.conversation.state.entries if called(scene, one.number) is not None]
    timed = all(
        one.requirements and all(part.anchor is None for part in one.requirements)
        for one in scene.plan.everything
    )
    others = [one.number for one in left if one is not entry and one.number != entry.number]
    return others[0] if timed and len(others) == 1 else None


def _dropping_all(scene: Scene, about: About) -> str:
    """Give the command that drops everything, but for what is named."""
    if not about.names:
        return ":drop all"
    kept = entries_meant(scene, replace(about, several=True)) or unknown(about.names)
    left = [str(entry.number) for entry in scene.conversation.state.entries if entry not in kept]
    if not left:
        raise FuzzytimeError("nothing else is asked for")
    return f":drop {','.join(left)}"


def _length(scene: Scene, about: About) -> str:
    """Give by how much, as a command takes it.

    Raises
    ------
    AskedBackError
        If that is not said.
    """
    if about.by is None and about.text:
        by = some_time(scene, about.text)
        return _seconds(-by if about.earlier else by)
    if about.by is None:
        message = "by how much? Say: push it back by ten minutes (or: make it half past six)"
        raise AskedBackError(message, about)
    return _seconds(about.by)


def _stopping(scene: Scene, about: About) -> str | None:
    """Give the command that ends what is running, or else forgets what is named, or was spoken of last."""
    one = running_one(scene, about.names)
    if one is not None:
        return f":done {one.identifier}"
    entry = entry_of(scene, about.names)
    if entry is None:
        return None if about.names else unknown(frozenset())
    return f":drop {entry.number}"


def _reversing(scene: Scene, about: About) -> str | None:
    """Give the command that changes the order of two back, or the other way round."""
    if scene.taken is not None and scene.taken.kind in {AboutKind.SWAP, AboutKind.MOVE}:
        return ":undo"
    return _swap(scene, replace(about, both=True))


def _seconds(length: float) -> str:
    whole, rest = divmod(abs(length), 60.0)
    return f"{'-' if length < 0 else ''}{f'{whole:g}min' if not rest else f'{abs(length):g}s'}"


def _progress(scene: Scene, about: About) -> str | None:
    """Give the command that says how a skill goes: one that is running, or that need not start any more."""
    longer = about.kind is AboutKind.MORE
    last_one = None if not about.text else entry_of(scene, frozenset())
    if last_one is not None:
        # "I already did": what was spoken of last
        about = replace(about, names=frozenset({last_one.identifier}))

    def line(identifier: str) -> str:
        return f":more {identifier} {_length(scene, about)}" if longer else f":done {identifier}"

    one = running_one(scene, about.names)
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
        return _lengthened(scene, planned_last.number, about)
    over = "" if last is None else Clock(scene.now, with_seconds=False).at(last.done)
    if not about.names:
        told = "" if last is None else f"; the last, {last.name}, was done at {over}"
        raise FuzzytimeError(f"nothing is running{told}: say what, such as: the soup is done")
    entry = entry_of(scene, about.names)
    planned = None
    if entry is not None:
        planned = part_meant(scene, entry.number, about.names) or called(scene, entry.number)
    if planned is not None:
        if longer:
            return _lengthened(scene, number_of(planned), about) if about.certain else None
        return line(planned)
    if last is not None:
        raise FuzzytimeError(f"{last.name} was done at {over}")
    return unknown(about.names) if about.certain else None


def _lengthened(scene: Scene, number: int, about: About) -> str:
    """Give the command that lets what has not started take longer."""
    if about.by is None:
        raise AskedBackError("by how much? Say: twenty minutes longer", about)
    lasts = max(one.skill.time_until_done for _, one in waiting(scene, number))
    return f":duration {number} {_seconds(lasts + about.by)}"


def _started(scene: Scene, about: About) -> str | None:
    """Give the command that has start now what somebody says to have started.

    Raises
    ------
    FuzzytimeError
        If it is taken to be running already.
    """
    one = running_one(scene, about.names)
    if one is not None:
        until = Clock(scene.now, with_seconds=True).at(one.done)
        raise FuzzytimeError(f"{one.name} has started, and is running until {until}")
    return _changing(scene, replace(about, kind=AboutKind.MOVE, time=AT_ONCE))


def _unstarted(scene: Scene, about: About) -> str:
    """Give the command that plans anew what was taken to have started.

    Raises
    ------
    FuzzytimeError
        If nothing that is meant has started, or which of several is not said.
    """
    known = {entry.number for entry in scene.conversation.state.entries}
    done = scene.taken is not None and scene.taken.kind is AboutKind.DONE
    if about.text and done and scene.focus is not None and scene.focus not in known:
        # What was taken to be done is not asked for any more.
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


def _late(scene: Scene, about: About) -> str:
    """Give the command that keeps who is late from everything for so long."""
    if about.by is None:
        message = (
            "by how much? Say: I'm ten minutes late (nothing starts before then), "
            "or: push everything back by ten minutes"
        )
        raise AskedBackError(message, about)
    busy = [one for one in scene.conversation.running(scene.now) if one.end > scene.now]
    if len(busy) == 1:
        return f":more {busy[0].identifier} {_seconds(about.by)}"
    from fuzzytime.times import instant_after

    until = instant_after(scene.now, about.by)
    day = "" if until.date() == scene.now.date() else f"{until:%Y-%m-%d}T"
    return f":busy {scene.now:%H:%M:%S} {day}{until:%H:%M:%S} late"


def _swap(scene: Scene, about: About) -> str | None:
    if about.both:
        left = [one for one in scene.conversation.state.entries if called(scene, one.number) is not None]
        left = [one for one in left if about.names <= words_of_entry(scene, one)]
        if len(left) != 2:
            raise FuzzytimeError("which two? Say: swap the call and the soup")
        return f":swap {left[0].number} {left[1].number}"
    found = [entry_of(scene, names) for names in (about.names, about.others)]
    if found[0] is None and found[1] is None:
        return None
    for entry, names in zip(found, (about.names, about.others), strict=True):
        if entry is None:
            return unknown(names)
    return f":swap {' '.join(str(entry.number) for entry in found if entry is not None)}"
