"""The command that plain words about what was asked for mean."""

from dataclasses import replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language import About, AboutKind, content_words
from fuzzytime_cli.formats.clock import Clock
from fuzzytime_cli.repl.naming import all_called, called, entries_meant, entry_of, running_one, unknown
from fuzzytime_cli.repl.retiming import with_time
from fuzzytime_cli.repl.scene import Scene, number_of

ONE_AT_A_TIME = "one at a time, such as: move the call to six; or: push everything back by an hour"


def command_meant(scene: Scene, about: About) -> str | None:
    """Give the command that is meant, as it would be typed; None where it may be a wish of its own.

    Raises
    ------
    FuzzytimeError
        If nothing that is known can be meant, or which of several is not said.
    """
    match about.kind:
        case AboutKind.UNDO | AboutKind.REDO:
            return f":{about.kind.value}"
        case AboutKind.DONE | AboutKind.MORE:
            return _progress(scene, about)
        case AboutKind.LATE:
            return _late(scene, about)
        case AboutKind.SWAP:
            return _swap(scene, about)
        case AboutKind.UNSTARTED:
            return _unstarted(scene, about)
    return _changing(scene, about)


def _changing(scene: Scene, about: About) -> str | None:
    """Give the command that drops, moves or delays what is meant."""
    if about.everything and about.kind is AboutKind.MOVE:
        raise FuzzytimeError(ONE_AT_A_TIME)
    if about.everything:
        return _dropping_all(scene, about) if about.kind is AboutKind.DROP else f":delay all {_length(about)}"
    if about.corrects and scene.told_last is not None:
        scene = replace(scene, focus=scene.told_last)
    meant = entries_meant(scene, about)
    if not meant:
        return unknown(about.names) if about.certain else None
    if about.text and about.text in content_words(meant[-1].text):
        return None
    numbers = ",".join(str(entry.number) for entry in meant)
    match about.kind:
        case AboutKind.DROP:
            return f":drop {numbers}"
        case AboutKind.DELAY:
            return f":delay {numbers} {_length(about)}"
        case _ if len(meant) == 1:
            return f":edit {numbers} {with_time(scene, meant[0], about)}"
    raise FuzzytimeError(ONE_AT_A_TIME)


def _dropping_all(scene: Scene, about: About) -> str:
    """Give the command that drops everything, but for what is named."""
    if not about.names:
        return ":drop all"
    kept = entries_meant(scene, replace(about, several=True)) or unknown(about.names)
    left = [str(entry.number) for entry in scene.conversation.state.entries if entry not in kept]
    if not left:
        raise FuzzytimeError("nothing else is asked for")
    return f":drop {','.join(left)}"


def _length(about: About) -> str:
    """Give by how much, as a command takes it.

    Raises
    ------
    FuzzytimeError
        If that is not said.
    """
    if about.by is None:
        raise FuzzytimeError("by how much? Say: push it back by ten minutes (or: make it half past six)")
    return _seconds(about.by)


def _seconds(length: float) -> str:
    whole, rest = divmod(abs(length), 60.0)
    return f"{'-' if length < 0 else ''}{f'{whole:g}min' if not rest else f'{abs(length):g}s'}"


def _progress(scene: Scene, about: About) -> str | None:
    """Give the command that says how a skill goes: one that is running, or that need not start any more."""
    longer = about.kind is AboutKind.MORE

    def line(identifier: str) -> str:
        return f":more {identifier} {_length(about)}" if longer else f":done {identifier}"

    one = running_one(scene, about.names)
    if one is not None:
        return line(one.identifier)
    last = next(reversed(all_called(scene, about.names)), None)
    if last is not None and longer:
        return line(last.identifier)
    over = "" if last is None else Clock(scene.now, with_seconds=False).at(last.done)
    if not about.names:
        told = "" if last is None else f"; the last, {last.name}, was done at {over}"
        raise FuzzytimeError(f"nothing is running{told}: say what, such as: the soup is done")
    entry = entry_of(scene, about.names)
    planned = None if entry is None else called(scene, entry.number)
    if planned is not None:
        return None if longer and not about.certain else line(planned)
    if last is not None:
        raise FuzzytimeError(f"{last.name} was done at {over}")
    return unknown(about.names) if about.certain else None


def _unstarted(scene: Scene, about: About) -> str:
    """Give the command that plans anew what was taken to have started.

    Raises
    ------
    FuzzytimeError
        If nothing that is meant has started, or which of several is not said.
    """
    one = running_one(scene, about.names)
    if one is None:
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
        raise FuzzytimeError(
            "by how much? Say: I'm ten minutes late (nothing starts before then), "
            "or: push everything back by ten minutes"
        )
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
